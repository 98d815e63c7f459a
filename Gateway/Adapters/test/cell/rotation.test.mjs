// Compares rotations computed from three angles or from a rotation vector with products of rotation matrices.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { seeded } from '../seeded.mjs';

const { ofAngles, ofVector, unit } = await parts('cell/rotation');

const about = {
  x: a => [[1, 0, 0], [0, Math.cos(a), -Math.sin(a)], [0, Math.sin(a), Math.cos(a)]],
  y: a => [[Math.cos(a), 0, Math.sin(a)], [0, 1, 0], [-Math.sin(a), 0, Math.cos(a)]],
  z: a => [[Math.cos(a), -Math.sin(a), 0], [Math.sin(a), Math.cos(a), 0], [0, 0, 1]],
};
const times = (a, b) => a.map(row => row.map((_, j) => row.reduce((sum, value, k) => sum + value * b[k][j], 0)));
const matrixOf = ([x, y, z, w]) => [
  [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
  [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
  [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
];
const isClose = (a, b) => a.flat().forEach((value, i) => assert.ok(Math.abs(value - b.flat()[i]) < 1e-12, `${a} is not ${b}`));

describe('rotation', () => {
  const random = seeded(22);
  const angles = () => [0, 1, 2].map(() => (2 * random() - 1) * Math.PI);
  for (const order of ['xyz', 'zyx', 'xzy', 'yxz', 'yzx', 'zxy', 'zyz', 'xyx'])
    it(`OfAngles_${order}_EqualsTheProductOfThreeMatrices`, () => {
      for (let i = 0; i < 50; i++) {
        const three = angles();
        const [first, second, third] = three.map((angle, k) => about[order[k]](angle));

        isClose(matrixOf(ofAngles(three, order, true)), times(third, times(second, first)));
        isClose(matrixOf(ofAngles(three, order, false)), times(first, times(second, third)));
      }
    });

  it('OfVector_AnyVector_RotatesAboutTheVectorByItsLength', () => {
    for (let i = 0; i < 50; i++) {
      const [a, b, angle] = angles();
      // Turns the z axis to a direction, rotates about this direction, and turns back.
      const onto = times(about.z(a), about.y(b)), back = times(about.y(-b), about.z(-a)), axis = onto.map(row => row[2]);

      isClose(matrixOf(ofVector(axis.map(part => part * angle))), times(onto, times(about.z(angle), back)));
    }
    isClose([ofVector([0, 0, 0])], [[0, 0, 0, 1]]);
    isClose([ofVector([2e-10, 0, 0])], [[1e-10, 0, 0, 1]]);
  });

  it('OfAngles_FixedAxes_EqualMovingAxesInReverseOrder', () => {
    const [a, b, c] = angles();

    isClose([ofAngles([a, b, c], 'xyz', true)], [ofAngles([c, b, a], 'zyx', false)]);
  });

  it('Unit_RoundedQuaternion_HasLength1', () => {
    const found = unit([0.183, -0.366, 0.549, 0.729]);

    assert.ok(Math.abs(Math.hypot(...found) - 1) < 1e-15);
    assert.deepEqual([unit([0, 0, 0, 0]), unit([0, 0, 0, 1.02]), unit([NaN, 0, 0, 1])], [null, null, null]);
  });
});

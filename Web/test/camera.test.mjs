// Tests that the camera of the 3D view shows all objects, also after objects at wrong positions.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { buildSync } from 'esbuild';
import { Box3, Vector3 } from 'three';

const source = fileURLToPath(new URL('../src/robot/camera.ts', import.meta.url));
const { outputFiles } = buildSync({ entryPoints: [source], bundle: true, write: false, format: 'esm' });
const { OrbitCamera } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

/** A cube with the given edge length around the origin. */
const cube = edge => new Box3().setFromCenterAndSize(new Vector3(), new Vector3(edge, edge, edge));
const opened = () => new OrbitCamera({ addEventListener() {} }, () => {});

describe('the camera', () => {
  for (const edge of [0.2, 2, 60, 200]) it(`shows a cell of ${edge} m completely in a narrow window`, () => {
    const orbit = opened();
    orbit.setAspect(0.5);

    orbit.include(cube(edge));

    orbit.camera.updateMatrixWorld();
    const { min, max } = cube(edge);
    for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) {
      const at = new Vector3(x, y, z).project(orbit.camera);
      assert.ok([at.x, at.y, at.z].every(part => Math.abs(part) <= 1), `${[x, y, z]} at ${at.toArray()}`);
    }
  });

  it('comes closer by the ratio of the distances of two fingers that move apart in any direction', () => {
    const ends = [[1, 0], [0, 1], [0.6, -0.8]].map(([dx, dy]) => {
      const listeners = {};
      const orbit = new OrbitCamera({ addEventListener: (kind, listener) => { listeners[kind] = listener; }, setPointerCapture() {} }, () => {});
      orbit.include(cube(2));
      orbit.setAspect(1);
      const before = orbit.camera.position.length();
      const touch = (kind, pointerId, distance) => listeners[kind]({ pointerId, clientX: 300 + dx * distance, clientY: 300 + dy * distance });
      touch('pointerdown', 1, -50);
      touch('pointerdown', 2, 50);

      for (let distance = 50; distance <= 100; distance += 10) {
        touch('pointermove', 1, -distance);
        touch('pointermove', 2, distance);
      }

      const ratio = orbit.camera.position.length() / before;
      // The camera is not exactly in the direction of the centre, because the corners are centred in the picture.
      assert.ok(Math.abs(ratio - 0.5) < 0.01, `${[dx, dy]}: ${ratio}`);
      return orbit.camera.position;
    });

    for (const end of ends) assert.ok(end.distanceTo(ends[0]) < 1e-9, 'the direction of the fingers has no influence');
  });

  it('comes back to the present objects when it is reset', () => {
    const orbit = opened();
    orbit.include(cube(1));
    const before = orbit.camera.position.length();

    orbit.include(cube(50));
    orbit.include(cube(1));
    assert.ok(orbit.camera.position.length() > 10 * before, 'the larger cube stays visible');
    orbit.reset();
    orbit.include(cube(1));

    assert.equal(orbit.camera.position.length(), before);
  });
});

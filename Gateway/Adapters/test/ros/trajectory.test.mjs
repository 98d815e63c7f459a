// Tests which set-points are forwarded.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';

const { JointNames, passedTrajectory } = await parts('ros/jointNames', 'ros/trajectory');

const JOINTS = [{ joint: 'a', name: 'a', robot: '', scale: 2, offset: 1 }, { joint: 'b', name: 'b', robot: '', scale: 1, offset: 0 }];
const passed = point => passedTrajectory({ header: {}, joint_names: ['a', 'other', 'b'], points: [{ time_from_start: { sec: 1 }, ...point }] }, new JointNames(JOINTS));

describe('set-points', () => {
  it('Derivative_NotANumber_IsNull', () => {
    const { joint_names: names, points } = passed({ positions: [1, 2, 3], velocities: [null, null, 0.5], accelerations: [4, 'x', null] });

    assert.deepEqual([names, points], [
      ['a', 'b'], [{ positions: [3, 3], velocities: [null, 0.5], accelerations: [8, null], time_from_start: { sec: 1 } }],
    ]);
  });

  for (const [name, positions, isPassed] of [
    ['OfAForwardedJointNull', [null, 2, 3], false], ['OfAnotherJointNull', [1, null, 3], true], ['TooLarge', [1e308, 2, 3], false], ['Missing', [1, 2], false],
  ])
    it(`Position_${name}_Is${isPassed ? '' : 'Not'}Forwarded`, () => assert.equal(passed({ positions, velocities: [] }) !== null, isPassed));
});

// Tests in virtual time which parent an object of ROS has in the cell.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell, S } from '../cell/inVirtualTime.mjs';
import { parts } from '../parts.mjs';

const { RosFrames } = await parts('ros/frames');

/** Returns the parent in the cell of an object whose parent in ROS is `source`. */
function parentOf(source, names) {
  const { output, clock, status, sent } = cell({ values: [] }), { now } = clock;
  const frames = ['part', 'pallet'].map(frame => ({ frame, source: `detected_${frame}`, topic: null }));
  const ros = new RosFrames({ frames, world: 'map', namespace: '', linkPrefix: '', ...names }, 10n * S, clock, { publish: (topic, msg) => sent.push(msg) }, status, output.frames.silence);
  const header = { stamp: { sec: Number(now / S), nanosec: Number(now % S) }, frame_id: source };
  ros.pass({ transforms: [{ header, child_frame_id: 'detected_part', transform: { translation: { x: 0, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } } }] });
  return sent[0].transforms[0].header.frame_id;
}

describe('parents in ROS', () => {
  for (const [source, names, expected] of [
    ['map', { namespace: 'arm2' }, 'world'],
    ['detected_pallet', { namespace: 'arm2', linkPrefix: 'detected_' }, 'pallet'],
    ['tool0', {}, 'tool0'],
    ['tool0', { namespace: 'arm2' }, 'arm2/tool0'],
    ['arm2/tool0', { namespace: 'arm2' }, 'arm2/tool0'],
    ['/arm2/tool0', { namespace: 'arm2' }, 'arm2/tool0'],
    ['arm2_tool0', { namespace: 'arm2' }, 'arm2/arm2_tool0'],
    ['right_tool0', { linkPrefix: 'right_' }, 'tool0'],
    ['right_tool0', { namespace: 'arm2', linkPrefix: 'right_' }, 'arm2/tool0'],
    ['left_tool0', { namespace: 'arm2', linkPrefix: 'right_' }, 'arm2/left_tool0'],
    ['arm2/tool0', { linkPrefix: 'arm2/' }, 'tool0'],
  ])
    it(`Parent_${source}With${JSON.stringify(names)}_Is${expected}`, () => assert.equal(parentOf(source, names), expected));
});

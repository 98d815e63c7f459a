// Tests in virtual time which parent an object of ROS has in the cell.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { temporaryFile } from '../temporary.mjs';
import { rosCell } from './frames.mjs';

const { kinds, readConfiguration } = await parts('configuration/configuration', 'kinds');

/** Returns the parent in the cell of an object whose parent in ROS is `source`. */
function parentOf(source, names) {
  const { pass, poses } = rosCell(['part', 'pallet'].map(frame => ({ frame, faultAfterMs: null, maxDeceleration: null })), names);
  pass('part', 0, source);
  return poses()[0].parent;
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

  it('NamesInTheFile_WithALeadingSlash_AreThoseInTheMessages', () => {
    const path = temporaryFile('plant.yaml', `plant: { kind: ros, endpoint: "ws://robot:9090", plain: true, world: /map, link_prefix: /right_ }
frames: [{ frame: part, source: /detected_part }, { frame: pallet }]
`);

    const { frames, world, linkPrefix } = readConfiguration(path, {}, kinds).settings;

    assert.deepEqual([world, linkPrefix, frames.map(({ source }) => source)], ['map', 'right_', ['detected_part', 'pallet']]);
  });
});

// Tests in virtual time that the gateway accepts a message of ROS with many objects: it drops a message that is longer than 64 KiB.
import assert from 'node:assert/strict';
import { it } from 'node:test';
import { rosCell } from './frames.mjs';

it('Pass_256FramesWithLongNamesInOneMessage_AreSentInMessagesOfUpTo64KiB', () => {
  const names = Array.from({ length: 256 }, (_, i) => `${i}`.padEnd(128, 'ä'));
  const { passAll, sent, poses } = rosCell(names.map(frame => ({ frame, faultAfterMs: null, maxDeceleration: null })));

  passAll(names.map((frame, i) => [frame, i / 7, 'ö'.repeat(128)]));

  const lengths = sent.map(([topic, msg]) => Buffer.byteLength(JSON.stringify({ op: 'publish', topic, msg })));
  assert.ok(lengths.every(bytes => bytes <= 64 * 1024), `${lengths}`);
  assert.deepEqual(poses().map(({ frame }) => frame), names);
});

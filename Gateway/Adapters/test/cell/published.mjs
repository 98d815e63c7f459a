// What a complete adapter has published to a test double of the gateway.
import assert from 'node:assert/strict';
import { angle } from '../ads/youbot.mjs';
import { start, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';

/** Starts an adapter. `text` returns the content of its configuration file for the address of the gateway. */
export async function adapterFor(t, text) {
  VirtualTime.ofProcess(t);
  const bridge = await RosbridgeDouble.start(t);
  return { bridge, adapter: start(t, [temporaryFile('plant.yaml', text(bridge.url))]) };
}

export const poses = (bridge, frame) => bridge.published('/tf').flatMap(({ transforms }) => transforms).filter(one => one.child_frame_id === frame);
export const changes = bridge => bridge.published('/signals').map(({ header, value }) => [nanoseconds(header.stamp), value[0]]);
export const posesOf = (bridge, frame, count) => until(() => poses(bridge, frame).length >= count && poses(bridge, frame),
  () => `${count} poses of ${frame}; there are ${poses(bridge, frame).length}, ${JSON.stringify(bridge.state)}`);

/** Whether a time stamp can be the time of arrival of a message. The adapter's clock readings may be wrong by half of a long round-trip time. */
export function isArrival(stamp, sent, seen) {
  const tolerance = 1_000_000_000n;
  return stamp > sent - tolerance && stamp < seen + tolerance;
}

/** Asserts that a pose has the x coordinate and the angle about z that its source had at the time stamp of the pose. */
export function assertPoseMatches({ header, transform: { translation, rotation } }, place, turn, tolerance) {
  const stamp = nanoseconds(header.stamp);
  assert.ok(Math.abs(translation.x - place(stamp)) < tolerance, `x is ${translation.x}, not ${place(stamp)}`);
  const expected = turn(stamp);
  const [z, w] = [Math.sin(expected / 2), Math.cos(expected / 2)];
  assert.ok(Math.abs(Math.abs(rotation.z * z + rotation.w * w) - 1) < tolerance, `z ${rotation.z}, w ${rotation.w}, not ${z}, ${w}`);
}

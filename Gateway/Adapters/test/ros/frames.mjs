// Runs the forwarding of frames from /tf and /tf_static in virtual time.
import { cell, S } from '../cell/inVirtualTime.mjs';
import { parts } from '../parts.mjs';

const { RosFrames } = await parts('ros/frames');

/**
 * Creates the forwarding of frames.
 * @param wholeFrames Settings of the frames. The ROS name of each frame is its name with the prefix "detected_".
 * @param names Names in ROS other than the default ones.
 */
export function rosCell(wholeFrames, names = {}) {
  const one = cell({ wholeFrames, values: [] }), { output, clock, status, gateway } = one;
  const frames = wholeFrames.map(({ frame }) => ({ frame, source: `detected_${frame}`, topic: null }));
  const ros = new RosFrames({ frames, world: 'map', namespace: '', linkPrefix: '', ...names }, 10n * S, clock, gateway, status, output.frames.states);
  const transform = ([frame, x, parent = 'map', child = `detected_${frame}`]) => ({
    header: { stamp: { sec: Number(clock.now / S), nanosec: Number(clock.now % S) }, frame_id: parent },
    child_frame_id: child,
    transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } },
  });
  /** Creates a message with the current poses of frames, each with its frame, x, parent and name in ROS. */
  const message = (...poses) => ({ transforms: poses.map(transform) });
  return {
    ...one, ros,
    describe: urdf => ros.describe(urdf),
    pass: (...pose) => ros.pass(message(pose)),
    passAll: poses => ros.pass(message(...poses)),
    passStationary: (...pose) => ros.passStationary(message(pose)),
  };
}

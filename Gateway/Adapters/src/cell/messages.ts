import { refusalMessages } from '../messages/values';
import type { Refusal } from '../samples/stampRule';
import { type Nanoseconds, toRosTime } from '../times';
import type { Quaternion } from './rotation';

export const TF = '/tf';
export const TF_STATIC = '/tf_static';
export const SIGNALS = '/signals';

/** Gets the key of the kept message with the pose of a frame that another source reports as stationary, and that may begin to move. */
export const stationaryKey = (frame: string): string => `${TF_STATIC} ${frame}`;

/** Maximum number of transforms in a message. With names of 128 characters of 3 bytes, such a message is shorter than 64 KiB. */
const MAX_TRANSFORMS = 48;

/** Maximum number of signals in a message. With names of 128 characters of 6 bytes, such a message is shorter than 64 KiB. */
export const MAX_SIGNALS = 80;

/** Maximum magnitude of a coordinate in m. The gateway leaves out a frame with a larger one. */
const MAX_COORDINATE = 1e6;

/** Refuses a position in m that has a coordinate that is too large; null if it has none. */
export function tooFar(position: readonly number[]): Refusal | null {
  const index = position.findIndex(metres => !(Math.abs(metres) <= MAX_COORDINATE));
  return index < 0 ? null : { reason: 'too-far', text: refusalMessages.tooFar('xyz'[index], position[index]) };
}

/** The pose of a frame in its parent frame: position in m, rotation as a unit quaternion. */
export interface Pose {
  frame: string;
  parent: string;
  position: readonly number[];
  rotation: Quaternion;
}

/** A pose, and the control time at which it was valid. */
export interface StampedPose {
  stamp: Nanoseconds;
  pose: Pose;
}

/** Creates the transform of a pose at a control time. */
export const transform = (stamp: Nanoseconds, { frame, parent, position: [x, y, z], rotation: [qx, qy, qz, qw] }: Pose): object => ({
  header: { stamp: toRosTime(stamp), frame_id: parent },
  child_frame_id: frame,
  transform: { translation: { x, y, z }, rotation: { x: qx, y: qy, z: qz, w: qw } },
});

/** Creates messages with these transforms, each of which is short enough for the gateway. */
export const transformMessages = (transforms: object[]): object[] =>
  Array.from({ length: Math.ceil(transforms.length / MAX_TRANSFORMS) }, (_, i) => ({
    transforms: transforms.slice(i * MAX_TRANSFORMS, (i + 1) * MAX_TRANSFORMS),
  }));

export const signals = (stamp: Nanoseconds, name: string[], value: number[]): object => ({
  header: { stamp: toRosTime(stamp), frame_id: '' },
  name,
  value,
});

import { SIGNALS, TF, TF_STATIC } from '../cell/messages';
import { robotMessages } from '../messages/configuration';
import { type Nanoseconds, ofMilliseconds, toRosTime, unixTimeMs } from '../times';

export const JOINT_STATES = '/joint_states';
export const JOINT_TRAJECTORY = '/joint_trajectory';
export const ROBOT_DESCRIPTION = '/robot_description';
export const DIAGNOSTICS = '/nowpose/diagnostics';

/** The topics on which a gateway lists the joints and signals that are not live. */
export const JOINT_STATUS = '/nowpose/joint_status';
export const SIGNAL_STATUS = '/nowpose/signal_status';

/** The topic on which a gateway publishes its version. */
export const VERSION_TOPIC = '/nowpose/version';

/** Prefixes a topic with the namespace of a robot: `/arm1/joint_states`. Returns the topic unchanged if the namespace is empty. */
export const topicOf = (robot: string, topic: string): string => (robot === '' ? topic : `/${robot}${topic}`);

/** Gets the message type of a topic of the gateway, with or without the namespace of a robot. */
export const typeOf = (topic: string): string | undefined => TYPES[topic] ?? TYPES[topic.replace(/^\/[^/]+/, '')];

const TYPES: Record<string, string> = {
  [JOINT_STATES]: 'sensor_msgs/msg/JointState',
  [JOINT_TRAJECTORY]: 'trajectory_msgs/msg/JointTrajectory',
  [ROBOT_DESCRIPTION]: 'std_msgs/msg/String',
  [TF]: 'tf2_msgs/msg/TFMessage',
  [TF_STATIC]: 'tf2_msgs/msg/TFMessage',
  [SIGNALS]: 'nowpose_msgs/msg/Signals',
  [DIAGNOSTICS]: 'diagnostic_msgs/msg/DiagnosticArray',
  [JOINT_STATUS]: 'diagnostic_msgs/msg/DiagnosticArray',
  [VERSION_TOPIC]: 'std_msgs/msg/String',
  [SIGNAL_STATUS]: 'diagnostic_msgs/msg/DiagnosticArray',
};

export const advertisement = (topic: string): string => JSON.stringify({ op: 'advertise', topic, type: typeOf(topic) });

export const publication = (topic: string, msg: object): string => JSON.stringify({ op: 'publish', topic, msg });

export const subscription = (topic: string, type: string): string =>
  JSON.stringify({ op: 'subscribe', topic, type, queue_length: 0, throttle_rate: 0 });

/** Creates a joint state message for one control time. `velocities` is empty or has one element per joint. */
export const jointState = (stamp: Nanoseconds, names: string[], positions: number[], velocities: number[] = []): object => ({
  header: { stamp: toRosTime(stamp), frame_id: '' },
  name: names,
  position: positions,
  velocity: velocities,
  effort: [],
});

/** Maximum length of a description as a JSON string: the gateway's limit of 1 MiB for the message, less the rest of the message. */
const DESCRIPTION_BYTES = 1024 * 1024 - 256;

/**
 * Gets the reason why a robot description is too long for the gateway; null if it is not.
 * @param source The file or topic of the description.
 */
export function excessOf(source: string, urdf: string): string | null {
  const bytes = Buffer.byteLength(JSON.stringify(urdf));
  return bytes > DESCRIPTION_BYTES ? robotMessages.tooLarge(source, bytes, DESCRIPTION_BYTES) : null;
}

export const description = (urdf: string): object => ({ data: urdf });

/**
 * Creates a diagnostics message. Its stamp is a time of the same clock as the start of each reported state. The gateway uses only the differences.
 * @param level Level of the DiagnosticStatus: 0 ok, 1 warning, 2 error.
 */
export const diagnostics = (name: string, level: 0 | 1 | 2, message: string, values: Record<string, string>): object => ({
  header: { stamp: toRosTime(ofMilliseconds(unixTimeMs())), frame_id: '' },
  status: [{ level, name, message, hardware_id: name, values: Object.entries(values).map(([key, value]) => ({ key, value })) }],
});

/**
 * Matches strings, and the tokens that Python writes for numbers that are not finite. A string without an end matches to the end of the text, because
 * otherwise the time would grow with the square of the length.
 */
const STRING_OR_TOKEN = /"(?:[^"\\]|\\[^])*"?|-?\b(?:NaN|Infinity)\b/g;

/**
 * Parses a JSON object; null if the string is not a JSON object or array. A number that is not finite becomes null: rosbridge writes null for most of
 * these numbers, but NaN, Infinity or -Infinity in an array of fixed length, such as a covariance.
 */
export function parsed(text: string): Record<string, unknown> | null {
  try {
    return objectIn(text);
  } catch {
    // Most messages have no such token, so they are parsed only once.
  }
  try {
    return objectIn(text.replace(STRING_OR_TOKEN, found => (found.startsWith('"') ? found : 'null')));
  } catch {
    return null;
  }
}

function objectIn(text: string): Record<string, unknown> | null {
  const value = JSON.parse(text) as unknown;
  return typeof value === 'object' ? (value as Record<string, unknown> | null) : null;
}

/** Converts any JSON value to a string. String() fails for some objects. */
export const text = (value: unknown): string => (typeof value === 'string' ? value : (JSON.stringify(value) ?? ''));

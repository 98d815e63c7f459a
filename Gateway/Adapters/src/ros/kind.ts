import type { Kind } from '../adapter';
import { requireAddress } from '../configuration/address';
import { readNames } from '../configuration/configuration';
import type { Path, YamlFile } from '../configuration/yamlFile';
import { requirePlain, requireTls } from '../configuration/plain';
import type { RosFrame } from './frames';
import { configurationMessages } from '../messages/configuration';
import { rosMessages } from '../messages/ros';

/** The settings of the kind ros. */
export interface RosSettings {
  endpoint: string;
  pin: string | null;
  isPlain: boolean;
  jointStates: string;
  robotDescription: string | null;
  jointTrajectory: string | null;
  tf: string;
  tfStatic: string;
  frames: RosFrame[];
  /** Message types of the topics with individual values, by topic. */
  types: Map<string, string>;
  /** ROS name of the cell's world frame. */
  world: string;
  /** Namespace of the robot, whose links can be parents of frames; empty if it has none. */
  namespace: string;
  /** The text before the names of the robot's links in ROS; empty if there is none. */
  linkPrefix: string;
  hasClock: boolean;
  /** Maximum deceleration of joints that the file does not list; null if unknown. */
  maxDeceleration: number | null;
}

/** Gets a frame's name without the leading slash that ROS 1 allowed, and that its tools print. */
export const bare = (name: unknown): string => (typeof name === 'string' ? name.replace(/^\//, '') : '');

/** Gets the name of a message type in the form of ROS 1, which the rosbridge of ROS 2 also accepts; undefined if the entry is missing or invalid. */
const ros1TypeOf = (type: string | undefined): string | undefined => type?.replace('/msg/', '/');

export const ros: Kind<'ros', RosSettings> = {
  // The topic and its type are entries of the frame.
  address: ['field'],
  check(file, { plant, frames = [] }, { joints, values }) {
    const { endpoint, pin, plain, topics } = plant;
    requireAddress(file, ['plant', 'endpoint'], endpoint);
    requirePlain(file, plant);
    if (pin !== undefined) requireTls(file, ['plant'], endpoint);
    // If the source is invalid, the name is not the source either.
    const known = (path: Path, source: string): string | undefined => (file.isInvalid([...path, 'source']) ? undefined : source);
    const names = frames.map(({ frame, source = frame }, i) => known(['frames', i], bare(source)));
    frames.forEach(({ source, topic, position }, i) => {
      if (source !== undefined && names.indexOf(bare(source)) < i)
        file.report(['frames', i, 'source'], configurationMessages.valueTwice(source, 'frame'));
      if (source !== undefined && position !== undefined && !file.isInvalid(['frames', i, 'position']))
        file.report(['frames', i, 'source'], rosMessages.sourceAndPosition);
      const isRead = values.some(({ path: [section, index] }) => section === 'frames' && index === i);
      if (isRead && topic === undefined) file.report(['frames', i, 'topic'], rosMessages.noTopic);
    });
    const sources = joints.map(({ name, source = name }, i) => known(['joints', i], source));
    sources.forEach((source, i) => {
      if (source !== undefined && sources.indexOf(source) < i) file.report(['joints', i], rosMessages.sourceTwice(source));
    });
    joints.forEach(({ source, topic }, i) => {
      if (source !== undefined && topic !== undefined) file.report(['joints', i, 'source'], rosMessages.sourceAndTopic);
    });
    requireOneType(file, [
      ...values.map(({ path, address: { topic, type } }) => ({ path, topic, type })),
      ...frames.map(({ topic, type }, i) => ({ path: ['frames', i], topic, type })),
    ]);
    return {
      endpoint,
      pin: pin ?? null,
      isPlain: plain === true && endpoint.startsWith('ws:'),
      jointStates: topics.joint_states,
      robotDescription: topics.robot_description === false ? null : topics.robot_description,
      jointTrajectory: topics.joint_trajectory ?? null,
      tf: topics.tf,
      tfStatic: topics.tf_static,
      frames: frames
        .filter(({ position }) => position === undefined)
        .map(({ frame, source = frame, topic = null, type }) => ({ frame, source: bare(source), topic, type: ros1TypeOf(type) })),
      types: new Map(values.flatMap(({ address: { topic, type } }) => (topic === undefined ? [] : [[topic, ros1TypeOf(type)!]]))),
      world: bare(plant.world),
      namespace: plant.namespace ?? '',
      linkPrefix: bare(plant.link_prefix),
      hasClock: plant.clock,
      maxDeceleration: plant.max_deceleration ?? null,
    };
  },
  passesUnlisted: ({ joints }) => joints.length === 0,
  offersClock: ({ hasClock }) => hasClock,
  summary(configuration) {
    const { endpoint, jointStates, hasClock, frames } = configuration.settings;
    return `rosbridge ${endpoint}, ${jointStates}, ${hasClock ? 'with its clock' : 'without its clock'}, ${readNames(configuration, 'all joints')}${frames.length === 0 ? '' : `; frames ${frames.map(({ frame }) => frame).join(', ')}`}`;
  },
};

/** Reports a topic that is configured with two types. The ROS 1 name of a type and its ROS 2 name with /msg/ count as equal. */
function requireOneType(file: YamlFile, entries: { path: Path; topic?: string; type?: string }[]): void {
  const seen = new Map<string, { path: Path; type: string }>();
  for (const { path, topic, type } of entries) {
    if (topic === undefined || type === undefined) continue;
    const first = seen.get(topic);
    if (first === undefined) seen.set(topic, { path, type });
    else if (ros1TypeOf(first.type) !== ros1TypeOf(type))
      file.report([...path, 'type'], rosMessages.twoTypes(type, file.lineOf([...first.path, 'type']), first.type, topic));
  }
}

import type { Kind } from '../adapter';
import { requireAddress } from '../configuration/address';
import { type Configuration, readNames } from '../configuration/configuration';
import type { Path, YamlFile } from '../configuration/yamlFile';
import { requirePlain, requireTls } from '../configuration/plain';
import { WORLD } from '../configuration/frames';
import type { RosFrame } from './frames';
import { ofMilliseconds, type Nanoseconds } from '../times';
import { configurationMessages } from '../messages/configuration';
import { rosMessages } from '../messages/ros';

const OLDEST_MS = 10_000;

/** The settings of the kind ros. */
interface RosSettings {
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
  /** Namespace of the robot; empty if it has none. */
  namespace: string;
  /** The text before the names of the robot's links in ROS; empty if there is none. */
  linkPrefix: string;
  hasClock: boolean;
  /** Maximum deceleration of joints that the file does not list; null if unknown. */
  maxDeceleration: number | null;
  /** Maximum age of a stamp. Values with older stamps are refused. */
  oldest: Nanoseconds;
}

interface PlantSection {
  endpoint: string;
  pin?: string;
  plain?: boolean;
  clock: boolean;
  oldest_ms?: number;
  max_deceleration?: number;
  topics?: { joint_states?: string; robot_description?: string | false; joint_trajectory?: string; tf?: string; tf_static?: string };
  world?: string;
  namespace?: string;
  link_prefix?: string;
  frames?: FrameEntry[];
}

interface FrameEntry {
  frame: string;
  source?: string;
  topic?: string;
  type?: string;
  /** Present for a frame whose pose consists of individual numbers. */
  position?: object;
}

const sectionOf = (configuration: Configuration): PlantSection => configuration.plant as unknown as PlantSection;

/** Gets a frame's name without the leading slash that ROS 1 allowed, and that its tools print. */
export const bare = (name: unknown): string => (typeof name === 'string' ? name.replace(/^\//, '') : '');

export function settingsOf(configuration: Configuration): RosSettings {
  const section = sectionOf(configuration);
  const { endpoint, pin, plain, clock, oldest_ms: oldest, topics, world, namespace, link_prefix: linkPrefix, frames } = section;
  return {
    endpoint,
    pin: pin ?? null,
    isPlain: plain === true && endpoint.startsWith('ws:'),
    jointStates: topics?.joint_states ?? '/joint_states',
    robotDescription: topics?.robot_description === false ? null : (topics?.robot_description ?? '/robot_description'),
    jointTrajectory: topics?.joint_trajectory ?? null,
    tf: topics?.tf ?? '/tf',
    tfStatic: topics?.tf_static ?? '/tf_static',
    frames: (frames ?? []).map(({ frame, source, topic, type }) => ({ frame, source: bare(source ?? frame), topic: topic ?? null, type })),
    types: new Map(configuration.values.flatMap(({ address: { topic, type } }) => (topic === undefined ? [] : [[topic, type!]]))),
    world: bare(world ?? WORLD),
    namespace: namespace ?? '',
    linkPrefix: bare(linkPrefix),
    hasClock: clock,
    maxDeceleration: section.max_deceleration ?? null,
    oldest: ofMilliseconds(oldest ?? OLDEST_MS),
  };
}

export const ros: Kind = {
  check(file, configuration) {
    requireAddress(file, ['plant', 'endpoint'], sectionOf(configuration).endpoint);
    requirePlain(file, sectionOf(configuration));
    if (sectionOf(configuration).pin !== undefined) requireTls(file, ['plant'], sectionOf(configuration).endpoint);
    const { joints } = configuration;
    const { frames = [] } = file.value as { frames?: FrameEntry[] };
    // Stored in the plant section, because the poses of these frames arrive as a whole and not as individual values.
    (configuration.plant as { frames?: object[] }).frames = frames.filter(({ position }) => position === undefined);
    // If the source is invalid, the name is not the source either.
    const known = (path: Path, source: unknown): unknown => (file.isInvalid([...path, 'source']) ? undefined : source);
    const names = frames.map(({ frame, source }, i) => known(['frames', i], bare(source ?? frame)));
    frames.forEach(({ source, topic, position }, i) => {
      if (source !== undefined && names.indexOf(bare(source)) < i)
        file.report(['frames', i, 'source'], configurationMessages.valueTwice(source, 'frame'));
      if (source !== undefined && position !== undefined && !file.isInvalid(['frames', i, 'position']))
        file.report(['frames', i, 'source'], rosMessages.sourceAndPosition);
      const isRead = configuration.values.some(({ path: [section, index] }) => section === 'frames' && index === i);
      if (isRead && topic === undefined) file.report(['frames', i, 'topic'], rosMessages.noTopic);
    });
    const sources = joints.map((joint, i) => known(['joints', i], joint.source ?? joint.name));
    sources.forEach((source, i) => {
      if (source !== undefined && sources.indexOf(source) < i) file.report(['joints', i], rosMessages.sourceTwice(String(source)));
    });
    joints.forEach(({ source, topic }, i) => {
      if (source !== undefined && topic !== undefined) file.report(['joints', i, 'source'], rosMessages.sourceAndTopic);
    });
    requireOneType(file, [
      ...configuration.values.map(({ path, address: { topic, type } }) => ({ path, topic, type })),
      ...frames.map(({ topic, type }, i) => ({ path: ['frames', i], topic, type })),
    ]);
  },
  passesUnlisted: ({ joints }) => joints.length === 0,
  offersClock: configuration => settingsOf(configuration).hasClock,
  summary(configuration) {
    const { endpoint, jointStates, hasClock, frames } = settingsOf(configuration);
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
    else if (first.type.replace('/msg/', '/') !== type.replace('/msg/', '/'))
      file.report([...path, 'type'], rosMessages.twoTypes(type, file.lineOf([...first.path, 'type']), first.type, topic));
  }
}

import type { Kind } from '../adapter';
import { requireAddress } from '../configuration/address';
import { type Configuration, passedJoints } from '../configuration/configuration';
import { requirePlain, requireTls } from '../configuration/plain';
import { ofMilliseconds, type Nanoseconds } from '../times';

const OLDEST_MS = 10_000;

/** The settings of kind ros. */
export interface RosSettings {
  endpoint: string;
  pin: string | null;
  isPlain: boolean;
  jointStates: string;
  robotDescription: string | null;
  jointTrajectory: string | null;
  hasClock: boolean;
  /** Values with older stamps are refused. */
  oldest: Nanoseconds;
}

interface PlantSection {
  endpoint: string;
  pin?: string;
  plain?: boolean;
  clock: boolean;
  oldest_ms?: number;
  topics?: { joint_states?: string; robot_description?: string | false; joint_trajectory?: string };
}

const sectionOf = (configuration: Configuration): PlantSection => configuration.plant as unknown as PlantSection;

export function settingsOf(configuration: Configuration): RosSettings {
  const { endpoint, pin, plain, clock, oldest_ms: oldest, topics } = sectionOf(configuration);
  return {
    endpoint,
    pin: pin ?? null,
    isPlain: plain === true && endpoint.startsWith('ws:'),
    jointStates: topics?.joint_states ?? '/joint_states',
    robotDescription: topics?.robot_description === false ? null : (topics?.robot_description ?? '/robot_description'),
    jointTrajectory: topics?.joint_trajectory ?? null,
    hasClock: clock,
    oldest: ofMilliseconds(oldest ?? OLDEST_MS),
  };
}

export const ros: Kind = {
  check(file, configuration) {
    requireAddress(file, ['plant', 'endpoint'], sectionOf(configuration).endpoint);
    requirePlain(file, sectionOf(configuration));
    if (sectionOf(configuration).pin !== undefined) requireTls(file, ['plant'], sectionOf(configuration).endpoint);
    const { joints } = configuration;
    const sources = joints.map(joint => joint.source ?? joint.joint);
    sources.forEach((source, i) => {
      if (sources.indexOf(source) < i) file.report(['joints', i], `the robot's joint ${String(source)} occurs twice; name each joint once`);
    });
  },
  passesUnlisted: ({ joints }) => joints.length === 0,
  summary(configuration) {
    const { joints } = configuration;
    const { endpoint, jointStates, hasClock } = settingsOf(configuration);
    return `rosbridge ${endpoint}, ${jointStates}, ${hasClock ? 'its time' : 'not its time'}, ${passedJoints(joints, 'all joints')}`;
  },
};

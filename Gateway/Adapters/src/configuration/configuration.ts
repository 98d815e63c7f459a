import type { Kind } from '../adapter';
import { requireAddress } from './address';
import { type Frame, type FrameSettings, framesOf } from './frames';
import { nearest } from './nearest';
import { checkParents } from './parents';
import { type AnyOf, type EntryOf, type KindName, type PlantFile, type Silence, silenceMs } from './plantFile';
import { linesOf } from './problem';
import { type NamedJoint, namedIn, requireJoints, robotOf } from './robot';
import { checkAgainstSchema, hasEntry, KINDS, knownEntries } from './schemaCheck';
import { secretIn } from './secret';
import { warnOfSharedAddresses } from './sharedAddresses';
import { requireTls } from './plain';
import { signalsOf } from './signals';
import { type Address, addressIn, type Value } from './values';
import { type Path, pathText, YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

const UNITS: Record<string, number> = { rad: 1, deg: Math.PI / 180, m: 1, mm: 0.001 };

/** Offset of a rotary joint in rad above which it is probably in degrees: a full turn, rounded up. */
const MAX_OFFSET = 6.3;

export interface GatewayAddress {
  url: string;
  token: string | null;
  pin: string | null;
}

/** A joint and the conversion of its value to rad or m. The form of its address depends on the kind of plant. */
export interface Joint extends Address, NamedJoint {
  scale: number;
  offset: number;
  /** Maximum deceleration, rad/s² or m/s²; absent if unknown. */
  maxDeceleration?: number;
  /** Time without data after which the joint has a fault, ms; absent or null if a silent joint counts as at rest. */
  faultAfterMs?: number | null;
  unit?: string;
  /** ROS only: the name that the robot uses. */
  source?: string;
}

type Content = AnyOf<PlantFile> & { plant: AnyOf<PlantFile['plant']> };

export interface Configuration {
  file: string;
  gateway: GatewayAddress;
  /** The entries of the plant's section, with the default name and meaning of missing data. */
  plant: Content['plant'] & { name: string; silence: Silence };
  joints: Joint[];
  frames: Frame[];
  /** Settings of the frames whose poses arrive as a whole: those of ROS without `position`. */
  wholeFrames: FrameSettings[];
  signals: EntryOf<'signals'>[];
  /** The possible parents of each frame in the file, by the name of the frame. Empty for a frame of ROS whose parent arrives with its pose. */
  parents: Record<string, string[]>;
  /** Whether the file configures frames or signals. */
  hasObjects: boolean;
  /** The numbers to read, in the order of joints, frames and signals. */
  values: Value[];
  /** The text of the URDF of the robot without a namespace; null if the adapter does not publish it. */
  robot: string | null;
  /** The URDFs of the robots with a namespace, as strings, by namespace. */
  robots: Record<string, string>;
  /** The string "FILE, line L: path.to.entry: NAME" for each robot, by namespace, for errors in its description. */
  describedBy: Record<string, string>;
  /** Warnings about valid entries, each with the file and the line. */
  warnings: string[];
  /** The environment variable with the password of this plant only; null if its password is not in such a variable. */
  passwordVariable: string | null;
  /** Strings that must not appear in the log. */
  secrets: string[];
  /** Whether the gateway has started the adapter. The gateway then passes its address in the environment. */
  isSupervised: boolean;
  /** Gets the string "FILE, line L: path.to.entry", for errors that are detected only after connecting to the plant. */
  where(path: Path): string;
  /** Gets the line of an entry, counted from 1. */
  lineOf(path: Path): number;
}

/** A configuration without errors, and the settings of its kind of plant. */
export interface CheckedConfiguration<Settings = unknown> extends Configuration {
  settings: Settings;
}

/**
 * Reads and checks a configuration.
 * @param environment Environment variables, which take precedence over the file if a gateway has set them.
 * @param isForMachine Whether to check also that the adapter can run on this machine. The adapter itself repeats what fails until it succeeds.
 * @throws ConfigurationError The configuration is invalid. The error contains all invalid entries; of a file that is not valid YAML, only its first
 * error; of a file without a valid kind of plant, only the errors about the kind and the entries that exist for no kind.
 */
export function readConfiguration(
  path: string,
  environment: NodeJS.ProcessEnv,
  kinds: Record<KindName, Kind>,
  isForMachine = false,
): CheckedConfiguration {
  return checkConfiguration(YamlFile.read(path), environment, kinds, isForMachine);
}

/**
 * Checks a parsed configuration like readConfiguration.
 * @throws ConfigurationError The configuration is invalid.
 */
export function checkConfiguration(
  file: YamlFile,
  environment: NodeJS.ProcessEnv,
  kinds: Record<KindName, Kind>,
  isForMachine = false,
): CheckedConfiguration {
  const { path } = file;
  const name = kindOf(file);
  const kind = kinds[name];
  const content: Content = checkAgainstSchema(file, name);
  const gateway = gatewayOf(file, content.gateway, environment);
  const silence = content.plant.silence ?? kind.silence ?? 'rest';
  const namespace = content.plant.namespace ?? '';
  const described = content.robot === undefined ? null : robotOf(file, ['robot'], content.robot);
  const joints = jointsOf(file, content, silence);
  const values: Value[] = joints.map((joint, i) => ({ label: joint.joint, path: ['joints', i], address: addressIn(joint) }));
  const wholeFrames: FrameSettings[] = [];
  const where = (entry: Path): string => `${path}, line ${file.lineOf(entry)}: ${pathText(entry)}`;
  const frames = framesOf(file, kind, content.frames ?? [], silence, values, wholeFrames);
  const configuration: Configuration = {
    file: path,
    gateway,
    plant: { ...content.plant, name: content.plant.name ?? name, silence },
    joints,
    frames,
    wholeFrames,
    parents: Object.fromEntries([...(content.frames ?? []), ...frames].map(entry => [entry.frame, 'parents' in entry ? entry.parents : []])),
    signals: signalsOf(file, content.signals ?? [], values),
    hasObjects: (content.frames ?? []).length + (content.signals ?? []).length > 0,
    values,
    robot: namespace === '' ? described : null,
    robots: { ...robotsOf(file, content), ...(namespace === '' || described === null ? {} : { [namespace]: described }) },
    describedBy: {
      ...Object.fromEntries(Object.entries(content.robots ?? {}).map(([robot, text]) => [robot, `${where(['robots', robot])}: ${text}`])),
      ...(content.robot === undefined ? {} : { [namespace]: `${where(['robot'])}: ${content.robot}` }),
    },
    warnings: [],
    passwordVariable: null,
    secrets: gateway.token === null ? [] : [gateway.token],
    isSupervised: environment.NOWPOSE_SUPERVISED === '1',
    where,
    lineOf: entry => file.lineOf(entry),
  };
  const namespaces = hasEntry(name, 'robots') ? Object.keys(content.robots ?? {}) : null;
  for (const [robot, urdf] of Object.entries({ ...configuration.robots, '': configuration.robot }))
    requireJoints(file, joints, robot, urdf, namespaces);
  (content.joints ?? []).forEach(({ unit, scale }: EntryOf<'joints'>, i) => {
    const { offset, isLinear } = joints[i];
    // With only a factor, the value may have any unit.
    if (unit !== undefined || scale === undefined) values[i].unit = unit ?? (isLinear === true ? 'm' : 'rad');
    if (isLinear !== true && Math.abs(offset) > MAX_OFFSET)
      file.warn(['joints', i, 'offset'], configurationMessages.offsetBeyondATurn(offset, offset * UNITS.deg));
  });
  warnOfSharedAddresses(file, values, joints);
  checkParents(file, content.frames ?? [], { ...configuration.robots, ...(configuration.robot === null ? {} : { '': configuration.robot }) });
  const settings = kind.check(file, content, configuration, environment);
  if (isForMachine) kind.checkMachine?.(file, settings);
  file.throwIfWrong();
  return { ...configuration, settings, warnings: linesOf(path, file.warnings) };
}

// Gets the kind of plant, which must be known before the other entries can be checked.
function kindOf(file: YamlFile): KindName {
  const root = file.value as { plant?: { kind?: unknown } } | null;
  const isSection = typeof root === 'object' && typeof root?.plant === 'object' && root.plant !== null;
  const kind = isSection ? root?.plant?.kind : undefined;
  if (kind === undefined) {
    const path = isSection ? ['plant'] : [];
    const missing = isSection ? 'kind' : 'plant';
    const meant = misspelt(missing, isSection ? root!.plant! : root, knownEntries(path));
    if (meant === undefined) file.report([...path, missing], configurationMessages.noKind(KINDS));
    else file.report([...path, meant], configurationMessages.misspelt(missing));
    if (!isSection) reportUnknown(file, root, meant);
  } else if (!KINDS.includes(kind as KindName)) {
    const [guess] = nearest(String(kind), KINDS);
    file.report(['plant', 'kind'], configurationMessages.notAllowed(kind, guess, KINDS));
  }
  file.throwIfWrong();
  return kind as KindName;
}

/** Reports top-level entries that exist for no kind of plant, except the entry that was already reported. */
function reportUnknown(file: YamlFile, root: unknown, reported: string | undefined): void {
  // The characters of a text and the elements of a list are not entries.
  if (typeof root !== 'object' || Array.isArray(root)) return;
  const known = [...new Set(knownEntries([]))];
  for (const key of Object.keys(root ?? {}))
    if (key !== reported && !known.includes(key)) file.report([key], configurationMessages.unknownEntry(undefined, known));
}

/** Gets the unknown entry that is probably a misspelling of a missing entry. */
const misspelt = (missing: string, section: unknown, known: string[]): string | undefined =>
  typeof section === 'object'
    ? nearest(
        missing,
        Object.keys(section ?? {}).filter(key => !known.includes(key)),
      )[0]
    : undefined;

function gatewayOf(file: YamlFile, section: Content['gateway'], environment: NodeJS.ProcessEnv): GatewayAddress {
  const url = environment.NOWPOSE_GATEWAY ?? section.url;
  const fromFile = section.token_file === undefined ? null : secretIn(file, ['gateway', 'token_file'], section.token_file);
  const token = environment.NOWPOSE_TOKEN ?? fromFile;
  requireAddress(file, ['gateway', 'url'], url);
  if (token !== null && url.startsWith('ws:') && !isLoopback(url)) file.report(['gateway', 'url'], configurationMessages.tokenInClear(url));
  const isKnown = environment.NOWPOSE_GATEWAY === undefined && !file.isInvalid(['gateway', 'url']);
  if (section.pin !== undefined && isKnown) requireTls(file, ['gateway'], url);
  return { url, token, pin: environment.NOWPOSE_PIN ?? section.pin ?? null };
}

function jointsOf(file: YamlFile, content: Content, silence: Silence): Joint[] {
  const lines = new Map<string, number>();
  return (content.joints ?? []).map((entry: EntryOf<'joints'>, i) => {
    const path: Path = ['joints', i];
    if (lines.has(entry.joint)) file.report([...path, 'joint'], configurationMessages.nameTwice(entry.joint, lines.get(entry.joint), 'joint'));
    lines.set(entry.joint, file.lineOf([...path, 'joint']));
    const namespace = content.plant.namespace ?? '';
    return {
      ...entry,
      ...(namespace === ''
        ? namedIn(entry.joint, Object.keys(content.robots ?? {}))
        : { joint: `${namespace}/${entry.joint}`, robot: namespace, name: entry.joint }),
      scale: (entry.scale ?? 1) * UNITS[entry.unit ?? 'rad'],
      offset: entry.offset ?? 0,
      isLinear: entry.unit === 'm' || entry.unit === 'mm',
      maxDeceleration: entry.max_deceleration ?? content.plant.max_deceleration,
      faultAfterMs: silenceMs(entry.silence ?? silence),
    };
  });
}

function robotsOf(file: YamlFile, { robots = {} }: Content): Record<string, string> {
  const valid = Object.entries(robots).filter(([namespace]) => !file.isInvalid(['robots', namespace]));
  const found = valid.map(([namespace, robot]) => [namespace, robotOf(file, ['robots', namespace], robot)]);
  return Object.fromEntries(found.filter(([, urdf]) => urdf !== null));
}

/** Gets the names of the joints, frames and signals that are read, as a string for a summary. */
export function readNames({ joints, frames, signals }: Configuration, none: string): string {
  const kinds = { joints: joints.map(j => j.joint), frames: frames.map(f => f.frame), signals: signals.map(s => s.signal) };
  const parts = Object.entries(kinds).flatMap(([kind, names]) => (names.length === 0 ? [] : [`${kind} ${names.join(', ')}`]));
  return parts.length === 0 ? none : parts.join('; ');
}

/** Whether an address, with or without a scheme, is a loopback address. */
export const isLoopback = (address: string): boolean => /^(\w+:\/\/)?(127\.\d+\.\d+\.\d+|\[?::1\]?|localhost)([:/]|$)/.test(address);

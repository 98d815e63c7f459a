import { requireAddress } from './address';
import { nearest } from './nearest';
import { shown } from './problem';
import { requireJoints, robotOf } from './robot';
import { checkAgainstSchema, KINDS, knownEntries } from './schemaCheck';
import { secretIn } from './secret';
import { requireTls } from './plain';
import { type Path, pathText, YamlFile } from './yamlFile';

const UNITS: Record<string, number> = { rad: 1, deg: Math.PI / 180, m: 1, mm: 0.001 };

export interface GatewayAddress {
  url: string;
  token: string | null;
  pin: string | null;
}

/** A joint and how its value becomes rad or m; what names it in the control system is the kind's own. */
export interface Joint {
  joint: string;
  scale: number;
  offset: number;
  /** Whether the position is a length in m; an angle in rad otherwise. */
  isLinear?: boolean;
  /** rad/s² or m/s²; left out where it is not known. */
  maxDeceleration?: number;
  /** Silence in ms that is a fault; left out or null where a silent joint is at rest. */
  faultAfterMs?: number | null;
  [own: string]: unknown;
}

/** Kinds whose sources send each joint again and again, at rest too: what silence means there unless the file says something else. */
const PERIODIC: Record<string, SilenceEntry> = { ros: { fault_after_s: 1 }, rtde: { fault_after_s: 1 }, broker: { fault_after_s: 3 } };

/** What it means when nothing comes of a joint. */
export type SilenceEntry = 'rest' | { fault_after_s: number };

export interface Configuration {
  file: string;
  gateway: GatewayAddress;
  /** Its name, its kind and what is the kind's own, as the schema allows it. */
  plant: { kind: string; name: string; silence: SilenceEntry; [own: string]: unknown };
  joints: Joint[];
  /** The URDF's text. */
  robot: string | null;
  /** What may not appear in the log. */
  secrets: string[];
  /** Whether the gateway starts the adapter, which then gets its address from it. */
  isSupervised: boolean;
  /** FILE, line L: path.to.entry, for what turns out to be wrong only at the plant. */
  where(path: Path): string;
}

interface Sections {
  gateway?: { url?: string; token_file?: string; pin?: string };
  plant: { kind: string; name?: string; silence?: SilenceEntry; max_deceleration?: number };
  joints?: { joint: string; unit?: string; scale?: number; offset?: number; silence?: SilenceEntry; max_deceleration?: number }[];
  robot?: string;
}

/** What a kind of plant has to say about its own entries, once they have the schema's form. */
export type OwnCheck = (file: YamlFile, configuration: Configuration, environment: NodeJS.ProcessEnv) => void;

/**
 * Reads and checks a configuration as a whole.
 * @param environment What the gateway that starts the adapter sets there wins over the file.
 * @throws ConfigurationError With every wrong entry.
 */
export function readConfiguration(path: string, environment: NodeJS.ProcessEnv, ownChecks: Record<string, OwnCheck>): Configuration {
  const file = new YamlFile(path), kind = kindOf(file);
  checkAgainstSchema(file, kind);
  file.throwIfWrong();
  const sections = file.value as Sections;
  const gateway = gatewayOf(file, sections, environment), silence = sections.plant.silence ?? PERIODIC[kind] ?? 'rest';
  const configuration: Configuration = {
    file: path,
    gateway,
    plant: { ...sections.plant, name: sections.plant.name ?? kind, silence },
    joints: jointsOf(file, sections, silence),
    robot: sections.robot === undefined ? null : robotOf(file, sections.robot),
    secrets: gateway.token === null ? [] : [gateway.token],
    isSupervised: environment.NOWPOSE_SUPERVISED === '1',
    where: entry => `${path}, line ${file.lineOf(entry)}: ${pathText(entry)}`,
  };
  if (configuration.robot !== null) requireJoints(file, configuration.joints, configuration.robot);
  ownChecks[kind]?.(file, configuration, environment);
  file.throwIfWrong();
  return configuration;
}

// Nothing can be checked before it is known what is described.
function kindOf(file: YamlFile): string {
  const root = file.value as { plant?: { kind?: unknown } } | null;
  const isSection = typeof root === 'object' && typeof root?.plant === 'object' && root.plant !== null;
  const kind = isSection ? root?.plant?.kind : undefined, allowed = `allowed are ${KINDS.join(', ')}`;
  if (kind === undefined) {
    const path = isSection ? ['plant'] : [], missing = isSection ? 'kind' : 'plant';
    const meant = misspelt(missing, isSection ? root!.plant! : root, knownEntries(path));
    if (meant === undefined) file.report([...path, missing], `missing; add the section plant with its kind, ${allowed}`);
    else file.report([...path, meant], `not known here; did you mean ${missing}?`);
    if (!isSection) reportStrangers(file, root, meant);
  } else if (!KINDS.includes(kind as string)) {
    const [guess] = nearest(String(kind), KINDS);
    file.report(['plant', 'kind'], `value ${shown(kind)}; ${guess ? `did you mean ${guess}? ` : ''}${allowed}`);
  }
  file.throwIfWrong();
  return kind as string;
}

/** Reports what no kind has at the top. */
function reportStrangers(file: YamlFile, root: object | null, told: string | undefined): void {
  const known = [...new Set(knownEntries([]))];
  for (const key of Object.keys(root ?? {}))
    if (key !== told && !known.includes(key)) file.report([key], `not known here; allowed are ${known.join(', ')}`);
}

/** What stands in the place of an entry that is missing. */
const misspelt = (missing: string, section: unknown, known: string[]): string | undefined =>
  typeof section === 'object' ? nearest(missing, Object.keys(section ?? {}).filter(key => !known.includes(key)))[0] : undefined;

function gatewayOf(file: YamlFile, sections: Sections, environment: NodeJS.ProcessEnv): GatewayAddress {
  const section = sections.gateway ?? {};
  const url = environment.NOWPOSE_GATEWAY ?? section.url ?? 'ws://127.0.0.1:47011';
  const fromFile = section.token_file === undefined ? null : secretIn(file, ['gateway', 'token_file'], section.token_file);
  const token = environment.NOWPOSE_TOKEN ?? fromFile;
  requireAddress(file, ['gateway', 'url'], url);
  if (token !== null && url.startsWith('ws:') && !isLoopback(url))
    file.report(['gateway', 'url'], `value ${shown(url)}; a token travels over wss:// or on this machine only, use wss:// with the gateway's pin`);
  if (section.pin !== undefined && environment.NOWPOSE_GATEWAY === undefined) requireTls(file, ['gateway'], url);
  return { url, token, pin: environment.NOWPOSE_PIN ?? section.pin ?? null };
}

function jointsOf(file: YamlFile, sections: Sections, silence: SilenceEntry): Joint[] {
  const lines = new Map<string, number>();
  return (sections.joints ?? []).map((entry, i) => {
    const path: Path = ['joints', i];
    if (lines.has(entry.joint))
      file.report([...path, 'joint'], `value ${shown(entry.joint)}; line ${lines.get(entry.joint)} has this joint already, name each once`);
    lines.set(entry.joint, file.lineOf([...path, 'joint']));
    if (entry.unit !== undefined && entry.scale !== undefined)
      file.report([...path, 'scale'], 'the unit tells the scale already; keep one of the two');
    return {
      ...entry,
      scale: entry.scale ?? UNITS[entry.unit ?? 'rad'],
      offset: entry.offset ?? 0,
      isLinear: entry.unit === 'm' || entry.unit === 'mm',
      maxDeceleration: entry.max_deceleration ?? sections.plant.max_deceleration,
      faultAfterMs: faultAfterMs(entry.silence ?? silence),
    };
  });
}

/** Silence in ms that is a fault; null where it means rest. */
export const faultAfterMs = (silence: SilenceEntry): number | null =>
  typeof silence === 'object' ? 1000 * silence.fault_after_s : null;

/** Of a summary. */
export const passedJoints = (joints: Joint[], none: string): string => joints.length === 0 ? none : `joints ${joints.map(j => j.joint).join(', ')}`;

/** Of an address with a scheme or a host alone. */
export const isLoopback = (address: string): boolean => /^(\w+:\/\/)?(127\.\d+\.\d+\.\d+|\[?::1\]?|localhost)([:/]|$)/.test(address);

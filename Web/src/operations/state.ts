import type { HeadsetKey } from './headsetKeys';

/** Response to a request for /operations/state. The value of a field that is missing or null is unknown. The names of numbers contain their units. */
export interface State {
  cell?: string | null;
  host?: string;
  version?: string;
  /** The overall state, and the start of the condition that its text describes. */
  status?: { level: Level; text: string; since_utc?: string };
  control_time_s?: number;
  clock?: ClockState | null;
  plant_clocks?: PlantClock[];
  adapters?: Words[];
  sources?: Source[];
  joints?: Joint[];
  frames?: CellFrame[];
  signals?: Signal[];
  /** The events, newest first. Active events are always included. */
  events?: StatusEvent[];
  headsets?: Headset[];
  forward_ms?: { p50: number; p99: number } | null;
  connections?: Record<string, { open: number }>;
  drops?: Record<string, number>;
  recording?: Recording | null;
  pairs_headsets?: boolean;
  role?: 'observer' | 'source' | 'operator';
  is_logged_in?: boolean;
}

export type Level = 'ok' | 'warning' | 'error';

export interface Joint {
  /** The cell-wide name. */
  name: string;
  /** Namespace of the robot; empty for a robot without one, null if the gateway has received no sample of the joint. */
  robot?: string | null;
  source: string;
  state: 'live' | 'rest' | 'stale' | 'refused' | 'fault' | 'missing';
  since_utc: string;
  age_s?: number | null;
  rate_hz: number;
  reason: string;
  /** Reason why it is uncertain that the joint is at rest. */
  uncertain?: string | null;
}

/** A moving or stationary object of the cell. */
export interface CellFrame {
  name: string;
  /** Parent frame; null before the first pose. */
  parent: string | null;
  source: string;
  state: 'live' | 'stale' | 'orphan' | 'parent-stale' | 'stationary' | 'refused' | 'fault' | 'missing';
  /** Age of the newest pose; null for a stationary object and before the first pose. */
  age_s?: number | null;
  /** Reason why the pose is not current; null if it is current. */
  reason?: string | null;
  /** Start of the state; null if the pose is current. */
  since_utc?: string | null;
}

export interface Signal {
  name: string;
  /** The newest value; null before the first value, like `age_s`. */
  value: number | null;
  source: string;
  state: 'live' | 'stale' | 'ended' | 'refused' | 'fault' | 'missing';
  /** Time since the value last changed. */
  age_s: number | null;
  /** Reason why the value is not current; null if it is current. */
  reason?: string | null;
  /** Start of the state; null if the value is current. */
  since_utc?: string | null;
}

export interface StatusEvent {
  id: number;
  kind: string;
  which: string;
  what: string;
  reason: string;
  level: Level;
  since_utc: string;
  until_utc?: string | null;
  /** Complete text of the event. */
  text?: string | null;
}

export interface StoredRecording {
  name: string;
  bytes: number;
  changed_utc: string;
}

interface ClockState {
  source: string;
  state: string;
  estimated_error_us?: number | null;
  error_bound_us?: number | null;
  /** Number of steps of the clock since the gateway started. */
  steps?: number | null;
}

export interface PlantClock {
  name: string;
  connected: boolean;
  is_control_clock: boolean;
  state: string;
  offset_to_control_ms?: number | null;
  skew_ppm?: number | null;
  rtt_ms?: number | null;
  estimated_error_us?: number | null;
  error_bound_us?: number | null;
  resolution_us?: number | null;
  failures?: number;
  last_failure?: string | null;
}

interface Report {
  name: string;
  /** Time since the last report. */
  seen_s_ago: number;
}

/** Diagnostics of an adapter. Values are numbers if possible, otherwise strings. */
export type Words = Report & Record<string, unknown>;

export interface Source {
  joints: string[];
  rate_hz: number;
  age_ms?: { p50: number; p95: number } | null;
  beyond_limits?: string[];
}

export const HOPS = ['plant', 'gateway', 'network', 'queue', 'render', 'display'] as const;
type Hop = (typeof HOPS)[number];

/** Diagnostics of a headset. Values are numbers if possible, otherwise strings. */
export type Headset = Report & { [key in HeadsetKey]?: unknown } & { budget_ms?: Partial<Record<Hop, number | null>> | null };

export interface Recording {
  can: boolean;
  on: boolean;
  file?: string | null;
  /** Number of files of the recording, which have the lines and bytes together. */
  files?: number;
  lines?: number;
  bytes?: number;
  lost?: number;
  problem?: string | null;
  /** Whether the file of the newest recording was deleted after the recording had ended. */
  deleted?: boolean;
}

/** Time without a report after which the values of a headset or an adapter count as outdated. Both report once per second. */
const SILENT_S = 3;

export const isSilent = ({ seen_s_ago: ago }: Report): boolean => ago > SILENT_S;

/** Removes the values of a silent headset, because its last values would look current. */
export const withoutOld = (headset: Headset): Headset => (isSilent(headset) ? { name: headset.name, seen_s_ago: headset.seen_s_ago } : headset);

/** Returns a value of the diagnostics; null if it is missing or not a finite number. */
export function numberOf<T extends Report>(words: T, key: keyof T): number | null {
  const value = words[key];
  return typeof value === 'number' && Number.isFinite(value) ? value : null;
}

export function textOf<T extends Report>(words: T, key: keyof T): string {
  const value = words[key];
  return value == null ? '' : String(value);
}

/** Returns the part of a cell-wide name before the slash, which usually is a namespace; empty if there is none. */
export const namespaceOf = (name: string) => name.slice(0, Math.max(0, name.indexOf('/')));

/** Returns the namespaces of the robots of joints, by the names of the joints. The name of a joint may itself contain a slash. */
export function robotsOf(joints: Joint[]): Map<string, string> {
  const robots = new Map(joints.map(({ name }) => [name, namespaceOf(name)]));
  for (const { name, robot } of joints) if (robot != null) robots.set(name, robot);
  return robots;
}

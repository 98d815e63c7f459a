import type { FigureData, Verdict } from './paper/data';

/** The report's data, as `ReportPage.Render` receives it. A null or absent section was not measured. */
export interface Report {
  title?: string;
  subtitle?: string;
  settings?: Fact[] | null;
  summary?: SummaryRow[] | null;
  facts?: Fact[] | null;
  error?: ErrorData | null;
  joint?: JointData | null;
  field?: FieldData | null;
  clock?: ClockData | null;
  latency?: LatencyData | null;
  range?: RangeData | null;
  /** The paper's claims and figures of this run; null without `--paper`. */
  claims?: ClaimData[] | null;
  figures?: FigureData[] | null;
  playback?: PlaybackData | null;
}

export type Value = number | null;
export type Fact = [label: string, value: string | number | boolean | null];

export interface SummaryRow {
  label: string;
  unit: string;
  uncompensated: Value;
  compensated: Value;
}

/** A claim of the paper with its number and ours, as text. */
export interface ClaimData {
  figure: string;
  claim: string;
  /** Empty where the paper gives no number. */
  paper: string;
  measured: string;
  verdict: Verdict;
}

/** Seconds since start, millimetres. */
export interface ErrorData {
  t: number[];
  hold: Value[];
  compensated: Value[];
}

/** Seconds on the control clock since start. */
export interface Signal {
  t: number[];
  v: Value[];
}

export interface JointData {
  name: string;
  unit: string;
  truth?: Signal | null;
  received?: Signal | null;
  predicted?: Signal | null;
}

/** Milliseconds, millimetres per second. */
export interface OperatingPath {
  latency_ms: number[];
  speed: number[];
}

export interface FieldData {
  hold?: OperatingPath | null;
  compensated?: OperatingPath | null;
  iso_mm?: number[] | null;
}

/** Seconds since start, microseconds; the offset is relative to the first. */
export interface ClockData {
  t: number[];
  offset_us: Value[];
  error_us: Value[];
  bound_us: Value[];
}

/** Lower edges of the bins in milliseconds, all of one width, and the samples in each. */
export interface LatencyData {
  bin_ms: number[];
  count: number[];
  label?: string;
}

/** Seconds since start, milliseconds; an alarm is the time from its beginning to its end. */
export interface RangeData {
  t: number[];
  render_ms: Value[];
  visu_ms: Value[];
  limit_ms?: Value;
  alarms?: [from: number, to: number][] | null;
}

/** Seconds since start; for each instant one position of each joint, rad or m. */
export interface PlaybackData {
  urdf: string;
  names: string[];
  t: number[];
  truth: number[][];
  displayed: number[][];
  hold: number[][];
  objects?: ObjectsData | null;
}

/** Objects of the cell. Per instant, seven numbers for each object: position in m and unit quaternion, in the robot's base frame. */
export interface ObjectsData {
  names: string[];
  /** Edge length of the cubes, m. */
  size: number;
  /** Points on the belt, m. */
  belt: number[][];
  fixture: number[];
  truth: number[][];
  /** Null while an object was unknown. */
  displayed: (number[] | null)[];
  hold: (number[] | null)[];
}

export function hasPoints(values: ArrayLike<unknown> | null | undefined): boolean {
  return values != null && values.length > 0;
}

export function readReport(): Report {
  return JSON.parse(document.getElementById('report-data')!.textContent!) as Report;
}

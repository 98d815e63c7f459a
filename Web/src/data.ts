import type { FigureData, Verdict } from './figures/data';

/** Data of the report, as passed to `Pages.Report.Render`. A section that is null or missing was not measured. */
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
  /** Claims and figures of the paper with the results of this run; null without `--paper`. */
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

/** A claim of the paper with the paper's value and the measured one, as text. */
export interface ClaimData {
  figure: string;
  claim: string;
  /** Value of the paper; empty if it gives none. */
  paper: string;
  measured: string;
  verdict: Verdict;
}

/** Tool errors in mm over the time since the start in s. */
export interface ErrorData {
  t: number[];
  hold: Value[];
  compensated: Value[];
}

/** Values over control time since the start in s. */
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

/** Operating points: latency in ms, and speed in mm/s. */
export interface OperatingPath {
  latency_ms: number[];
  speed: number[];
}

export interface FieldData {
  hold?: OperatingPath | null;
  compensated?: OperatingPath | null;
  iso_mm?: number[] | null;
}

/** Times in s since the start, offsets and errors in µs. Offsets are relative to the first one. */
export interface ClockData {
  t: number[];
  offset_us: Value[];
  error_us: Value[];
  bound_us: Value[];
}

/** Histogram: lower edges of the bins in ms, all with the same width, and the number of samples in each bin. */
export interface LatencyData {
  bin_ms: number[];
  count: number[];
  label?: string;
}

/** Times in s since the start, durations in ms. An alarm is the interval from its start to its end. */
export interface RangeData {
  t: number[];
  render_ms: Value[];
  visu_ms: Value[];
  limit_ms?: Value;
  alarms?: [from: number, to: number][] | null;
}

/** Times in s since the start, and one position per joint at each time, rad or m. */
export interface PlaybackData {
  urdf: string;
  names: string[];
  t: number[];
  truth: number[][];
  displayed: number[][];
  hold: number[][];
  objects?: ObjectsData | null;
  signals?: CellSignal[] | null;
}

/** A signal of the cell. Each series has the first value and all changes, and null before the first value. A Boolean is 0 or 1. */
export interface CellSignal {
  name: string;
  truth: Signal;
  displayed: Signal;
}

/** Objects of the cell. At each time, seven numbers per object: position in m and unit quaternion, in the robot's base frame. */
export interface ObjectsData {
  names: string[];
  /** Edge length of the cubes, m. */
  size: number;
  /** Points on the belt, m. */
  belt: number[][];
  fixture: number[];
  truth: number[][];
  /** Displayed poses. Null before the first sample of an object. */
  displayed: (number[] | null)[];
  hold: (number[] | null)[];
}

export function hasPoints(values: ArrayLike<unknown> | null | undefined): boolean {
  return values != null && values.length > 0;
}

export function readReport(): Report {
  return JSON.parse(document.getElementById('report-data')!.textContent!) as Report;
}

import type { Fact, Value } from '../data';
import type { Mark, Quantity } from '../linePlot';

/** The page's data, as `FiguresPage.Render` receives it. */
export interface FiguresData {
  title: string;
  subtitle: string;
  conditions: Fact[];
  /** Numbers of the figures that were not computed because the run was interrupted. */
  missing: string[];
  figures: FigureData[];
}

export type Verdict = 'holds' | 'holds partly' | 'does not hold' | 'not measured';

export interface FigureData {
  /** Number in the paper, for example "13a". */
  number: string;
  title: string;
  claim: string;
  verdict: Verdict;
  criteria: CriterionData[];
  /** Results of our own methods; null if there are none. */
  beyond: string | null;
  conditions: string;
  /** Name of the CSV. */
  file: string;
  table: { columns: string[]; rows: Value[][] };
  summary: SummaryData | null;
  drawings: DrawingData[];
  plots: PlotData[];
}

export interface CriterionData {
  statement: string;
  /** Null if the numbers were not measured. */
  is_met: boolean | null;
  measured: string;
}

export interface SummaryData {
  caption: string;
  columns: string[];
  rows: string[][];
}

export interface DrawingData {
  title: string;
  description: string;
  svg: string;
}

export interface PlotData {
  title: string;
  x: Quantity;
  y: Quantity;
  from_zero: boolean;
  /** Range of the vertical axis; null to follow the data. */
  y_range: [from: number, to: number] | null;
  /** Curves of equal error for a plot of operating points; null for a line plot. */
  iso_mm: number[] | null;
  marks: Mark[];
  traces: TraceData[];
}

export interface TraceData {
  label: string;
  look: string;
  x: number[];
  y: Value[];
  stepped: boolean;
  marked: boolean;
  /** Whether to draw points without a line between them. */
  scattered: boolean;
  /** Half length of a bar across each point; null for none. */
  deviation: Value[] | null;
}

export function readFigures(): FiguresData {
  return JSON.parse(document.getElementById('report-data')!.textContent!) as FiguresData;
}

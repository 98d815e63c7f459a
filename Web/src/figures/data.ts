import type { Fact, Value } from '../data';
import type { Mark, Quantity } from '../linePlot';

/** Data of the page, as passed to `Pages.Figures.Render`. */
export interface FiguresData {
  title: string;
  subtitle: string;
  conditions: Fact[];
  /** Numbers of the figures that were not computed because the run was interrupted. */
  missing: string[];
  figures: FigureData[];
}

export type Verdict = 'holds' | 'holds partly' | 'does not hold' | 'undecided' | 'not measured';

export interface FigureData {
  /** Number of the figure in the paper, for example "13a". */
  number: string;
  title: string;
  claim: string;
  verdict: Verdict;
  criteria: CriterionData[];
  /** Results of Nowpose's own methods; null if there are none. */
  beyond: string | null;
  conditions: string;
  /** Name of the CSV file. */
  file: string;
  table: { columns: string[]; rows: Value[][] };
  summary: SummaryData | null;
  drawings: DrawingData[];
  plots: PlotData[];
}

export interface CriterionData {
  statement: string;
  /** Whether the criterion is met; null if it was not measured, or if it is undecided. */
  is_met: boolean | null;
  /** Whether the criterion is met for a part of the confidence interval only. */
  is_undecided?: boolean;
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
  /** Fixed range of the vertical axis; null to fit the data. */
  y_range: [from: number, to: number] | null;
  /** Values of the curves of equal error in a plot of operating points; null for a line plot. */
  iso_mm: number[] | null;
  marks: Mark[];
  traces: TraceData[];
}

interface TraceData {
  label: string;
  look: string;
  x: number[];
  y: Value[];
  stepped: boolean;
  marked: boolean;
  /** Whether points are drawn without a line between them. */
  scattered: boolean;
  /** Half the length of the error bar at each point; null for no error bars. */
  deviation: Value[] | null;
}

export function readFigures(): FiguresData {
  return JSON.parse(document.getElementById('report-data')!.textContent!) as FiguresData;
}

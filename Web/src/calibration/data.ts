import type { Fact, Value } from '../data';
import type { PlotData } from '../figures/data';

/** Data of the page, as passed to `Pages.Calibration.Render`. */
export interface CalibrationData {
  title: string;
  /** Result in one sentence. */
  result: string;
  /** Warnings to read before the result is used. */
  warnings: string[];
  facts: Fact[];
  sections: SectionData[];
}

export interface SectionData {
  heading: string;
  /** Figure or section of the paper; null if there is none. */
  source: string | null;
  words: string;
  plots: PlotData[];
  table: { columns: string[]; rows: Value[][] } | null;
}

export function readCalibration(): CalibrationData {
  return JSON.parse(document.getElementById('report-data')!.textContent!) as CalibrationData;
}

import { format } from '../numbers';

/** Text of the plots and the tables of all pages. */
export const plotMessages = {
  howToUse:
    'Drag across a plot to zoom, double-click to reset the zoom, and point at a curve to read its values. '
    + 'On the keyboard, the arrow keys move the cursor, plus and minus zoom, and 0 resets the zoom. Click a name in a legend to show or hide its curve.',
  keys: 'The arrow keys move the cursor, plus and minus zoom, and 0 resets the zoom.',
  notMeasured: 'Not measured in this run.',
  partNotMeasured: (part: string) => `${part}: not measured in this run.`,
};

/** Captions of plots and tables. */
export const plotLabels = { numbers: 'Numbers of this plot', toolError: 'Tool error over time' };

/** Descriptions of the report's plots for screen readers. `values` consists of complete sentences. */
export const plotDescriptions = {
  error: (values: string) => `Distance between the displayed and the true position of the tool over time. ${values}`,
  joint: (joint: string, values: string) => `Position of joint ${joint} over control time. ${values}`,
  field: (values: string) => `Operating points by latency and speed with curves of equal error. ${values}`,
  clockOffset: (values: string) => `Clock offset over time, relative to the first estimate. ${values}`,
  clockError: (values: string) => `Error of the clock offset over time, with its bound. ${values}`,
  ofEachFrame: (quantity: string, values: string) => `${quantity} of each frame over time. ${values}`,
  latency: (count: number, fromMs: number, toMs: number, mostMs: number) =>
    `Histogram of the application latency of ${format(count)} samples from ${format(fromMs)} to ${format(toMs, 'ms')}, most frequent at ${format(mostMs, 'ms')}.`,
};

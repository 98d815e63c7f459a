import { format } from '../numbers';

/** Text of the plots and the tables of all pages. */
export const plotMessages = {
  howToUse:
    'With a mouse, drag across a plot to zoom, double-click to reset the zoom, and point at a curve to read its values. '
    + 'On the keyboard, the arrow keys move the cursor, plus and minus zoom, and 0 resets the zoom. Click a name in a legend to show or hide its curve.',
  keys: 'The arrow keys move the cursor, plus and minus zoom, and 0 resets the zoom.',
  notMeasured: 'Not measured in this run.',
  partNotMeasured: (part: string) => `${part}: not measured in this run.`,
};

/** Captions and controls of plots. */
export const plotLabels = {
  plot: 'plot',
  numbers: 'Numbers of this plot',
  resetZoom: 'Reset zoom',
  bin: (from: string, to: string, samples: number, share: string) => `${from} to ${to}: ${samples} samples (${share})`,
};

/** Labels of the axes. */
export const axisLabels = {
  time: 'time',
  timeBeforeNow: 'time (s), 0 is now',
  latency: 'latency (ms)',
  applicationLatency: 'application latency (ms)',
  samples: 'samples',
  speed: 'speed (mm/s)',
  position: (unit: string) => `position (${unit})`,
  toolError: 'tool error (mm)',
  offset: 'offset (µs)',
  offsetError: 'offset error (µs)',
  clockBound: 'clock bound (µs)',
  renderTime: 'render time (ms)',
  visualisationLatency: 'L_visu (ms)',
  rate: 'rate (Hz)',
};

/** Labels of the curves. */
export const traceLabels = {
  uncompensated: 'uncompensated',
  compensated: 'compensated',
  equalError: 'equal error',
  truePose: 'where it was',
  groundTruth: 'ground truth',
  received: 'received',
  predicted: 'predicted',
  offset: 'offset',
  bound: 'bound (±)',
  negativeBound: 'bound, negative',
  error: 'error',
  applicationLatency: 'L_app',
  visualisationLatency: 'L_visu',
  renderTime: 'render time',
  limit: 'limit',
  roundTrip: 'round trip',
  shownHeadset: 'shown headset',
  controlClock: 'control clock',
  fastestSource: 'fastest source',
  slowestSource: 'slowest source',
};

/** Sentences about the values of plots, for their descriptions. `label` names a curve. */
export const plotValueMessages = {
  range: (label: string, from: string, to: string, rms: string) => `${label}: ${from} to ${to}, RMS ${rms}.`,
  latency: (label: string, from: string, to: string) => `${label}: latency ${from} to ${to}.`,
  none: (label: string) => `${label}: none.`,
  noAlarm: 'No alarm.',
  alarm: (from: string, to: string) => `Alarm from ${from} to ${to}.`,
};

/** Parts of the descriptions of the plots in the paper's figures. */
export const plotValueLabels = {
  range: (label: string, quantity: string, from: string, to: string) => `${label} ${quantity} from ${from} to ${to}`,
  none: (label: string) => `${label}: none`,
};

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

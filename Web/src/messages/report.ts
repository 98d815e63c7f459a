import { format } from '../numbers';

/** Address of the paper, which the pages show as a link. */
export const PAPER = 'https://doi.org/10.1007/s11740-022-01175-2';

const ARTICLE =
  'M. Schnierle, S. Röck, “Latency and sampling compensation in mixed-reality-in-the-loop simulations of production systems”, '
  + `Production Engineering (2022), ${PAPER}`;

/** References to the paper. */
export const paperLabels = { citation: (place: string) => `Schnierle & Röck 2022, ${place}`, figure: (number: string) => `Fig. ${number}` };

/** Credits for the method at the end of each page. */
export const creditMessages = {
  report: `Method: ${ARTICLE}. Made by Nowpose.`,
  figures: `The figures’ numbers and claims are those of ${ARTICLE} (CC BY 4.0). All data are computed by this run. Made by Nowpose.`,
  calibration: `The method is that of ${ARTICLE} (CC BY 4.0). Made by Nowpose.`,
};

/** Text of the report. */
export const reportMessages = {
  uncompensatedAndCompensated:
    'Uncompensated: the tool is drawn at the newest position that has arrived. Compensated: the tool is drawn '
    + 'at the position predicted for the time at which the light of the frame reaches the eye.',
  playback: 'The cell at one moment of the session. Plots and playback show the same moment.',
  toolError: (compensatedMm: number | null, heldMm: number | null) =>
    `The displayed tool is ${format(compensatedMm, 'mm')} from its true position; without compensation, the distance is ${format(heldMm, 'mm')}.`,
  workpieceError: (compensatedMm: number | null, heldMm: number | null) =>
    `The displayed workpieces are up to ${format(compensatedMm, 'mm')} from their true positions; without compensation, the distance is up to ${format(heldMm, 'mm')}.`,
  signals:
    'Signals of the cell. The upper bar of each shows when the signal was on, the lower bar when the headset displayed it as on. '
    + 'A change is displayed at its time, or later if its message arrives later.',
  pointsBeyond: (count: number) => `Points outside the plot: ${count}.`,
  errorBeyond: (extentUs: number, widestUs: number) =>
    `The plot shows errors up to ${format(extentUs, 'µs')}; the error or its bound reaches ${format(widestUs, 'µs')}.`,
};

/** Statements that the figures of the report support. */
export const claimMessages = {
  error: 'Without compensation, the displayed tool lags behind the robot. With compensation, it stays close to the robot.',
  joint: 'Samples arrive late and in steps. The prediction follows the true motion and deviates from it where the acceleration changes.',
  field:
    'The error is speed times latency. Compensation moves the operating points towards zero latency at the same speed, across the curves of equal error.',
  clock:
    'The headset estimates the offset between its clock and the control clock over the network, with an error bound; '
    + 'the paper reports less than 1 ms.',
  latency: 'The latency varies. Compensation uses the measured latency of each sample, not the mean.',
  range:
    'While frames are rendered within the limit, the visualisation latency stays as calibrated. Beyond it, frames miss the display’s '
    + 'refresh, which the headset reports (shaded).',
};

/** Places in the paper to which the figures of the report refer. */
export const claimSources = { error: 'Sect. 3', joint: 'Fig. 16', field: 'Fig. 18', clock: 'Fig. 8', latency: 'Eq. 2', range: 'Fig. 10' };

/** Titles of the figures of the report. */
export const claimTitles = {
  error: 'Tool error over time',
  joint: 'Joint position',
  jointNamed: (joint: string) => `Joint position: ${joint}`,
  field: 'Error field',
  clock: 'Clock synchronisation',
  latency: 'Application latency',
  range: 'Constant-latency range',
};

/** Captions of the report. */
export const reportLabels = {
  title: 'Nowpose report',
  result: 'Result',
  toolError: 'Tool error',
  comparison: 'Comparison',
  clock: 'Clock',
  display: 'Display',
  renderTime: 'Render time',
  visualisationLatency: 'Visualisation latency',
  conditions: 'Conditions and figures',
  settings: 'Settings',
  measured: 'Measured',
  playback: 'Playback',
  play: 'Play',
  pause: 'Pause',
  speed: 'Speed',
  lessError: 'less tool error with compensation',
  moreError: 'more tool error with compensation',
  latencyOfPoints: 'Latency of the operating points',
  moment: 'moment of the session',
  signals: 'Signals',
  on: 'on',
  off: 'off',
  valueUnknown: 'not known',
  displayedAndTrue: (displayed: string, truth: string) => `displayed ${displayed}, true ${truth}`,
};

/** Text of the paper's figures. */
export const figuresMessages = { notComputed: (figures: string) => `Not computed, because the run was interrupted: ${figures}.` };

/** Captions of the paper's figures and claims. */
export const figuresLabels = {
  contents: 'Contents',
  verdicts: 'Verdicts',
  conditionsOfAll: 'Conditions',
  figure: 'Figure',
  title: 'Shows',
  claim: 'Claim',
  paper: 'Paper',
  measured: 'Measured',
  verdict: 'Verdict',
  condition: 'Condition',
  paperSays: 'The paper says',
  weMeasure: 'We measure',
  beyond: 'Beyond the paper',
  dataFile: (file: string) => `Data, as in ${file}`,
  dataOf: (figure: string) => `Data of ${figure}`,
  claimsAndRun: 'The paper’s claims and this run',
  claims: 'Claims of the paper and whether they hold in this run',
  figures: 'Figures of the paper and whether their claims hold',
  conditions: 'Conditions of all figures unless stated otherwise',
};

/** Results of the criteria of a claim. */
export const criterionLabels = {
  met: 'met',
  notMet: 'not met',
  undecided: 'undecided',
  notMeasured: 'not measured',
  measured: (value: string) => `Measured: ${value}`,
};

/** Captions of the calibration page. */
export const calibrationLabels = {
  title: (title: string) => `${title} · Nowpose`,
  result: 'Result',
  facts: 'Result and conditions',
  numbers: 'Numbers',
};

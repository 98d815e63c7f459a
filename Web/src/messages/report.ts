import { format } from '../numbers';

/** Address of the paper, which the pages show as a link. */
export const PAPER = 'https://doi.org/10.1007/s11740-022-01175-2';

const ARTICLE =
  'M. Schnierle, S. Röck, “Latency and sampling compensation in mixed-reality-in-the-loop simulations of production systems”, '
  + `Production Engineering (2022), ${PAPER}`;

/** The source of the method, by page. */
export const creditMessages = {
  report: `Method: ${ARTICLE}. Made by Nowpose.`,
  figures: `The figures’ numbers and claims are those of ${ARTICLE} (CC BY 4.0). All data are computed by this run. Made by Nowpose.`,
  calibration: `The method is that of ${ARTICLE} (CC BY 4.0). Made by Nowpose.`,
};

/** Texts of the report. */
export const reportMessages = {
  uncompensatedAndCompensated:
    'Uncompensated: the tool is drawn at the newest position that has arrived. Compensated: it is drawn '
    + 'at the position predicted for the moment at which the light of the picture reaches the eye.',
  playback: 'The cell at one moment of the session; plots and playback move together.',
  toolError: (compensatedMm: number | null, heldMm: number | null) =>
    `The tool is drawn ${format(compensatedMm, 'mm')} from where it was; without compensation ${format(heldMm, 'mm')}.`,
  workpieceError: (compensatedMm: number | null, heldMm: number | null) =>
    `Workpieces: at most ${format(compensatedMm, 'mm')}, without compensation ${format(heldMm, 'mm')}.`,
  pointsBeyond: (count: number) => `${count} of the points lie beyond the plot.`,
  errorBeyond: (extentUs: number, widestUs: number) =>
    `The error is shown up to ${format(extentUs, 'µs')}; it or its bound reaches ${format(widestUs, 'µs')}.`,
};

/** The statements that the figures of the report show. */
export const claimMessages = {
  error: 'Without compensation, the displayed tool lags behind the robot. With compensation, it stays close to the robot.',
  joint: 'Samples arrive late and in steps; the prediction follows the ground truth and deviates where the acceleration changes.',
  field:
    'Error is speed times latency: compensation takes the operating points towards zero latency, across the curves of equal error, at the same speed.',
  clock:
    'The headset estimates the offset between its clock and the control clock over the network, with an error bound; '
    + 'the paper reports less than 1 ms.',
  latency: 'The latency varies: compensation uses the measured latency of each sample, not the mean.',
  range:
    'While frames are rendered within the limit, the visualisation latency stays as calibrated. Beyond it, frames miss the display’s '
    + 'refresh, which the headset reports (shaded).',
};

/** Captions of the report. */
export const reportLabels = {
  lessError: 'less tool error with compensation',
  moreError: 'more tool error with compensation',
  latencyOfPoints: 'Latency of the operating points',
  moment: 'moment of the session',
};

/** Texts of the paper's figures. */
export const figuresMessages = { notComputed: (figures: string) => `Not computed, because the run was interrupted: ${figures}.` };

/** Captions of the paper's figures and claims. */
export const figuresLabels = {
  claimsAndRun: 'The paper’s claims and this run',
  claims: 'Claims of the paper and whether they hold in this run',
  figures: 'Figures of the paper and whether their claims hold',
  conditions: 'Conditions of all figures, unless one says otherwise',
};

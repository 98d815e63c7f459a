/** A position in rad or m, and its time in seconds. */
export interface Point {
  time: number;
  position: number;
}

/** Order of the differences. A smooth motion with 10 samples or more per period has differences of this order below 7 % of its amplitude. */
const ORDER = 6;

/** Largest and smallest number of newest differences from which the noise is estimated. */
const MAX_DIFFERENCES = 12;
const MIN_DIFFERENCES = 8;

/**
 * Divisor that converts the largest difference to a resolution. Rounding errors have a standard deviation of 0.29 resolutions, and their differences
 * of order 6 have √924 times as much, 8.8 resolutions. This smaller value makes the estimate larger.
 */
const GAIN = 7;

/** Maximum number of newest intervals that the estimate uses. */
export const NOISE_INTERVALS = MAX_DIFFERENCES + ORDER - 1;

/**
 * Estimates the resolution of the newest positions of a motion from the part that a smooth motion does not explain: the largest difference of order 6,
 * computed from divided differences because the intervals may be unequal. Quantised positions give the quantum or more.
 * @returns The resolution in rad or m; null if the motion has too few samples.
 */
export function positionNoise(points: readonly Point[]): number | null {
  const newest = points.slice(-MAX_DIFFERENCES - ORDER);
  const count = newest.length - ORDER;
  if (count < MIN_DIFFERENCES) return null;
  return Math.max(...Array.from({ length: count }, (_, i) => Math.abs(difference(newest.slice(i, i + ORDER + 1))))) / GAIN;
}

/** Gets the difference of the order ORDER, which is the divided difference times ORDER! times the mean interval to the power of ORDER. */
function difference(points: readonly Point[]): number {
  const mean = (points[ORDER].time - points[0].time) / ORDER;
  let divided = points.map(({ position }) => position);
  for (let order = 1; order <= ORDER; order++)
    divided = divided.slice(1).map((value, i) => ((value - divided[i]) * order * mean) / (points[i + order].time - points[i].time));
  return divided[0];
}

/** Number of newest intervals from which the usual interval is estimated. */
const INTERVALS = 16;

/**
 * Ratio of the requested rate to the usual rate above which the rate is too low. A controller sends the data of every n-th cycle. Above 2, because
 * the intervals of exactly half the rate are rounded.
 */
const MIN_SLOWNESS = 2.1;

/** Estimates the usual interval between packages, and the number of missing packages. */
export class Pace {
  readonly #intervals: number[] = [];
  #last: number | null = null;

  /** The usual interval in seconds; null until enough packages have arrived. */
  get usual(): number | null {
    if (this.#intervals.length < INTERVALS) return null;
    return [...this.#intervals].sort((a, b) => a - b)[INTERVALS / 2];
  }

  /** Returns whether less than half of the requested packages arrive; false until enough have arrived. */
  isBelowHalfOf(requestedHz: number): boolean {
    return requestedHz * (this.usual ?? 0) > MIN_SLOWNESS;
  }

  /**
   * Adds a package.
   * @param timestamp Timestamp of the package, in seconds.
   * @returns Number of packages that are missing before this package.
   */
  lostBefore(timestamp: number): number {
    const interval = this.#last === null ? null : timestamp - this.#last;
    this.#last = timestamp;
    if (interval === null) return 0;
    const { usual } = this;
    this.#intervals.push(interval);
    if (this.#intervals.length > INTERVALS) this.#intervals.shift();
    return usual === null ? 0 : Math.max(0, Math.round(interval / usual) - 1);
  }
}

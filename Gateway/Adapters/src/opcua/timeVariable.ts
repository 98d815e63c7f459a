import type { Nanoseconds } from '../times';

/** Minimum number of stored times, for short notifications. */
const REMEMBERED = 64;

/** The time of a cycle. `label` is the server's time stamp of the time variable. */
export interface CycleTime {
  label: Nanoseconds;
  time: Nanoseconds;
}

/**
 * Stores the newest times from the time variable, each of which applies to the values of the same cycle. The server's time stamps, called labels,
 * identify the cycle: variables that are sampled together have equal time stamps, even if these are wrong.
 */
export class TimeVariable {
  /** In ascending order of the labels. */
  #known: CycleTime[] = [];
  /** Number of times in the newest notification with times. */
  #newest = 0;

  /** @param tolerance Maximum difference between the labels of one cycle. */
  constructor(readonly tolerance: Nanoseconds) {}

  /** Adds the times of one notification. Keeps those of the previous one, because the values of a cycle may arrive in another notification. */
  learn(times: CycleTime[]): void {
    if (times.length === 0) return;
    // Later labels are from before a step back of the server's clock.
    const earlier = this.#known.filter(({ label }) => label < times[0].label);
    this.#known = [...earlier.slice(-Math.max(REMEMBERED - times.length, this.#newest)), ...times];
    this.#newest = times.length;
  }

  /** Gets the time of the cycle with this label; null if it is unknown. */
  at(label: Nanoseconds): Nanoseconds | null {
    const known = this.#known;
    // Uses a binary search, because a notification may have thousands of cycles with the values of many nodes.
    let [first, end] = [0, known.length];
    while (first < end) {
      const middle = (first + end) >> 1;
      if (known[middle].label < label - this.tolerance) first = middle + 1;
      else end = middle;
    }
    let best: Nanoseconds | null = null;
    let distance = this.tolerance + 1n;
    for (let i = first; i < known.length && known[i].label <= label + this.tolerance; i++) {
      const apart = known[i].label < label ? label - known[i].label : known[i].label - label;
      if (apart < distance) [best, distance] = [known[i].time, apart];
    }
    return best;
  }
}

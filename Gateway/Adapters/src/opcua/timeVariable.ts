import type { Nanoseconds } from '../times';

const REMEMBERED = 64;

/**
 * Stores the newest times from the time variable, each of which applies to the values of the same cycle. The server's time stamps, called labels,
 * identify the cycle: variables that are sampled together have equal time stamps, even if these are wrong.
 */
export class TimeVariable {
  readonly #known: { label: Nanoseconds; time: Nanoseconds }[] = [];

  /** @param tolerance Maximum difference between the labels of one cycle. */
  constructor(readonly tolerance: Nanoseconds) {}

  learn(label: Nanoseconds, time: Nanoseconds): void {
    this.#known.push({ label, time });
    if (this.#known.length > REMEMBERED) this.#known.shift();
  }

  /** Gets the time of the cycle with this label; null if it is unknown. */
  at(label: Nanoseconds): Nanoseconds | null {
    let best: Nanoseconds | null = null;
    let distance = this.tolerance + 1n;
    for (const { label: known, time } of this.#known) {
      const apart = known < label ? label - known : known - label;
      if (apart < distance) [best, distance] = [time, apart];
    }
    return best;
  }
}

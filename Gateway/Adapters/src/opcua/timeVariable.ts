import type { Nanoseconds } from '../times';

const REMEMBERED = 64;

/**
 * The control system's time from a variable, to be assigned to the values of the same cycle. The cycle is identified by the server's time
 * stamps: variables that are sampled together have equal ones, even if they are wrong.
 */
export class TimeVariable {
  readonly #known: { label: Nanoseconds; time: Nanoseconds }[] = [];

  /** @param tolerance Maximum difference of the labels of one cycle. */
  constructor(readonly tolerance: Nanoseconds) {}

  learn(label: Nanoseconds, time: Nanoseconds): void {
    this.#known.push({ label, time });
    if (this.#known.length > REMEMBERED) this.#known.shift();
  }

  /** Gets the time of the cycle with this label; null if unknown. */
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

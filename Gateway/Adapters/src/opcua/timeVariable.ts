import type { Nanoseconds } from '../times';

const REMEMBERED = 64;

/**
 * The control system's time as a variable tells it, to be put beside the values of the same cycle. Which cycle that is, the server's time
 * stamps tell: of two variables that are sampled together they agree, however wrong they are.
 */
export class TimeVariable {
  readonly #known: { label: Nanoseconds; time: Nanoseconds }[] = [];

  /** @param tolerance How far the labels of one cycle may be apart. */
  constructor(readonly tolerance: Nanoseconds) {}

  learn(label: Nanoseconds, time: Nanoseconds): void {
    this.#known.push({ label, time });
    if (this.#known.length > REMEMBERED) this.#known.shift();
  }

  /** The time of the cycle of this label; null when it was not told. */
  at(label: Nanoseconds): Nanoseconds | null {
    let best: Nanoseconds | null = null, distance = this.tolerance + 1n;
    for (const { label: known, time } of this.#known) {
      const apart = known < label ? label - known : known - label;
      if (apart < distance) [best, distance] = [time, apart];
    }
    return best;
  }
}

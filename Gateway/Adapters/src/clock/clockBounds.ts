import { max, min, type Nanoseconds, NS_PER_S } from '../times';

/**
 * Minimum step that is reported: values with stamps that are ahead of the clock by more than this are refused, so those received before the step may
 * have been refused, or are in the future now.
 */
const MIN_STEP: Nanoseconds = NS_PER_S;

/** Maximum skew between a clock and this machine's counter. Headsets use the same limit. */
const MAX_SKEW_PPM = 700n;

/** Bounds of the offset of a clock to this machine's counter, from the times of requests and responses. Those of several readings are intersected. */
export class ClockBounds {
  /** Lower and upper bound of the clock's time minus the counter, and the counter at the newest reading. */
  #bounds: { low: Nanoseconds; high: Nanoseconds; at: Nanoseconds } | null = null;

  /** Estimated offset; null before the first reading. */
  get offset(): Nanoseconds | null {
    return this.#bounds === null ? null : (this.#bounds.low + this.#bounds.high) / 2n;
  }

  /**
   * Adds a reading. If it contradicts the earlier readings, these are discarded, because the clock has stepped or has been replaced.
   * @param received Time of the clock when it received the request.
   * @param sent Time of the clock when it sent the response.
   * @param asked Counter before the request.
   * @param heard Counter after the response.
   * @returns Whether the clock has stepped by more than a second.
   */
  observe(received: Nanoseconds, sent: Nanoseconds, asked: Nanoseconds, heard: Nanoseconds): boolean {
    let [low, high] = [sent - heard, received - asked];
    let step = 0n;
    if (this.#bounds !== null) {
      const change = ((heard - this.#bounds.at) * MAX_SKEW_PPM) / 1_000_000n;
      const [oldLow, oldHigh] = [this.#bounds.low - change, this.#bounds.high + change];
      step = low > oldHigh ? low - oldHigh : oldLow - high;
      if (step <= 0n) [low, high] = [max(low, oldLow), min(high, oldHigh)];
    }
    this.#bounds = { low, high, at: heard };
    return step > MIN_STEP;
  }

  /** Discards all readings. */
  forget(): void {
    this.#bounds = null;
  }
}

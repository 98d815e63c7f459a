import { pause } from '../backoff';
import type { GatewayLink } from '../gateway/link';
import { type Nanoseconds, NS_PER_S, ofRosTime } from '../times';

const GET_TIME = '/rosapi/get_time';
const EVERY_MS = 1000;
const RETRY_MS = 200;

/**
 * Minimum step that is reported: values with stamps that are ahead of the control clock by more than this are refused, so those received before the step
 * may have been refused, or are in the future now.
 */
const MIN_STEP: Nanoseconds = NS_PER_S;

/** Maximum skew between the control clock and this machine's counter. Headsets use the same limit. */
const MAX_SKEW_PPM = 700n;

/**
 * The gateway's control clock, read from the gateway. The times of request and response bound the offset of the control clock to this machine's
 * counter. The bounds of several readings are intersected.
 */
export class GatewayClock {
  /** Lower and upper bound of control time minus counter, and the counter at the newest reading. */
  #bounds: { low: Nanoseconds; high: Nanoseconds; at: Nanoseconds } | null = null;

  /**
   * @param counter Monotonic clock of this machine, ns.
   * @param stepped Called after the control clock has stepped, or another clock has become the control clock.
   */
  constructor(
    readonly gateway: Pick<GatewayLink, 'call'>,
    readonly counter: () => Nanoseconds,
    readonly stepped: () => void = () => {},
  ) {}

  /** The current control time; null before the first reading. */
  get now(): Nanoseconds | null {
    return this.#bounds === null ? null : this.counter() + (this.#bounds.low + this.#bounds.high) / 2n;
  }

  /**
   * Reads the clock once per second until the signal is aborted.
   * @param first Called after each successful reading.
   */
  async run(stop: AbortSignal, first: () => void): Promise<void> {
    while (!stop.aborted) {
      const isRead = await this.#read();
      if (isRead) first();
      await pause(isRead ? EVERY_MS : RETRY_MS, stop);
    }
  }

  /**
   * Adds a reading. If it contradicts the earlier readings, these are discarded, because the control clock has stepped or another clock has become
   * the control clock.
   * @param asked Counter before the request.
   * @param heard Counter after the response.
   */
  observe(time: Nanoseconds, asked: Nanoseconds, heard: Nanoseconds): void {
    let [low, high] = [time - heard, time - asked];
    let step = 0n;
    if (this.#bounds !== null) {
      const change = ((heard - this.#bounds.at) * MAX_SKEW_PPM) / 1_000_000n;
      const [oldLow, oldHigh] = [this.#bounds.low - change, this.#bounds.high + change];
      step = low > oldHigh ? low - oldHigh : oldLow - high;
      if (step <= 0n) [low, high] = [low > oldLow ? low : oldLow, high < oldHigh ? high : oldHigh];
    }
    this.#bounds = { low, high, at: heard };
    if (step > MIN_STEP) this.stepped();
  }

  async #read(): Promise<boolean> {
    try {
      const asked = this.counter();
      const { time } = await this.gateway.call(GET_TIME);
      const now = ofRosTime(time);
      if (now === null || now < NS_PER_S) return false;
      this.observe(now, asked, this.counter());
      return true;
    } catch {
      // The gateway is disconnected. Its link reports this.
      return false;
    }
  }
}

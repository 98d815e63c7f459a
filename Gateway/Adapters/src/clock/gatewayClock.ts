import { pause } from '../backoff';
import type { GatewayLink } from '../gateway/link';
import { type Nanoseconds, NS_PER_S, ofRosTime } from '../times';
import { ClockBounds } from './clockBounds';

const GET_TIME = '/rosapi/get_time';
const EVERY_MS = 1000;
const RETRY_MS = 200;

/** The gateway's control clock, read from the gateway. */
export class GatewayClock {
  readonly #bounds = new ClockBounds();

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
    const { offset } = this.#bounds;
    return offset === null ? null : this.counter() + offset;
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
   * Adds a reading.
   * @param asked Counter before the request.
   * @param heard Counter after the response.
   */
  observe(time: Nanoseconds, asked: Nanoseconds, heard: Nanoseconds): void {
    if (this.#bounds.observe(time, time, asked, heard)) this.stepped();
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

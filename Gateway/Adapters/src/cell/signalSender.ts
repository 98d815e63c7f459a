import type { OfferedClock } from '../clock/offeredClock';
import type { Publisher } from '../gateway/link';
import type { Nanoseconds } from '../times';
import { SIGNALS, signals } from './messages';

/**
 * After each connection, a gateway drops signals until it has measured the clock of their stamps, which takes up to 20 s. Therefore all signals
 * are repeated for REPEATED_MS, at the interval REPEAT_EVERY_MS.
 */
const REPEATED_MS = 30_000;
const REPEAT_EVERY_MS = 1000;

interface Change {
  value: number;
  stamp: Nanoseconds;
}

/** Sends each change of a signal as soon as the clock of its stamp is known, and repeats all signals after a new connection. */
export class SignalSender {
  readonly #newest = new Map<string, Change>();
  /** Signals with a change that has not been sent yet. */
  readonly #pending = new Set<string>();
  #repeatedUntil = 0;
  #repeated = 0;

  /**
   * @param sent Called after each message.
   * @param counter Monotonic clock in ms.
   */
  constructor(
    readonly clock: Pick<OfferedClock, 'isSettled'>,
    readonly gateway: Publisher,
    readonly sent: () => void,
    readonly counter: () => number,
  ) {}

  valueOf(name: string): number | undefined {
    return this.#newest.get(name)?.value;
  }

  add(name: string, value: number, stamp: Nanoseconds): void {
    this.#newest.set(name, { value, stamp });
    this.#pending.add(name);
    this.#send();
  }

  /** Discards all values, so that the next value of each signal is sent even if it is equal. */
  forget(): void {
    this.#newest.clear();
    this.#pending.clear();
  }

  /** Sends all signals again, repeatedly for some time. Called for each new connection to the gateway. */
  connected(): void {
    this.#repeatedUntil = this.counter() + REPEATED_MS;
    this.#repeat();
  }

  /** Sends changes that have waited for the clock, and repetitions that are due. Called several times per second. */
  check(): void {
    const now = this.counter();
    if (now < this.#repeatedUntil && now - this.#repeated >= REPEAT_EVERY_MS) this.#repeat();
    else this.#send();
  }

  #repeat(): void {
    this.#repeated = this.counter();
    for (const name of this.#newest.keys()) this.#pending.add(name);
    this.#send();
  }

  /** Sends the pending changes. Changes with equal stamps are sent in one message. */
  #send(): void {
    if (this.#pending.size === 0 || !this.clock.isSettled) return;
    const changes = [...this.#pending].map(name => ({ name, ...this.#newest.get(name)! }));
    this.#pending.clear();
    for (const stamp of new Set(changes.map(change => change.stamp))) {
      const together = changes.filter(change => change.stamp === stamp);
      this.gateway.publish(
        SIGNALS,
        signals(
          stamp,
          together.map(({ name }) => name),
          together.map(({ value }) => value),
        ),
      );
      this.sent();
    }
  }
}

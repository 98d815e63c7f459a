import type { PlantClock } from '../clock/plantClock';
import type { Nanoseconds } from '../times';
import { SIGNALS, signals } from './messages';

/**
 * A gateway drops stamps until it has measured this clock, which takes up to 20 s after each connection. So the signals are repeated for this
 * time, at this interval.
 */
const REPEATED_MS = 30_000;
const REPEAT_EVERY_MS = 1000;

interface Change {
  value: number;
  stamp: Nanoseconds;
}

/** Sends each change of a signal once, as soon as the clock of its stamp is known, and all signals again to a new connection. */
export class SignalSender {
  readonly #newest = new Map<string, Change>();
  /** Signals with a change that is not sent yet. */
  readonly #pending = new Set<string>();
  #repeatedUntil = 0;
  #repeated = 0;

  /**
   * @param sent Called after each message.
   * @param counter Monotonic time in ms.
   */
  constructor(
    readonly clock: Pick<PlantClock, 'isSettled'>,
    readonly gateway: { publish(topic: string, msg: object): void },
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

  /** Discards all values, so that the next ones are sent again. */
  forget(): void {
    this.#newest.clear();
    this.#pending.clear();
  }

  /** Reports a new connection to the gateway, which has no values of these signals. */
  connected(): void {
    this.#repeatedUntil = this.counter() + REPEATED_MS;
    this.#repeat();
  }

  /** Sends what waits for the clock or for its repetition; called several times a second. */
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

  /** Sends the pending changes, those of one stamp in one message. */
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

import type { OfferedClock } from '../clock/offeredClock';
import { REFUSED_EVERY_MS } from '../gateway/keptMessages';
import type { LinkEvents, Publisher } from '../gateway/link';
import { type Nanoseconds, NS_PER_S } from '../times';
import { MAX_SIGNALS, SIGNALS, signals } from './messages';

/**
 * After each connection, a gateway drops signals until it has measured the clock of their stamps, which takes up to 20 s. Therefore all signals
 * are repeated for REPEATED_MS, at the interval REPEAT_EVERY_MS. Later, they are repeated at the interval REFUSED_EVERY_MS while the gateway refuses
 * signals: the refusal may be permanent.
 */
const REPEATED_MS = 30_000;
const REPEAT_EVERY_MS = 1000;

/** Maximum time by which a late value is older than the newest one. An older stamp shows that the clock of the source went back. */
const MAX_LATENESS: Nanoseconds = NS_PER_S;

/** Whether a value of a signal is not the newest one, because a newer one has overtaken it. */
export const isLate = (stamp: Nanoseconds, newest: Nanoseconds): boolean => stamp < newest && newest - stamp <= MAX_LATENESS;

interface Change {
  value: number;
  stamp: Nanoseconds;
}

/**
 * Sends the changes of signals as soon as the clock of their stamps is known and the connection has room. Until then, only the newest value of each
 * signal is kept, so a short pulse can be lost. Repeats all signals after a new connection, and as long as the gateway refuses signals.
 */
export class SignalSender implements LinkEvents {
  readonly #newest = new Map<string, Change>();
  /** Signals with a change that has not been sent yet. */
  readonly #pending = new Set<string>();
  #repeatedUntil = 0;
  #repeated = 0;
  /** Whether the gateway has refused a signal since the last repetition. */
  #isRefused = false;

  /**
   * @param sent Called after each message.
   * @param counter Monotonic clock in ms.
   */
  constructor(
    readonly clock: Pick<OfferedClock, 'isSettled'>,
    readonly gateway: Pick<Publisher, 'publishNewest'>,
    readonly sent: () => void,
    readonly counter: () => number,
  ) {}

  valueOf(name: string): number | undefined {
    return this.#newest.get(name)?.value;
  }

  /** Adds a value. Ignores a late one. */
  add(name: string, value: number, stamp: Nanoseconds): void {
    const newest = this.#newest.get(name);
    if (newest !== undefined && isLate(stamp, newest.stamp)) return;
    this.#newest.set(name, { value, stamp });
    this.#pending.add(name);
    this.#send();
  }

  /** Discards the value of a signal, so that the next one is sent even if it is equal. */
  forget(name: string): void {
    this.#newest.delete(name);
    this.#pending.delete(name);
  }

  /** Sends all signals again, repeatedly for some time. Called for each new connection to the gateway. */
  readonly opened = (): void => {
    this.#repeatedUntil = this.counter() + REPEATED_MS;
    this.#repeat();
  };

  /** Schedules a repetition if the gateway has refused signals, which may have another reason than the measurement after a new connection. */
  readonly refused = (reason: string): void => {
    this.#isRefused ||= reason.includes(SIGNALS);
  };

  /** Sends changes that have waited for the clock, and repetitions that are due. Called several times per second. */
  check(): void {
    const now = this.counter();
    const isNew = now < this.#repeatedUntil;
    if ((isNew || this.#isRefused) && now - this.#repeated >= (isNew ? REPEAT_EVERY_MS : REFUSED_EVERY_MS)) this.#repeat();
    else this.#send();
  }

  #repeat(): void {
    this.#repeated = this.counter();
    this.#isRefused = false;
    for (const name of this.#newest.keys()) this.#pending.add(name);
    this.#send();
  }

  #send(): void {
    if (this.#pending.size > 0 && this.clock.isSettled) this.gateway.publishNewest(SIGNALS, () => this.#next());
  }

  /** Creates the next message, which has pending changes with the same stamp; null if there is none. */
  #next(): object | null {
    const [first] = this.#pending;
    if (first === undefined) return null;
    const { stamp } = this.#newest.get(first)!;
    const together = [...this.#pending].filter(name => this.#newest.get(name)!.stamp === stamp).slice(0, MAX_SIGNALS);
    for (const name of together) this.#pending.delete(name);
    this.sent();
    return signals(
      stamp,
      together,
      together.map(name => this.#newest.get(name)!.value),
    );
  }
}

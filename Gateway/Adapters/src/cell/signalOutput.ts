import type { PlantClock } from '../clock/plantClock';
import type { Signal } from '../configuration/signals';
import type { AdapterStatus } from '../gateway/status';
import { numberIn } from '../samples/number';
import type { PlantValue } from '../samples/plantOutput';
import { Silence } from '../samples/silence';
import { type Refusal, StampRule } from '../samples/stampRule';
import type { Nanoseconds } from '../times';
import { SIGNALS, signals } from './messages';

/** The value of a signal may have changed at any time in the past. */
const ANY_AGE: Nanoseconds = 1n << 80n;

/**
 * A gateway drops stamps until it has measured this clock, which takes up to 20 s after each connection. So the signals are repeated for this
 * time, at this interval.
 */
const REPEATED_MS = 30_000;
const REPEAT_EVERY_MS = 1000;

interface Publisher {
  publish(topic: string, msg: object): void;
}

interface Change {
  stamp: Nanoseconds;
  value: number;
}

/** Creates the signals from a plant's values. A signal is published when it changes, with the stamp of the change. */
export class SignalOutput {
  readonly #rule: StampRule;
  /** The newest value of each signal; null before the first. */
  readonly #known: (Change | null)[];
  /** Signals whose newest value was valid, so that it can be confirmed. */
  readonly #valid = new Set<number>();
  /** Signals with a change that is not published yet. */
  readonly #pending = new Set<number>();
  #repeatedUntil = 0;
  #repeated = 0;
  readonly silence: Silence;

  /**
   * @param offset Index of the value of the first signal; the others follow.
   * @param counter Monotonic time in ms; this machine's by default.
   */
  constructor(
    readonly signals: Signal[],
    readonly offset: number,
    readonly clock: Pick<PlantClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    readonly counter: () => number = () => performance.now(),
  ) {
    this.#rule = new StampRule(signals.length, ANY_AGE);
    this.#known = Array<Change | null>(signals.length).fill(null);
    this.silence = new Silence(status, () => null, counter, status.signals);
    for (const { signal } of signals) status.signals.expect(signal);
  }

  /** Publishes the changes among values that arrived together; for each signal, the oldest comes first. */
  publish(values: PlantValue[]): void {
    for (const value of values) {
      this.#take(value);
      // Two changes of one signal must not replace each other.
      this.#send();
    }
  }

  /** Confirms that the signals have their last value, except for those of some values. */
  hold(except: ReadonlySet<number>): void {
    for (const i of this.#valid) if (!except.has(i + this.offset)) this.silence.heard(this.signals[i].signal);
  }

  /** Publishes what waits for the clock, and repeats all signals for a gateway that was connected recently. */
  check(): void {
    // A source that cannot confirm a signal is silent until it changes.
    if (this.silence.unconfirmedMs !== null) this.silence.check();
    const now = this.counter();
    if (now < this.#repeatedUntil && now - this.#repeated >= REPEAT_EVERY_MS) this.#repeat(now);
    this.#send();
  }

  /** Reports a new connection to the gateway, which has no values of these signals. */
  connected(): void {
    this.#repeatedUntil = this.counter() + REPEATED_MS;
    this.#repeat(this.counter());
  }

  /** Reports that the source no longer has this value. */
  lose(value: number, reason: string): void {
    this.#valid.delete(value - this.offset);
    this.status.signals.fault(this.#nameOf(value), reason);
  }

  /** Counts a value that is invalid. The signal keeps its last valid value, and its state says so. */
  refuse(value: number, { reason, text }: Refusal): void {
    this.#valid.delete(value - this.offset);
    this.status.refuse(reason, this.#nameOf(value), text, this.status.signals);
  }

  #nameOf(value: number): string {
    return this.signals[value - this.offset].signal;
  }

  #repeat(now: number): void {
    this.#repeated = now;
    this.#known.forEach((known, i) => known !== null && this.#pending.add(i));
  }

  #take({ index, value, stamp, isFirst, refusal, isLost }: PlantValue): void {
    if (refusal !== undefined && isLost === true) {
      this.status.count(refusal.reason);
      return this.lose(index, refusal.text);
    }
    const number = refusal ?? numberIn(typeof value === 'boolean' ? Number(value) : value);
    if (typeof number !== 'number') return this.refuse(index, number);
    const i = index - this.offset;
    const known = this.#known[i];
    const { now } = this.clock;
    const name = this.signals[i].signal;
    if (known?.value !== number) {
      // The stamp of a first value may be missing; at this time, the signal certainly has the value.
      const at = stamp === null && isFirst === true ? now : stamp;
      const trouble = this.#rule.judge(i, at, now);
      if (trouble !== null) return this.refuse(index, trouble);
      this.#known[i] = { stamp: at!, value: number };
      this.#pending.add(i);
    }
    this.#valid.add(i);
    this.status.accept(name);
    this.silence.heard(name);
  }

  /** Publishes the pending changes, those of one stamp in one message. */
  #send(): void {
    if (this.#pending.size === 0 || !this.clock.isSettled) return;
    const changes = [...this.#pending].map(i => ({ ...this.#known[i]!, name: this.signals[i].signal }));
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
      this.status.sampled();
    }
  }
}

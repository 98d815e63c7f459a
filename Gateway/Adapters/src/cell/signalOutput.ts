import type { PlantClock } from '../clock/plantClock';
import type { Signal } from '../configuration/signals';
import type { AdapterStatus } from '../gateway/status';
import { numberIn } from '../samples/number';
import type { PlantValue } from '../samples/plantOutput';
import { Silence } from '../samples/silence';
import { type Refusal, StampRule } from '../samples/stampRule';
import type { Nanoseconds } from '../times';
import { SignalSender } from './signalSender';

/** The value of a signal may have changed at any time in the past. */
const ANY_AGE: Nanoseconds = 1n << 80n;

interface Publisher {
  publish(topic: string, msg: object): void;
}

/** Creates the signals from a plant's values. A signal is published when it changes, with the stamp of the change. */
export class SignalOutput {
  #rule: StampRule;
  readonly sender: SignalSender;
  /** Signals whose newest value was valid, so that it can be confirmed. */
  readonly #valid = new Set<number>();
  readonly silence: Silence;

  /**
   * @param offset Index of the value of the first signal; the others follow.
   * @param counter Monotonic time in ms; this machine's by default.
   */
  constructor(
    readonly signals: Signal[],
    readonly offset: number,
    readonly clock: Pick<PlantClock, 'now' | 'isSettled'>,
    gateway: Publisher,
    readonly status: AdapterStatus,
    counter: () => number = () => performance.now(),
  ) {
    this.#rule = new StampRule(signals.length, ANY_AGE);
    this.sender = new SignalSender(clock, gateway, () => status.sampled(), counter);
    this.silence = new Silence(status, () => null, counter, status.signals);
    for (const { signal } of signals) status.signals.expect(signal);
  }

  /** Starts a new connection: values and the zero of the control clock may have changed in between. */
  startAnew(): void {
    this.#rule = new StampRule(this.signals.length, ANY_AGE);
    this.#valid.clear();
    this.sender.forget();
  }

  /** Publishes the changes among values that arrived together; for each signal, the oldest comes first. */
  publish(values: PlantValue[]): void {
    for (const value of values) this.#take(value);
  }

  /** Confirms that the signals have their last value, except for those of some values. */
  hold(except: ReadonlySet<number>): void {
    for (const i of this.#valid) if (!except.has(i + this.offset)) this.silence.heard(this.signals[i].signal);
  }

  /** Sets the state of signals that were silent for too long, and publishes what waits for the clock. */
  check(): void {
    // A source that cannot confirm a signal is silent until it changes.
    if (this.silence.unconfirmedMs !== null) this.silence.check();
    this.sender.check();
  }

  /** Reports that the source no longer has this value. */
  lose(value: number, reason: string): void {
    this.#valid.delete(value - this.offset);
    this.status.signals.fault(this.#nameOf(value), reason);
  }

  /** Counts a value that is invalid. The signal keeps its last valid value, and its state shows that the newest value is invalid. */
  refuse(value: number, { reason, text }: Refusal): void {
    this.#valid.delete(value - this.offset);
    this.status.refuse(reason, this.#nameOf(value), text, this.status.signals);
  }

  #nameOf(value: number): string {
    return this.signals[value - this.offset].signal;
  }

  #take({ index, value, stamp, isFirst, refusal, isLost }: PlantValue): void {
    if (refusal !== undefined && isLost === true) {
      this.status.count(refusal.reason);
      return this.lose(index, refusal.text);
    }
    const number = refusal ?? numberIn(typeof value === 'boolean' ? Number(value) : value);
    if (typeof number !== 'number') return this.refuse(index, number);
    const i = index - this.offset;
    const { now } = this.clock;
    const name = this.signals[i].signal;
    if (this.sender.valueOf(name) !== number) {
      // The stamp of a first value may be missing; at this time, the signal certainly has the value.
      const at = stamp === null && isFirst === true ? now : stamp;
      const trouble = this.#rule.judge(i, at, now);
      if (trouble !== null) return this.refuse(index, trouble);
      this.sender.add(name, number, at!);
    }
    this.#valid.add(i);
    this.status.accept(name);
    this.silence.heard(name);
  }
}

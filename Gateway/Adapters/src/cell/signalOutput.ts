import type { OfferedClock } from '../clock/offeredClock';
import type { EntryOf } from '../configuration/plantFile';
import type { Publisher } from '../gateway/link';
import type { AdapterStatus } from '../gateway/status';
import { bitIn, numberIn } from '../samples/number';
import type { PlantValue } from '../samples/plantOutput';
import { SampleSilence } from '../samples/sampleSilence';
import { type Refusal, StampRule } from '../samples/stampRule';
import type { Nanoseconds } from '../times';
import { SignalSender } from './signalSender';

/** Maximum age of a stamp: unlimited, because a signal may have changed at any time in the past. */
const ANY_AGE: Nanoseconds = 1n << 80n;

/** Publishes the signals from a plant's values. A signal is published when its value changes, with the stamp of the change. */
export class SignalOutput {
  #rules: StampRule[] = [];
  readonly sender: SignalSender;
  /** Signals whose newest value is valid. Only these can be confirmed. */
  readonly #valid = new Set<number>();
  /** Signals whose newest value has a stamp from before a step of the control clock. */
  readonly #outdated = new Set<number>();
  readonly silence: SampleSilence;

  /**
   * @param offset Index of the first signal's value. The values of the other signals follow it.
   * @param counter Monotonic clock in ms; by default, the clock of this machine.
   */
  constructor(
    readonly signals: EntryOf<'signals'>[],
    readonly offset: number,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    gateway: Publisher,
    readonly status: AdapterStatus,
    counter: () => number = () => performance.now(),
  ) {
    this.#forgetStamps();
    this.sender = new SignalSender(clock, gateway, () => status.sampled(), counter);
    this.silence = new SampleSilence(status, () => null, counter, status.signals);
    for (const { signal } of signals) status.signals.expect(signal);
  }

  /** Prepares for a new connection. Values and the origin of the control clock may have changed since the previous one. */
  restart(): void {
    this.#forgetStamps();
    this.#valid.clear();
    for (const { signal } of this.signals) this.sender.forget(signal);
  }

  /** Prepares for stamps of a control clock that has stepped. The next value of each signal is sent even if it is equal; until then, it keeps its value. */
  clockStepped(): void {
    this.#forgetStamps();
    for (const i of this.signals.keys()) this.#outdated.add(i);
  }

  /** Publishes the changes among values that arrived together. Several values of one signal are sorted, the oldest first. */
  publish(values: PlantValue[]): void {
    for (const value of values) this.#take(value);
  }

  /**
   * Confirms that the signals still have their last values. After a step of the control clock, these are sent with the new time.
   * @param time Control time up to which all changes are known.
   * @param except Indices of values that have changed, or may have changed.
   */
  hold(time: Nanoseconds, except: ReadonlySet<number>): void {
    for (const i of this.#valid) {
      if (except.has(i + this.offset)) continue;
      const { signal } = this.signals[i];
      // Until the first value after the step, `time` is a stamp of the previous clock.
      const isRenewed = this.#outdated.has(i) && this.#rules[i].judge(time, this.clock.now) === null;
      if (isRenewed) this.#send(i, this.sender.valueOf(signal)!, time);
      this.silence.heard(signal);
    }
  }

  /** Updates the state of signals that have been silent for too long, and publishes signals that waited for the clock. */
  check(): void {
    // Checks for silent signals only if the source confirms unchanged values. Any other source sends nothing until a signal changes.
    if (this.silence.unconfirmedMs !== null) this.silence.check();
    this.sender.check();
  }

  /** Reports that the plant no longer has this value. */
  lose(value: number, refusal: Refusal): void {
    this.#valid.delete(value - this.offset);
    this.status.signals.fault(this.#nameOf(value), refusal);
  }

  /** Sets the reason why a signal is not published yet. */
  explain(value: number, reason: Refusal): void {
    this.status.signals.explain(this.#nameOf(value), reason);
  }

  /** Counts an invalid value. The signal keeps its last valid value, and its state shows that the newest value is invalid. */
  refuse(value: number, { reason, text }: Refusal): void {
    this.#valid.delete(value - this.offset);
    this.status.refuse(reason, this.#nameOf(value), text, this.status.signals);
  }

  #forgetStamps(): void {
    this.#rules = this.signals.map(() => new StampRule(ANY_AGE));
  }

  #nameOf(value: number): string {
    return this.signals[value - this.offset].signal;
  }

  #take({ index, value, stamp, isFirst, refusal, isLost }: PlantValue): void {
    if (refusal !== undefined && isLost === true) return this.lose(index, refusal);
    const i = index - this.offset;
    const { signal: name, bit } = this.signals[i];
    const raw = typeof value === 'boolean' ? Number(value) : value;
    const number = refusal ?? (bit === undefined ? numberIn(raw) : bitIn(raw, bit));
    if (typeof number !== 'number') return this.refuse(index, number);
    const { now } = this.clock;
    if (this.#outdated.has(i) || this.sender.valueOf(name) !== number) {
      // Uses the current time for a first value without a stamp, because the signal certainly has the value at this time.
      const at = stamp === null && isFirst === true ? now : stamp;
      const trouble = this.#rules[i].judge(at, now);
      if (trouble !== null) return this.refuse(index, trouble);
      this.#send(i, number, at!);
    }
    this.#valid.add(i);
    this.status.accept(name);
    this.silence.heard(name);
  }

  #send(i: number, value: number, stamp: Nanoseconds): void {
    const { signal } = this.signals[i];
    // Otherwise, a stamp of the stepped clock could count as late.
    if (this.#outdated.delete(i)) this.sender.forget(signal);
    this.sender.add(signal, value, stamp);
  }
}

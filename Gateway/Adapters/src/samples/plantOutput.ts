import { PoseOutput } from '../cell/poseOutput';
import { SignalOutput } from '../cell/signalOutput';
import type { OfferedClock } from '../clock/offeredClock';
import type { Configuration } from '../configuration/configuration';
import type { Publisher } from '../gateway/link';
import { withStampDelay } from '../gateway/stampDelay';
import type { AdapterStatus } from '../gateway/status';
import type { Nanoseconds } from '../times';
import { JointOutput, type JointOutputOptions } from './jointOutput';
import type { SourceStop } from './jointTrack';
import { SampleRepeater } from './sampleRepeater';
import type { Refusal } from './stampRule';

/** A value from the control system. */
export interface PlantValue {
  /** Index among the configured values: first those of the joints, then of the frames, then of the signals. */
  index: number;
  value: unknown;
  /** Velocity of a joint in the unit of the control system; absent if the control system does not provide it. */
  velocity?: number;
  /** Time stamp; null if the value has no readable one. */
  stamp: Nanoseconds | null;
  /** Whether this is the first value of a connection, or the first one after bad ones. Its stamp may be old. */
  isFirst?: boolean;
  /** The reason why the value is unusable; absent for a usable value. */
  refusal?: Refusal;
  /** Whether the control system no longer has the variable. `refusal` then contains the reason, which the caller has counted. */
  isLost?: boolean;
}

interface PlantOutputOptions extends JointOutputOptions {
  /** Age of the values at the time of their stamps; absent if it is 0. */
  stampDelay?: Nanoseconds;
}

/** Publishes joint states, poses and signals from a plant's values. */
export class PlantOutput {
  readonly joints: JointOutput;
  readonly frames: PoseOutput;
  readonly signals: SignalOutput;
  readonly repeater: SampleRepeater;
  /** Publishes joint states, transforms and signals with the time at which their values were measured. */
  readonly stamped: Publisher;
  /** Index of the first value of a frame, and of the first value of a signal. */
  readonly #firstOfFrames: number;
  readonly #firstOfSignals: number;

  /** @param counter Monotonic clock in ms; by default, the clock of this machine. */
  constructor(
    { joints, frames, wholeFrames, signals, values }: Pick<Configuration, 'joints' | 'frames' | 'wholeFrames' | 'signals' | 'values'>,
    options: PlantOutputOptions,
    clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    gateway: Publisher,
    status: AdapterStatus,
    counter?: () => number,
  ) {
    this.#firstOfFrames = joints.length;
    this.#firstOfSignals = values.length - signals.length;
    const labels = values.map(({ label }) => label);
    this.stamped = withStampDelay(gateway, options.stampDelay ?? 0n);
    this.joints = new JointOutput(joints, options, clock, this.stamped, status, counter);
    this.frames = new PoseOutput(frames, wholeFrames, labels, options, clock, this.stamped, status, counter);
    this.signals = new SignalOutput(signals, this.#firstOfSignals, clock, this.stamped, status, counter);
    // Repeats messages as they were published.
    this.repeater = new SampleRepeater(status, gateway, () => this.joints.silence.unconfirmedMs !== null, counter);
    for (const { joint } of joints) status.joints.expect(joint);
  }

  /** Publishes values that arrived together. Several values with the same index are sorted, the oldest first. */
  publish(values: PlantValue[]): void {
    for (const output of [this.joints, this.frames, this.signals]) output.publish(values.filter(({ index }) => this.#outputOf(index) === output));
  }

  /**
   * Confirms unchanged values, for a plant that sends only changes.
   * @param time Control time up to which all changes have been passed to `publish`.
   * @param silence Maximum interval between the samples of a moving joint or frame.
   * @param except Values that have changed since, or that may have changed.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, except: ReadonlySet<number> = new Set()): void {
    this.joints.hold(time, silence, except);
    this.frames.hold(time, silence, except);
    this.signals.hold(time, except);
  }

  /**
   * Updates the state of joints, frames and signals that have been silent for too long. Publishes signals that waited for the clock, and samples at rest
   * that the gateway may not have received.
   */
  check(): void {
    this.joints.checkSilence();
    this.frames.checkSilence();
    this.signals.check();
    this.repeater.check();
  }

  /** Prepares for a new connection. */
  restart(): void {
    this.joints.restart();
    this.frames.restart();
    this.signals.restart();
    this.repeater.forget();
  }

  /** Prepares for values with stamps of a control clock that has stepped. The source may not send its values again. */
  clockStepped(): void {
    this.joints.clockStepped();
    this.frames.clockStepped();
    this.signals.clockStepped();
    this.repeater.forget();
  }

  /** Reports that the control system no longer has this variable. */
  lose(index: number, refusal: Refusal): void {
    this.#outputOf(index).lose(index, refusal);
  }

  /** Counts an unusable value. */
  refuse(index: number, refusal: Refusal): void {
    this.#outputOf(index).refuse(index, refusal);
  }

  /** Whether the value belongs to a joint whose data ended during a motion, or to a frame whose data ended. */
  hasEnded(index: number): boolean {
    return index < this.#firstOfFrames ? this.joints.hasEnded(index) : this.frames.hasEnded(index);
  }

  /**
   * Sets the function that returns the phase in which the source stopped writing a value. It returns null if the source has not stopped, or if this
   * is unknown.
   */
  set sourceStopOf(stopOf: (index: number) => SourceStop | null) {
    this.joints.sourceStopOf = this.frames.sourceStopOf = stopOf;
  }

  /** Sets the sampling interval of the source in seconds. */
  set samplingS(seconds: number) {
    this.joints.samplingS = this.frames.states.samplingS = seconds;
  }

  /** Sets the reason why a joint, frame or signal that is neither live nor at rest is not published yet. */
  explain(index: number, reason: Refusal): void {
    this.#outputOf(index).explain(index, reason);
  }

  /** Whether the value belongs to a signal. */
  isSignal(index: number): boolean {
    return index >= this.#firstOfSignals;
  }

  /** Sets the time in ms without a confirmation after which a value has a fault; null if the control system does not confirm values. */
  set unconfirmedMs(ms: number | null) {
    for (const { silence } of [this.joints, this.frames, this.signals]) silence.unconfirmedMs = ms;
  }

  #outputOf(index: number): JointOutput | PoseOutput | SignalOutput {
    if (index < this.#firstOfFrames) return this.joints;
    return this.isSignal(index) ? this.signals : this.frames;
  }
}

import { PoseOutput } from '../cell/poseOutput';
import { SignalOutput } from '../cell/signalOutput';
import type { PlantClock } from '../clock/plantClock';
import type { Configuration } from '../configuration/configuration';
import type { AdapterStatus } from '../gateway/status';
import type { Nanoseconds } from '../times';
import { JointOutput, type JointOutputOptions, type SourceStop } from './jointOutput';
import type { Refusal } from './stampRule';

/** A value from the control system. */
export interface PlantValue {
  /** Index among the values of the configuration: those of the joints, then of the frames, then of the signals. */
  index: number;
  value: unknown;
  /** Null if the value had no readable stamp. */
  stamp: Nanoseconds | null;
  /** Whether this is the first value of a connection, whose stamp may be old. */
  isFirst?: boolean;
  /** The reason why the source marks the value as unusable. */
  refusal?: Refusal;
  /** Whether the source no longer has the variable; `refusal` has the reason. */
  isLost?: boolean;
}

interface Publisher {
  publish(topic: string, msg: object): void;
  publishKept(topic: string, msg: object): void;
}

/** Creates joint states, poses and signals from a plant's values. */
export class PlantOutput {
  readonly joints: JointOutput;
  readonly frames: PoseOutput;
  readonly signals: SignalOutput;
  /** Indices of the first value of a frame and of a signal. */
  readonly #firstOfFrames: number;
  readonly #firstOfSignals: number;

  /** @param counter Monotonic time in ms; this machine's by default. */
  constructor(
    { joints, frames, signals, values }: Pick<Configuration, 'joints' | 'frames' | 'signals' | 'values'>,
    options: JointOutputOptions,
    clock: Pick<PlantClock, 'now' | 'isSettled'>,
    gateway: Publisher,
    status: AdapterStatus,
    counter?: () => number,
  ) {
    this.#firstOfFrames = joints.length;
    this.#firstOfSignals = values.length - signals.length;
    const labels = values.map(({ label }) => label);
    this.joints = new JointOutput(joints, options, clock, gateway, status, counter);
    this.frames = new PoseOutput(frames, labels, options, clock, gateway, status, counter);
    this.signals = new SignalOutput(signals, this.#firstOfSignals, clock, gateway, status, counter);
    for (const { joint } of joints) status.joints.expect(joint);
  }

  /** Publishes values that arrived together; for each index, the oldest comes first. */
  publish(values: PlantValue[]): void {
    this.joints.publish(values.filter(({ index }) => index < this.#firstOfFrames).map(({ index, ...value }) => ({ joint: index, ...value })));
    this.frames.publish(values.filter(({ index }) => this.#isOfFrame(index)));
    this.signals.publish(values.filter(({ index }) => index >= this.#firstOfSignals));
  }

  /**
   * Confirms unchanged values, for a plant that sends only changes.
   * @param time Control time up to which every change has been published here.
   * @param silence Maximum interval between the samples of a moving joint or frame.
   * @param except Values for which a newer one is already known, or that are not known to be unchanged.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, except: ReadonlySet<number> = new Set()): void {
    this.joints.hold(time, silence, except);
    this.frames.hold(time, silence, except);
    this.signals.hold(except);
  }

  /** Sets the state of what was silent for too long, and publishes signals that waited for the clock. */
  check(): void {
    this.joints.checkSilence();
    this.frames.checkSilence();
    this.signals.check();
  }

  /** Starts a new connection. */
  startAnew(): void {
    this.joints.startAnew();
    this.frames.startAnew();
    this.signals.startAnew();
  }

  /** Reports that the source no longer has this value. */
  lose(index: number, reason: string): void {
    if (index < this.#firstOfFrames) this.joints.lose(index, reason);
    else if (this.#isOfFrame(index)) this.frames.lose(index, reason);
    else this.signals.lose(index, reason);
  }

  /** Counts a value that its source marks as unusable. */
  refuse(index: number, reason: string, text: string): void {
    if (index < this.#firstOfFrames) this.joints.refuse(index, reason, text);
    else if (this.#isOfFrame(index)) this.frames.refuse(index, { reason, text });
    else this.signals.refuse(index, { reason, text });
  }

  /** Whether the value is a joint whose data ended in mid-motion. */
  hasEnded(index: number): boolean {
    return index < this.#firstOfFrames && this.joints.hasEnded(index);
  }

  /** Sets how to find out when the source stopped writing a value. */
  set sourceStopOf(stopOf: (index: number) => SourceStop | null) {
    this.joints.sourceStopOf = stopOf;
  }

  /** Sets the sampling interval of the source in seconds. */
  set samplingS(seconds: number) {
    this.joints.samplingS = this.frames.samplingS = seconds;
  }

  /** Reports why a joint or frame whose value has arrived is not published yet. A signal is published at once. */
  explain(index: number, reason: string): void {
    if (index < this.#firstOfFrames) this.joints.explain(index, reason);
    else if (this.#isOfFrame(index)) this.frames.explain(index, reason);
  }

  /** Sets the limit for a value that is silent and not confirmed by the source, ms; null if the source cannot confirm. */
  set unconfirmedMs(ms: number | null) {
    for (const { silence } of [this.joints, this.frames, this.signals]) silence.unconfirmedMs = ms;
  }

  #isOfFrame(index: number): boolean {
    return index >= this.#firstOfFrames && index < this.#firstOfSignals;
  }
}

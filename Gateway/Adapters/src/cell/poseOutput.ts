import { type Frame, type FrameSettings, isStationary } from '../configuration/frames';
import type { OfferedClock } from '../clock/offeredClock';
import type { Publisher } from '../gateway/link';
import type { AdapterStatus } from '../gateway/status';
import { grouped } from '../samples/grouping';
import type { SourceStop } from '../samples/jointTrack';
import { numberIn } from '../samples/number';
import type { PlantValue } from '../samples/plantOutput';
import { ENDED_IN_MOTION, type SampleSilence } from '../samples/sampleSilence';
import { isNewer, OF_LONG_AGO, type Refusal } from '../samples/stampRule';
import { min, type Nanoseconds, ofMilliseconds } from '../times';
import { ComponentTrack } from './component';
import { FrameStates } from './frameStates';
import { poseOf, STEP } from './framePose';
import { silenceOf, type Track, trackOf } from './frameTrack';
import { type Pose, type StampedPose, TF, TF_STATIC, transform, transformMessages } from './messages';
import { refusalMessages, silenceMessages } from '../messages/values';

interface PoseOptions {
  /** Maximum difference of stamps that belong to the same sample. */
  tolerance: Nanoseconds;
  oldest: Nanoseconds;
}

/** Maximum interval between the values of a moving component, as a multiple of the source's sampling interval. */
const PATIENCE_INTERVALS = 5;

/** Computes the poses of frames from a plant's values, and publishes them. A pose needs a valid value for each of its components. */
export class PoseOutput {
  readonly #tracks: Track[];
  /** Components by index of the value. A component is empty before the first valid value and after an invalid one. */
  readonly #components: ComponentTrack[];
  /** The states of these frames, and of those whose poses arrive as a whole. */
  readonly states: FrameStates;
  /** Gets the phase in which the source stopped writing a value; null if it has not stopped, or if this is unknown. */
  sourceStopOf: (value: number) => SourceStop | null = () => null;

  /**
   * @param whole Settings of the frames whose poses arrive as a whole.
   * @param labels Descriptions of all values that are read, for messages.
   * @param counter Monotonic clock in ms; by default, the clock of this machine.
   */
  constructor(
    frames: Frame[],
    whole: FrameSettings[],
    readonly labels: string[],
    readonly options: PoseOptions,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    counter?: () => number,
  ) {
    this.#components = labels.map(() => new ComponentTrack());
    const moving = frames.filter(frame => !isStationary(frame));
    this.states = new FrameStates([...moving, ...whole], status, counter);
    this.#tracks = moving.map(frame => trackOf(frame, options.oldest, this.states.motionOf(frame.frame)));
    this.#publishStationary(frames.filter(isStationary));
  }

  get silence(): SampleSilence {
    return this.states.silence;
  }

  /** Publishes the poses that result from values that arrived together. Several values with the same index are sorted, the oldest first. */
  publish(values: PlantValue[]): void {
    const { now, isSettled } = this.clock;
    const invalid = new Map<number, PlantValue & { refusal: Refusal }>();
    const samples = values.flatMap(value => {
      const number = this.#numberOf(value, now);
      if (typeof number === 'object') invalid.set(value.index, { ...value, refusal: number });
      else invalid.delete(value.index);
      return typeof number === 'number' ? [{ index: value.index, value: number, stamp: value.stamp! }] : [];
    });
    for (const { stamp, samples: group } of grouped(samples, this.options.tolerance)) {
      for (const { index, value } of group) this.#components[index].add(value, stamp);
      const changed = new Set(group.map(({ index }) => index));
      const tracks = this.#tracks.filter(track => track.values.some(index => changed.has(index)));
      const poses = tracks.flatMap(track => this.#poseUpTo(track, stamp, now));
      if (isSettled) this.#send(poses);
      else poses.forEach(() => this.status.count('clock-unknown'));
    }
    for (const { index, refusal, isLost } of invalid.values())
      if (isLost === true) this.lose(index, refusal);
      else this.refuse(index, refusal);
  }

  /**
   * Repeats the poses of frames at rest, for a plant that sends only changes. The pose of a frame whose data have ended is not repeated.
   * @param time Control time up to which all changes have been passed to `publish`.
   * @param silence Maximum interval between the samples of a moving frame.
   * @param except Indices of values that have changed, or may have changed, after `time`.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, except: ReadonlySet<number>): void {
    const { now, isSettled } = this.clock;
    if (!isSettled || now === null) return;
    const poses = this.#tracks.flatMap(track => {
      const pose = this.#newestPose(track);
      if (pose === null || 'reason' in pose || track.values.some(index => except.has(index))) return [];
      const unmatched = this.#unmatchedSince(track);
      if (unmatched !== null) return time - unmatched >= this.#skew ? this.#accept(track, time, pose, now) : [];
      const isDue = track.newest === null || time - track.newest >= silenceOf(track, silence);
      if (!isDue || this.#hasEnded(track) || track.rule.judge(time, now) !== null) return [];
      [track.newest, track.isRepeated, track.choice] = [time, true, this.#choiceOf(track)];
      this.silence.confirm(track.frame.frame, this.#uncertaintyOf(track));
      return [{ stamp: time, pose }];
    });
    this.#send(poses);
  }

  /** Updates the state of frames that have been silent for too long, and the notices about frames that may not be at rest. */
  checkSilence(): void {
    const faults = new Set(this.silence.check());
    for (const track of this.#tracks) if (faults.has(track.frame.frame)) track.end ??= 'silent';
    this.states.reportUncertainty();
  }

  /** Whether the value belongs to a frame whose data ended during a motion. */
  hasEnded(value: number): boolean {
    return this.#tracksOf(value).some(({ end }) => end === 'in-motion');
  }

  /** Sets the reason why the frames of a value are not published yet. */
  explain(value: number, reason: Refusal): void {
    for (const { frame } of this.#tracksOf(value)) this.status.frames.explain(frame.frame, reason);
  }

  /** Prepares for a new connection. Objects at rest may have moved since the previous one. */
  restart(): void {
    for (const component of this.#components) component.forget();
    for (const track of this.#tracks) track.choice = null;
    this.clockStepped();
  }

  /** Discards the stamps of the previous control clock. Components keep their numbers, because the source may not send them again. */
  clockStepped(): void {
    for (const component of this.#components) if (component.value !== null) component.rest(component.value);
    for (const track of this.#tracks) [track.newest, track.isRepeated, track.jumped] = [null, false, null];
    this.states.restart();
  }

  /** Reports that the plant no longer has this value. */
  lose(value: number, refusal: Refusal): void {
    this.#components[value].forget();
    for (const track of this.#tracksOf(value)) {
      const { frame } = track.frame;
      track.end = null;
      this.silence.arrived(frame);
      this.status.frames.fault(frame, refusal);
    }
  }

  /** Counts an invalid value. Its frames have no pose until the next valid value. */
  refuse(value: number, { reason, text }: Refusal): void {
    this.#components[value].forget();
    for (const { frame } of this.#tracksOf(value)) this.status.refuse(reason, frame.frame, `${this.labels[value]}: ${text}`, this.status.frames);
  }

  #tracksOf(value: number): Track[] {
    return this.#tracks.filter(({ values }) => values.includes(value));
  }

  /** Gets the number to publish with the stamp of a value, or the refusal of the value; undefined for a first value that may be old. */
  #numberOf({ index, value, stamp, isFirst, refusal }: PlantValue, now: Nanoseconds | null): number | Refusal | undefined {
    const number = refusal ?? numberIn(value);
    if (typeof number !== 'number') return number;
    const isOld = stamp === null || (now !== null && stamp < now - this.options.oldest);
    if (isFirst === true && isOld) {
      // Keeps the value. It is published when it is known to be at rest.
      const component = this.#components[index];
      const isChange = component.value !== null && component.value !== number;
      component.rest(number);
      for (const track of this.#tracksOf(index)) {
        // The frame has moved since its last pose, so its motion did not end there.
        if (isChange) track.motion.restart();
        this.#arrive(track, stamp, now);
      }
      return undefined;
    }
    return stamp === null ? { reason: 'stamp-missing', text: refusalMessages.noStamp } : number;
  }

  /** Reports a first value. If its stamp shows that the source has not written it since, it does not end the fault of a frame. */
  #arrive(track: Track, stamp: Nanoseconds | null, now: Nanoseconds | null): void {
    const isKnown = stamp !== null && (track.changed === null || !isNewer(stamp, track.changed, now));
    if (track.end !== null && isKnown) return;
    track.end = null;
    this.silence.arrived(track.frame.frame);
  }

  /** Determines whether the data of a frame without newer values have ended, and sets its state if they ended during a motion. */
  #hasEnded(track: Track): boolean {
    if (track.end !== null) return true;
    const { impossible, unobserved } = track.motion.end(this.states.samplingS);
    const isAbandoned = unobserved !== null && track.values.some(value => this.sourceStopOf(value) === 'after-change');
    const reason = impossible ?? (isAbandoned ? `${unobserved}, and ${silenceMessages.notWritten}` : null);
    if (reason === null) return false;
    track.end = 'in-motion';
    const { frame } = track.frame;
    this.status.frames.fault(frame, { reason: ENDED_IN_MOTION, text: silenceMessages.endedBecause(reason) }, this.silence.lastSample(frame));
    return true;
  }

  /** Gets the reason why the frame may not be at rest; an empty string if there is none. */
  #uncertaintyOf({ values, motion }: Track): string {
    if (values.some(value => this.sourceStopOf(value) !== null)) return silenceMessages.notWritten;
    return motion.end(this.states.samplingS).unobserved ?? '';
  }

  /**
   * Gets the newest known pose of a frame up to this time as a list of one element; an empty list if the pose is incomplete, refused, already
   * published, or may have numbers that do not belong to its parent.
   */
  #poseUpTo(track: Track, time: Nanoseconds, now: Nanoseconds | null): StampedPose[] {
    if (this.#isHandedOver(track)) {
      const pose = this.#newestPose(track);
      return pose !== null && ('reason' in pose || this.#isMatched(track, time)) ? this.#accept(track, time, pose, now) : [];
    }

    const patience = ofMilliseconds(1000 * PATIENCE_INTERVALS * this.states.samplingS);
    const stamp = min(time, ...track.values.map(index => this.#components[index].knownUntil(time, patience)));
    if (stamp < time && track.newest !== null && stamp <= track.newest) return [];
    const pose = poseOf(track.frame, (index, jump) => (jump === STEP ? this.#components[index].value : this.#components[index].at(stamp, jump)));
    if (pose === null) return [];
    const mayHandOver = track.selector !== null && this.#components[track.selector].stamp !== stamp;
    if (mayHandOver && !('reason' in pose) && track.motion.isJump(stamp, pose, this.states.samplingS)) {
      track.jumped ??= time;
      if (time - track.jumped < this.#skew) return [];
    }
    return this.#accept(track, stamp, pose, now);
  }

  /** Gets the pose of a frame with a stamp as a list of one element, and updates its state; an empty list if the pose is refused. */
  #accept(track: Track, stamp: Nanoseconds, pose: Pose | Refusal, now: Nanoseconds | null): StampedPose[] {
    const { frame } = track.frame;
    const refusal = 'reason' in pose ? pose : track.rule.judge(stamp, now);
    if (refusal !== null) {
      if (track.newest !== null || !OF_LONG_AGO.includes(refusal.reason)) this.status.refuse(refusal.reason, frame, refusal.text, this.status.frames);
      return [];
    }
    // The numbers before a change of the parent are coordinates in the previous parent.
    if (this.#isHandedOver(track)) for (const index of track.values) this.#components[index].settle();
    if (track.changed !== null) track.intervals = [...track.intervals.slice(-1), stamp - track.changed];
    [track.newest, track.changed, track.isRepeated, track.end] = [stamp, stamp, false, null];
    [track.choice, track.jumped] = [this.#choiceOf(track), null];
    this.states.add(stamp, pose as Pose);
    return [{ stamp, pose: pose as Pose }];
  }

  /**
   * Maximum time between the samples of two values that changed together. A server samples each variable at a different time. A source that does not
   * confirm values sends the changes at once.
   */
  get #skew(): Nanoseconds {
    return this.silence.unconfirmedMs === null ? 0n : ofMilliseconds(1000 * this.states.samplingS);
  }

  #newestPose(track: Track): Pose | Refusal | null {
    return poseOf(track.frame, index => this.#components[index].value);
  }

  #choiceOf({ selector }: Track): number | null {
    return selector === null ? null : this.#components[selector].value;
  }

  /** Whether a parent other than that of the newest pose is selected. */
  #isHandedOver(track: Track): boolean {
    return track.choice !== null && this.#choiceOf(track) !== track.choice;
  }

  /** Whether the newest numbers of a frame belong to the parent that has just been selected. */
  #isMatched(track: Track, time: Nanoseconds): boolean {
    const since = this.#unmatchedSince(track) ?? time;
    const areNewer = track.values.every(index => (this.#components[index].stamp ?? 0n) >= since);
    const hasJumped = track.jumped !== null && since - track.jumped <= this.#skew;
    return areNewer || hasJumped || time - since >= this.#skew;
  }

  /** Gets the time since which the parent or the numbers of a frame have changed but not been published; null if they are published. */
  #unmatchedSince(track: Track): Nanoseconds | null {
    return this.#isHandedOver(track) ? this.#components[track.selector!].stamp : track.jumped;
  }

  #send(poses: StampedPose[]): void {
    for (const message of transformMessages(poses.map(({ stamp, pose }) => transform(stamp, pose)))) {
      this.gateway.publish(TF, message);
      this.status.sampled();
    }
  }

  #publishStationary(frames: Frame[]): void {
    // Uses a zero stamp, which needs no clock, because a stationary frame has the same pose at all times.
    const transforms = frames.map(frame => transform(0n, poseOf(frame, () => null) as Pose));
    transformMessages(transforms).forEach((message, i) => this.gateway.publishKept(TF_STATIC, message, `${TF_STATIC}[${i}]`));
  }
}

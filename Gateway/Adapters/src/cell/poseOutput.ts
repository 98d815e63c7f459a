import { isStationary, type Component, type Frame } from '../configuration/frames';
import type { OfferedClock } from '../clock/offeredClock';
import type { AdapterStatus } from '../gateway/status';
import { grouped } from '../samples/grouping';
import { numberIn } from '../samples/number';
import type { PlantValue } from '../samples/plantOutput';
import { SampleSilence } from '../samples/sampleSilence';
import { OF_LONG_AGO, type Refusal, StampRule } from '../samples/stampRule';
import { type Nanoseconds, NS_PER_MS, ofMilliseconds } from '../times';
import { ComponentTrack } from './component';
import { MAX_TRANSFORMS, type Pose, TF, TF_STATIC, tooFar, transform } from './messages';
import { IDENTITY, ofAngles, ofVector, type Quaternion, unit } from './rotation';
import { refusalMessages } from '../messages/values';

/** SILENCE: minimum time without changes after which a pose is repeated. REPETITION: interval of repetitions. Headsets predict for about 300 ms. */
const SILENCE: Nanoseconds = 60n * NS_PER_MS;
const REPETITION: Nanoseconds = 50n * NS_PER_MS;

/**
 * SILENT_INTERVALS: time without changes after which a pose is repeated, as a multiple of the time between changes. MAX_INTERVAL: times between
 * changes of at least this length are ignored.
 */
const SILENT_INTERVALS = 2n;
const MAX_INTERVAL: Nanoseconds = 500n * NS_PER_MS;

export interface PoseOptions {
  /** Maximum difference of stamps that belong to the same sample. */
  tolerance: Nanoseconds;
  oldest: Nanoseconds;
  /**
   * Time without data, in ms, after which a frame without its own setting has a fault; absent or null if a silent frame counts as at rest.
   */
  faultAfterMs?: number | null;
}

/** Maximum interval between the values of a moving component, as a multiple of the source's sampling interval. */
const PATIENCE_INTERVALS = 5;

/** Maximum change of a quaternion or rotation vector component between two samples. A larger change means that all signs have changed. */
const MAX_STEP = 1;

/** Value of `jump` for a number that must not be interpolated. */
const STEP = 0;

interface Publisher {
  publish(topic: string, msg: object): void;
  publishKept(topic: string, msg: object): void;
}

interface StampedPose {
  stamp: Nanoseconds;
  pose: Pose;
}

/** The state of a tracked frame. */
interface Track {
  index: number;
  frame: Frame;
  /** Indices of the values from which the pose is computed. */
  values: number[];
  /** Stamp of the newest pose; null before the first. */
  newest: Nanoseconds | null;
  /** Stamp of the newest change; null before the first. */
  changed: Nanoseconds | null;
  /** The two times between the last three changes. The shorter one is used, because the other may be a pause. */
  intervals: Nanoseconds[];
  isRepeated: boolean;
}

/** Computes the poses of frames from a plant's values, and publishes them. A pose needs a valid value for each of its components. */
export class PoseOutput {
  readonly #tracks: Track[];
  readonly #rule: StampRule;
  /** Components by index of the value. A component is empty before the first valid value and after an invalid one. */
  readonly #components: ComponentTrack[];
  /** Sampling interval of the source in seconds; 0 if unknown. */
  samplingS = 0;
  readonly silence: SampleSilence;

  /**
   * @param labels Descriptions of all values that are read, for messages.
   * @param counter Monotonic clock in ms; by default, the clock of this machine.
   */
  constructor(
    frames: Frame[],
    readonly labels: string[],
    readonly options: PoseOptions,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    counter?: () => number,
  ) {
    this.#components = labels.map(() => new ComponentTrack());
    this.#tracks = frames
      .filter(frame => !isStationary(frame))
      .map((frame, index) => ({ index, frame, values: valuesOf(frame), newest: null, changed: null, intervals: [], isRepeated: false }));
    this.#rule = new StampRule(this.#tracks.length, options.oldest);
    const limits = new Map(frames.map(({ frame, faultAfterMs }) => [frame, faultAfterMs]));
    this.silence = new SampleSilence(status, frame => (limits.has(frame) ? limits.get(frame) : options.faultAfterMs) ?? null, counter, status.frames);
    for (const { frame } of this.#tracks) status.frames.expect(frame.frame);
    this.#publishStationary(frames.filter(isStationary));
  }

  /** Publishes the poses that result from values that arrived together. Several values with the same index are sorted, the oldest first. */
  publish(values: PlantValue[]): void {
    const { now, isSettled } = this.clock;
    const invalid = new Map<number, PlantValue & { refusal: Refusal }>();
    const samples = values.flatMap(value => {
      const number = this.#numberOf(value, now);
      if (typeof number === 'object') invalid.set(value.index, { ...value, refusal: number });
      else invalid.delete(value.index);
      return typeof number === 'number' ? [{ joint: value.index, position: number, stamp: value.stamp! }] : [];
    });
    for (const { stamp, samples: group } of grouped(samples, this.options.tolerance)) {
      for (const { joint: index, position } of group) this.#components[index].add(position, stamp);
      const changed = new Set(group.map(({ joint }) => joint));
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
   * Repeats the poses of frames at rest, for a plant that sends only changes.
   * @param time Control time up to which all changes have been passed to `publish`.
   * @param silence Maximum interval between the samples of a moving frame.
   * @param except Indices of values that have changed, or may have changed, after `time`.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, except: ReadonlySet<number>): void {
    const { now, isSettled } = this.clock;
    if (!isSettled || now === null) return;
    const poses = this.#tracks.flatMap(track => {
      const pose = poseOf(track.frame, index => this.#components[index].value);
      const isDue = track.newest === null || time - track.newest >= silenceOf(track, silence);
      if (pose === null || 'reason' in pose || !isDue || track.values.some(index => except.has(index))) return [];
      if (this.#rule.judge(track.index, time, now) !== null) return [];
      [track.newest, track.isRepeated] = [time, true];
      this.silence.confirm(track.frame.frame);
      return [{ stamp: time, pose }];
    });
    this.#send(poses);
  }

  /** Updates the state of frames that have been silent for too long. */
  checkSilence(): void {
    this.silence.check();
  }

  /** Reports the reason why the frames of a value are not published yet although the value has arrived. */
  explain(value: number, reason: Refusal): void {
    for (const { frame } of this.#tracksOf(value)) this.status.frames.explain(frame.frame, reason);
  }

  /** Prepares for a new connection. Objects at rest may have moved since the previous one. */
  restart(): void {
    for (const component of this.#components) component.forget();
    for (const track of this.#tracks) [track.newest, track.isRepeated] = [null, false];
  }

  /** Reports that the plant no longer has this value. */
  lose(value: number, refusal: Refusal): void {
    this.#components[value].forget();
    for (const { frame } of this.#tracksOf(value)) {
      this.silence.arrived(frame.frame);
      this.status.frames.fault(frame.frame, refusal);
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
      this.#components[index].rest(number);
      return undefined;
    }
    return stamp === null ? { reason: 'stamp-missing', text: refusalMessages.noStamp } : number;
  }

  /**
   * Gets the newest known pose of a frame up to this time as a list of one element; an empty list if the pose is incomplete, refused or already
   * published.
   */
  #poseUpTo(track: Track, time: Nanoseconds, now: Nanoseconds | null): StampedPose[] {
    const { frame } = track.frame;
    const patience = ofMilliseconds(1000 * PATIENCE_INTERVALS * this.samplingS);
    const stamp = track.values
      .map(index => this.#components[index].knownUntil(time, patience))
      .reduce((oldest, each) => (each < oldest ? each : oldest), time);
    if (stamp < time && track.newest !== null && stamp <= track.newest) return [];
    const pose = poseOf(track.frame, (index, jump) =>
      jump === STEP ? this.#components[index].stepAt(stamp) : this.#components[index].at(stamp, jump),
    );
    if (pose === null) return [];
    const refusal = 'reason' in pose ? pose : this.#rule.judge(track.index, stamp, now);
    if (refusal !== null) {
      if (track.newest !== null || !OF_LONG_AGO.includes(refusal.reason)) this.status.refuse(refusal.reason, frame, refusal.text, this.status.frames);
      return [];
    }
    if (track.changed !== null) track.intervals = [...track.intervals.slice(-1), stamp - track.changed];
    [track.newest, track.changed, track.isRepeated] = [stamp, stamp, false];
    this.status.accept(frame);
    this.silence.heard(frame);
    return [{ stamp, pose: pose as Pose }];
  }

  #send(poses: StampedPose[]): void {
    for (let i = 0; i < poses.length; i += MAX_TRANSFORMS) {
      this.gateway.publish(TF, { transforms: poses.slice(i, i + MAX_TRANSFORMS).map(({ stamp, pose }) => transform(stamp, pose)) });
      this.status.sampled();
    }
  }

  #publishStationary(frames: Frame[]): void {
    // Uses a zero stamp, which needs no clock, because a stationary frame has the same pose at all times.
    const transforms = frames.map(frame => transform(0n, poseOf(frame, () => null) as Pose));
    if (transforms.length > 0) this.gateway.publishKept(TF_STATIC, { transforms });
  }
}

const valuesOf = ({ selector, position, rotation }: Frame): number[] =>
  [...(selector === null ? [] : [selector]), ...position, ...(rotation?.parts ?? [])].flatMap(part => ('value' in part ? [part.value] : []));

function silenceOf({ intervals, isRepeated }: Track, silence: Nanoseconds): Nanoseconds {
  if (isRepeated) return REPETITION;
  const interval = intervals.reduce((shortest, each) => (each < shortest ? each : shortest), MAX_INTERVAL);
  const least = silence > SILENCE ? silence : SILENCE;
  return intervals.length > 0 && interval < MAX_INTERVAL && SILENT_INTERVALS * interval > least ? SILENT_INTERVALS * interval : least;
}

/**
 * Computes the pose of a frame; null if a number is missing, and a refusal if the numbers do not form a valid parent and rotation.
 * @param numberOf Gets the number of a value. Between two numbers that differ by more than `jump`, it must not interpolate.
 */
function poseOf(
  { frame, parents, selector, position, scale, rotation }: Frame,
  numberOf: (value: number, jump: number) => number | null,
): Pose | Refusal | null {
  const found = (parts: Component[], jump: number): number[] | null => {
    const all = parts.map(part => ('constant' in part ? part.constant : numberOf(part.value, jump)));
    return all.includes(null) ? null : (all as number[]);
  };
  const place = found(position, Infinity);
  const parts = rotation === null ? [] : found(rotation.parts, rotation.kind === 'angles' ? Math.PI / rotation.scale : MAX_STEP);
  const [choice] = selector === null ? [0] : (found([selector], STEP) ?? [null]);
  if (place === null || parts === null || choice === null) return null;
  if (!Number.isInteger(choice) || choice < 0 || choice >= parents.length)
    return { reason: 'parent', text: refusalMessages.parent(choice, parents.length - 1) };
  const turned = turnOf(rotation, parts);
  if (turned === null) return { reason: 'not-unit', text: refusalMessages.quaternion(Math.hypot(...parts)) };
  const metres = place.map(value => value * scale);
  const far = tooFar(metres);
  if (far !== null) return far;
  return { frame, parent: parents[choice], position: metres, rotation: turned };
}

function turnOf(rotation: Frame['rotation'], parts: number[]): Quaternion | null {
  if (rotation === null) return IDENTITY;
  if (rotation.kind === 'angles')
    return ofAngles(
      parts.map(angle => angle * rotation.scale),
      rotation.order,
      rotation.isFixed,
    );
  return rotation.kind === 'vector' ? ofVector(parts) : unit(parts);
}

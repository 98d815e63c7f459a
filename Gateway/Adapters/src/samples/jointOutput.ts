import type { OfferedClock } from '../clock/offeredClock';
import type { Joint } from '../configuration/configuration';
import type { Condition } from '../gateway/conditions';
import type { Publisher } from '../gateway/link';
import { JOINT_STATES, jointState, topicOf } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';
import { type Nanoseconds, NS_PER_MS, ofMilliseconds } from '../times';
import { decelerationFloor, EndOfData } from './endOfData';
import { grouped, type Sample } from './grouping';
import { numberIn } from './number';
import { ENDED_IN_MOTION, SampleSilence } from './sampleSilence';
import { OF_LONG_AGO, type Refusal, StampRule } from './stampRule';
import { RestingSamples } from './restingSamples';
import { refusalMessages, silenceMessages } from '../messages/values';

/** A joint's value from the control system. */
interface JointValue {
  /** Index of the joint in the configuration. */
  joint: number;
  value: unknown;
  /** Velocity in the unit of the control system; absent if the control system does not provide it. */
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

export interface JointOutputOptions {
  /** Maximum difference between stamps that belong to the same sample. */
  tolerance: Nanoseconds;
  oldest: Nanoseconds;
  /**
   * Time without data in ms after which a joint without its own setting has a fault; absent or null if a silent joint counts as at rest.
   */
  faultAfterMs?: number | null;
}

/** The phase in which a source stopped writing a value: directly after a change, or later, while the value was at rest. */
export type SourceStop = 'after-change' | 'at-rest';

/**
 * SILENCE: minimum time without changes after which a sample is repeated. REPETITION: interval of the repetitions. Both are short, because headsets
 * predict for only about 300 ms.
 */
const SILENCE: Nanoseconds = 60n * NS_PER_MS;
const REPETITION: Nanoseconds = 50n * NS_PER_MS;

/** Time after the last sample of a joint at which it is clear whether the other joints have also stopped, as in an emergency stop. */
const OTHERS_KNOWN: Nanoseconds = 500n * NS_PER_MS;

/** Publishes joint states from a plant's values. Refuses values that are not a valid position with a valid stamp. */
export class JointOutput {
  readonly #rule: StampRule;
  readonly #resting: RestingSamples;
  readonly #ends: EndOfData[];
  /** Joints whose end of data has already been judged since their last sample. */
  readonly #judged = new Set<number>();
  /**
   * Joints whose data have ended, with their fault and last position (null if unknown): during a motion, or by a silence that is longer than the
   * setting allows. Only a newer value, or the loss of a silent joint's variable, ends this state, because a new connection starts with the last value
   * again.
   */
  readonly #ended = new Map<number, { fault: Condition; position: number | null }>();
  /**
   * #repeated: joints whose newest sample has been repeated. #unobserved: for each joint whose last stop would need a deceleration above all observed
   * ones, this deceleration.
   */
  readonly #repeated = new Set<number>();
  readonly #unobserved = new Map<number, number>();
  /** Sampling interval of the source in seconds; 0 if unknown. */
  samplingS = 0;
  readonly silence: SampleSilence;
  /** Gets the phase in which the source stopped writing a joint's value; null if it has not stopped, or if this is unknown. */
  sourceStopOf: (joint: number) => SourceStop | null = () => null;

  /** @param counter Monotonic clock in ms; by default, the clock of this machine. */
  constructor(
    readonly joints: Joint[],
    readonly options: JointOutputOptions,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    counter?: () => number,
  ) {
    this.#rule = new StampRule(joints.length, options.oldest);
    this.#resting = new RestingSamples(joints.length);
    this.#ends = joints.map(joint => new EndOfData(decelerationFloor(joint.isLinear), joint.maxDeceleration ?? null));
    const limits = new Map(joints.map(joint => [joint.joint, joint.faultAfterMs ?? null]));
    this.silence = new SampleSilence(status, joint => (limits.has(joint) ? limits.get(joint) : options.faultAfterMs) ?? null, counter);
    this.silence.endOf = (name, silentMs) =>
      this.#endOf(
        joints.findIndex(({ joint }) => joint === name),
        silentMs,
      );
  }

  /** Publishes values that arrived together. Several values of one joint are sorted, the oldest first. */
  publish(values: JointValue[]): void {
    const { now, isSettled } = this.clock;
    const samples = values.map(value => this.#sample(value, now)).filter(sample => sample !== null);
    // Drops samples until the clock is known. Values at rest are repeated later.
    if (isSettled) this.#send(samples);
    else samples.forEach(() => this.status.count('clock-unknown'));
  }

  /**
   * Repeats the samples of joints at rest, for a plant that sends only changes.
   * @param time Control time up to which all changes have been passed to `publish`.
   * @param silence Maximum interval between the samples of a moving joint.
   * @param except Joints that have a newer value, or that may have changed.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, except: ReadonlySet<number> = new Set()): void {
    const { now, isSettled } = this.clock;
    if (!isSettled || now === null) return;
    const silent = this.#resting
      .at(time, joint => this.#silenceOf(joint, silence))
      .filter(({ joint }) => !except.has(joint) && !this.#hasEnded(joint, time) && !this.#isAbandoned(joint));
    const resting = silent.filter(({ joint }) => this.#rule.judge(joint, time, now) === null);
    for (const sample of resting) {
      this.#resting.heard(sample);
      this.#repeated.add(sample.joint);
      this.silence.confirm(this.joints[sample.joint].joint, this.#uncertaintyOf(sample.joint));
    }
    this.#send(resting);
  }

  /** Updates the state of joints that have been silent for too long. Samples of joints with a fault are no longer repeated. */
  checkSilence(): void {
    const faults = new Set(this.silence.check());
    this.joints.forEach(({ joint }, i) => {
      if (faults.has(joint)) this.#storeEnd(i);
    });
  }

  /** Whether the joint's data ended during a motion. */
  hasEnded(joint: number): boolean {
    return this.#ended.get(joint)?.fault.word === ENDED_IN_MOTION;
  }

  /** Reports that the control system no longer has the variable of this joint. */
  lose(joint: number, refusal: Refusal): void {
    this.#resting.forget(joint);
    if (!this.hasEnded(joint)) this.#ended.delete(joint);
    this.status.joints.fault(this.joints[joint].joint, refusal);
  }

  /** Reports the reason why a joint is not published yet although its value has arrived. */
  explain(joint: number, reason: Refusal): void {
    if (!this.#ended.has(joint)) this.status.joints.explain(this.joints[joint].joint, reason);
  }

  /** Prepares for a new connection. Joints at rest may have moved since the previous one. */
  restart(): void {
    for (let joint = 0; joint < this.joints.length; joint++) {
      this.#resting.forget(joint);
      this.#ends[joint].restart();
    }
  }

  /** Counts an unusable value. */
  refuse(joint: number, reason: string, text: string): void {
    this.#resting.forget(joint);
    this.status.refuse(reason, this.joints[joint].joint, text);
  }

  /** Gets the minimum time without changes after which a joint's sample is repeated; if it has been repeated already, the repetition interval. */
  #silenceOf(joint: number, silence: Nanoseconds): Nanoseconds {
    if (this.#repeated.has(joint)) return REPETITION;
    const overdue = ofMilliseconds(this.#ends[joint].overdueMs);
    return [SILENCE, silence, overdue].reduce((longest, each) => (each > longest ? each : longest));
  }

  /** Determines, once after the last sample, whether the joint's data ended during a motion. */
  #hasEnded(joint: number, time: Nanoseconds): boolean {
    const end = this.#ends[joint];
    const { newest } = end;
    if (this.#judged.has(joint)) return false;
    const unobserved = end.unobserved(this.samplingS);
    const isOthersKnown = newest === null || time - newest >= OTHERS_KNOWN;
    const areOthersMoving = newest !== null && isOthersKnown && this.#ends.some((other, i) => i !== joint && other.goesOnAfter(newest));
    const verdict = end.verdict(this.samplingS, areOthersMoving);
    if (verdict !== null || isOthersKnown || unobserved === null) this.#judged.add(joint);
    if (unobserved !== null) this.#unobserved.set(joint, unobserved);
    if (verdict === null) return false;
    this.#end(joint, silenceMessages.stopTooHard(verdict.required, verdict.limit, this.#unitOf(joint), verdict.basis));
    return true;
  }

  /** Gets the reason why the data of a joint without samples ended during a motion; null if they did not. */
  #endOf(joint: number, silentMs: number): string | null {
    if (joint < 0 || silentMs < this.#ends[joint].overdueMs) return null;
    if (!this.#hasEnded(joint, this.clock.now ?? this.#ends[joint].newest ?? 0n)) return null;
    return this.status.joints.reasonOf(this.joints[joint].joint) ?? null;
  }

  /** Determines whether the source stopped writing a joint after its last change, although a stop of the joint was not observed. */
  #isAbandoned(joint: number): boolean {
    const required = this.#unobserved.get(joint);
    if (required === undefined || this.sourceStopOf(joint) !== 'after-change') return false;
    this.#end(joint, `${silenceMessages.unobservedStop(required, this.#unitOf(joint))}, and ${silenceMessages.notWritten}`);
    return true;
  }

  #end(joint: number, reason: string): void {
    const { joint: name } = this.joints[joint];
    this.status.joints.fault(name, { reason: ENDED_IN_MOTION, text: silenceMessages.endedBecause(reason) }, this.silence.lastSample(name));
    this.#storeEnd(joint);
  }

  #storeEnd(joint: number): void {
    this.#ended.set(joint, { fault: this.status.joints.conditionOf(this.joints[joint].joint)!, position: this.#resting.forget(joint) });
  }

  /**
   * Whether a first value is the one with which the data of the joint have ended. The joint then has the fault of this end again, because the value is
   * no longer invalid or missing.
   */
  #isEnd(joint: number, position: number, stamp: Nanoseconds | null, now: Nanoseconds): boolean {
    const end = this.#ended.get(joint);
    if (end === undefined || (stamp === null ? position !== end.position : this.#rule.isNewer(joint, stamp, now))) return false;
    this.status.joints.report(this.joints[joint].joint, end.fault);
    return true;
  }

  /** Gets the reason why the joint may not be at rest; an empty string if there is none. */
  #uncertaintyOf(joint: number): string {
    if (this.sourceStopOf(joint) !== null) return silenceMessages.notWritten;
    const required = this.#unobserved.get(joint);
    return required === undefined ? '' : silenceMessages.unobservedStop(required, this.#unitOf(joint));
  }

  #unitOf(joint: number): string {
    return this.joints[joint].isLinear === true ? 'm/s²' : 'rad/s²';
  }

  #send(samples: Sample[]): void {
    for (const { stamp, samples: group } of grouped(samples, this.options.tolerance))
      for (const robot of new Set(group.map(({ joint }) => this.joints[joint].robot))) {
        const own = group.filter(({ joint }) => this.joints[joint].robot === robot);
        const names = own.map(({ joint }) => this.joints[joint].name);
        const positions = own.map(({ position }) => position);
        const velocities = own.flatMap(({ velocity }) => velocity ?? []);
        this.gateway.publish(topicOf(robot, JOINT_STATES), jointState(stamp, names, positions, velocities.length === names.length ? velocities : []));
        this.status.sampled();
      }
  }

  #sample({ joint, value, velocity, stamp, isFirst, refusal: unusable, isLost }: JointValue, now: Nanoseconds | null): Sample | null {
    if (unusable !== undefined) {
      if (isLost === true) this.lose(joint, unusable);
      else this.refuse(joint, unusable.reason, unusable.text);
      return null;
    }
    const { scale, offset } = this.joints[joint];
    const raw = numberIn(value);
    if (typeof raw !== 'number') {
      this.refuse(joint, raw.reason, raw.text);
      return null;
    }
    const position = raw * scale + offset;
    if (!Number.isFinite(position)) {
      this.refuse(joint, 'not-finite', refusalMessages.scaledNotPosition(raw, scale));
      return null;
    }
    const refusal = this.#rule.judge(joint, stamp, now);
    if (refusal !== null && isFirst === true && now !== null && OF_LONG_AGO.includes(refusal.reason)) {
      if (this.#isEnd(joint, position, stamp, now)) return null;
      this.#ended.delete(joint);
      // Does not publish the value before the joint is known to be at rest. If the stamps come from a clock other than the control clock, the next
      // value is refused.
      this.#resting.heard({ joint, position, stamp: now });
      this.silence.arrived(this.joints[joint].joint);
      return null;
    }
    if (refusal !== null) {
      this.refuse(joint, refusal.reason, refusal.text);
      return null;
    }
    const hasVelocity = velocity !== undefined && Number.isFinite(velocity * scale);
    const sample: Sample = { joint, position, stamp: stamp!, ...(hasVelocity ? { velocity: velocity * scale } : {}) };
    this.#resting.heard(sample);
    this.#judged.delete(joint);
    this.#ended.delete(joint);
    this.#repeated.delete(joint);
    this.#unobserved.delete(joint);
    this.#ends[joint].add(stamp!, position);
    this.status.accept(this.joints[joint].joint);
    this.silence.heard(this.joints[joint].joint);
    return sample;
  }
}

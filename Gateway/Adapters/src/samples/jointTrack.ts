import type { Joint } from '../configuration/configuration';
import type { Condition } from '../gateway/conditions';
import type { AdapterStatus } from '../gateway/status';
import { max, type Nanoseconds, NS_PER_MS, ofMilliseconds } from '../times';
import { type EndOfData, endOfJoint } from './endOfData';
import type { Sample } from './grouping';
import { numberIn } from './number';
import type { PlantValue } from './plantOutput';
import { ENDED_IN_MOTION, type SampleSilence } from './sampleSilence';
import { OF_LONG_AGO, type Refusal, StampRule } from './stampRule';
import { refusalMessages, silenceMessages } from '../messages/values';

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

/** The properties that all joints of a plant have in common. */
interface Plant {
  readonly status: AdapterStatus;
  readonly silence: SampleSilence;
  /** Sampling interval of the source in seconds; 0 if unknown. */
  readonly samplingS: number;
  readonly sourceStopOf: (joint: number) => SourceStop | null;
  /** Whether any joint continued to move for a while after a stamp. */
  isAnyMovingAfter(stamp: Nanoseconds): boolean;
}

/** The state of one joint of a plant. */
export class JointTrack {
  readonly #rule: StampRule;
  readonly #motion: EndOfData;
  /**
   * The last sample, which is repeated while the joint is at rest; null before the first one, after an invalid value and in a fault. If all changes up to
   * a time are known and the joint has sent none, it still had its last position at that time.
   */
  #newest: Sample | null = null;
  /** Whether the newest sample has been repeated. */
  #isRepeated = false;
  /** Whether the end of the data has already been judged since the last sample. */
  #isJudged = false;
  /** The deceleration that the last stop would need if it is above all observed ones; null otherwise. */
  #unobserved: number | null = null;
  /**
   * The fault and the last position (null if unknown) if the data have ended: during a motion, or by a silence that is longer than the setting allows.
   * Only a newer value, or the loss of a silent joint's variable, ends this state, because a new connection starts with the last value again.
   */
  #end: { fault: Condition; position: number | null } | null = null;

  /** @param oldest Maximum age of a stamp. */
  constructor(
    readonly index: number,
    readonly joint: Joint,
    readonly plant: Plant,
    oldest: Nanoseconds,
  ) {
    this.#rule = new StampRule(oldest);
    this.#motion = endOfJoint(joint.isLinear, joint.maxDeceleration);
  }

  /** Gets the sample of a value; null if the value is refused, or is only used after it has been confirmed. */
  sampleOf({ value, velocity, stamp, isFirst, refusal: unusable, isLost }: PlantValue, now: Nanoseconds | null): Sample | null {
    if (unusable !== undefined) return isLost === true ? this.lose(unusable) : this.refuse(unusable);
    const { joint, scale, offset } = this.joint;
    const raw = numberIn(value);
    if (typeof raw !== 'number') return this.refuse(raw);
    const position = raw * scale + offset;
    if (!Number.isFinite(position)) return this.refuse({ reason: 'not-finite', text: refusalMessages.scaledNotPosition(raw, scale) });
    const refusal = this.#rule.judge(stamp, now);
    if (refusal !== null && isFirst === true && now !== null && OF_LONG_AGO.includes(refusal.reason)) {
      this.#arrive(position, stamp, now);
      return null;
    }
    if (refusal !== null) return this.refuse(refusal);
    const hasVelocity = velocity !== undefined && Number.isFinite(velocity * scale);
    const sample: Sample = { index: this.index, value: position, stamp: stamp!, ...(hasVelocity ? { velocity: velocity * scale } : {}) };
    [this.#newest, this.#isRepeated, this.#isJudged, this.#unobserved, this.#end] = [sample, false, false, null, null];
    this.#motion.add(stamp!, position);
    this.plant.status.accept(joint);
    this.plant.silence.heard(joint);
    return sample;
  }

  /**
   * Confirms that the joint is at rest.
   * @param time Control time up to which all changes are known.
   * @param silence Maximum interval between the samples of a moving joint.
   * @returns The sample at this time; null if the joint may move, its data have ended, or it is too early for a repetition.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, now: Nanoseconds): Sample | null {
    const newest = this.#newest;
    if (newest === null || time - newest.stamp < this.#silenceAfter(silence) || this.#endsInMotion(time) || this.#isAbandoned()) return null;
    if (this.#rule.judge(time, now) !== null) return null;
    [this.#newest, this.#isRepeated] = [{ ...newest, stamp: time }, true];
    this.plant.silence.confirm(this.joint.joint, this.#uncertainty);
    return this.#newest;
  }

  /** Gets the reason why the data of the joint, which sends no samples, ended during a motion; null if they did not. */
  endOf(silentMs: number, now: Nanoseconds | null): string | null {
    if (silentMs < this.#motion.overdueMs || !this.#endsInMotion(now ?? this.#motion.newest ?? 0n)) return null;
    return this.plant.status.joints.reasonOf(this.joint.joint) ?? null;
  }

  /** Keeps the present fault of the joint until a newer value. */
  storeEnd(): void {
    this.#end = { fault: this.plant.status.joints.conditionOf(this.joint.joint)!, position: this.#newest?.value ?? null };
    this.#newest = null;
  }

  /** Whether the data ended during a motion. */
  get hasEnded(): boolean {
    return this.#end?.fault.word === ENDED_IN_MOTION;
  }

  /** Whether the joint continued to move for a while after a stamp. */
  goesOnAfter(stamp: Nanoseconds): boolean {
    return this.#motion.goesOnAfter(stamp);
  }

  /** Reports that the control system no longer has the variable of the joint. */
  lose(refusal: Refusal): null {
    this.#newest = null;
    if (!this.hasEnded) this.#end = null;
    this.plant.status.joints.fault(this.joint.joint, refusal);
    return null;
  }

  /** Counts an unusable value. */
  refuse({ reason, text }: Refusal): null {
    this.#newest = null;
    this.plant.status.refuse(reason, this.joint.joint, text);
    return null;
  }

  /** Sets the reason why the joint is not published yet. A joint whose data have ended keeps its fault. */
  explain(reason: Refusal): void {
    if (this.#end === null) this.plant.status.joints.explain(this.joint.joint, reason);
  }

  /** Prepares for a new connection. A joint at rest may have moved since the previous one. */
  restart(): void {
    this.#newest = null;
    this.#motion.restart();
  }

  /** Replaces the stamp of the previous control clock. The joint keeps its position, because the source may not send it again. */
  clockStepped(now: Nanoseconds): void {
    if (this.#newest !== null) this.#newest = { ...this.#newest, stamp: now };
    this.#motion.restart();
  }

  /**
   * Takes a first value, whose stamp may be old. If it is the one with which the data of the joint have ended, the joint has the fault of this end again,
   * because the value is no longer invalid or missing. Otherwise, the value is published when the joint is known to be at rest: if the stamps come from a
   * clock other than the control clock, the next value is refused.
   */
  #arrive(position: number, stamp: Nanoseconds | null, now: Nanoseconds): void {
    const { joint } = this.joint;
    if (this.#end !== null && (stamp === null ? position === this.#end.position : !this.#rule.isNewer(stamp, now)))
      return this.plant.status.joints.report(joint, this.#end.fault);
    this.#end = null;
    this.#newest = { index: this.index, value: position, stamp: now };
    this.plant.silence.arrived(joint);
  }

  /** Gets the minimum time without changes after which the sample is repeated; if it has been repeated already, the repetition interval. */
  #silenceAfter(silence: Nanoseconds): Nanoseconds {
    if (this.#isRepeated) return REPETITION;
    return max(SILENCE, silence, ofMilliseconds(this.#motion.overdueMs));
  }

  /** Determines, once after the last sample, whether the data ended during a motion. */
  #endsInMotion(time: Nanoseconds): boolean {
    if (this.#isJudged) return false;
    const { newest } = this.#motion;
    const { samplingS } = this.plant;
    const unobserved = this.#motion.unobserved(samplingS);
    const isOthersKnown = newest === null || time - newest >= OTHERS_KNOWN;
    const verdict = this.#motion.verdict(samplingS, newest !== null && isOthersKnown && this.plant.isAnyMovingAfter(newest));
    this.#isJudged = verdict !== null || isOthersKnown || unobserved === null;
    this.#unobserved = unobserved ?? this.#unobserved;
    if (verdict === null) return false;
    this.#endBecause(silenceMessages.stopTooHard(verdict.required, verdict.limit, this.#unit, verdict.basis));
    return true;
  }

  /** Determines whether the source stopped writing the joint after its last change, although a stop of the joint was not observed. */
  #isAbandoned(): boolean {
    if (this.#unobserved === null || this.plant.sourceStopOf(this.index) !== 'after-change') return false;
    this.#endBecause(`${silenceMessages.unobservedStop(this.#unobserved, this.#unit)}, and ${silenceMessages.notWritten}`);
    return true;
  }

  #endBecause(reason: string): void {
    const { status, silence } = this.plant;
    const { joint } = this.joint;
    status.joints.fault(joint, { reason: ENDED_IN_MOTION, text: silenceMessages.endedBecause(reason) }, silence.lastSample(joint));
    this.storeEnd();
  }

  /** The reason why the joint may not be at rest; an empty string if there is none. */
  get #uncertainty(): string {
    if (this.plant.sourceStopOf(this.index) !== null) return silenceMessages.notWritten;
    return this.#unobserved === null ? '' : silenceMessages.unobservedStop(this.#unobserved, this.#unit);
  }

  get #unit(): string {
    return this.joint.isLinear === true ? 'm/s²' : 'rad/s²';
  }
}

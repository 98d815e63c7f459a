import { decelerationFloor, EndOfData } from '../samples/endOfData';
import { silenceMessages } from '../messages/values';
import { type Nanoseconds, toMilliseconds } from '../times';
import type { Pose, StampedPose } from './messages';
import { angleBetween } from './rotation';

/** A speed above this multiple of the previous one is a jump to another place, which is not a part of the motion. */
const JUMP = 5;

/** A frame counts as at rest after a time without changes of more than this multiple of the usual interval between its poses. */
const REST_INTERVALS = 2;

/**
 * MAX_QUANTUM: assumed largest quantum of a distance in m or of an angle in rad. Belts and turntables move at a constant speed, so all steps of a
 * frame may be equal. MIN_JUMP: minimum length of a jump that delays a pose.
 */
const LINEAR = { unit: 'm/s²', MAX_QUANTUM: 1e-4, MIN_JUMP: 0.01 };
const ROTARY = { unit: 'rad/s²', MAX_QUANTUM: 2e-3, MIN_JUMP: 0.1 };

/** What is known about the end of a frame's motion. */
interface End {
  /** The reason why the frame cannot have stopped at its last pose, so that its data ended during the motion; null if it can. */
  impossible: string | null;
  /** The reason why the frame may not be at rest, because its stop was not observed; null if there is none. */
  unobserved: string | null;
}

/** The distance or the angle that a frame has covered, and the decision whether its data ended during the motion. */
class Path {
  readonly end: EndOfData;
  #covered = 0;
  #speed = 0;

  constructor(
    readonly kind: typeof LINEAR,
    maxDeceleration: number | null,
  ) {
    this.end = new EndOfData(decelerationFloor(kind === LINEAR), maxDeceleration, kind.MAX_QUANTUM);
  }

  restart(): void {
    this.end.restart();
    this.#speed = 0;
  }

  add(stamp: Nanoseconds, step: number, seconds: number): void {
    const speed = seconds > 0 ? step / seconds : 0;
    if (speed > JUMP * this.#speed) this.end.restart();
    this.#speed = speed;
    this.#covered += step;
    this.end.add(stamp, this.#covered);
  }

  /** Whether a step is much longer than the speed before it explains. */
  isJump(step: number, seconds: number, isAtRest: boolean): boolean {
    return step >= this.kind.MIN_JUMP && (isAtRest || step / seconds > JUMP * this.#speed);
  }
}

/** Watches the motion of one frame in its parent, to detect that its data ended during the motion. */
export class FrameMotion {
  readonly #distance: Path;
  readonly #angle: Path;
  #last: StampedPose | null = null;
  /** The end of the motion at the last pose; null before it is judged. */
  #end: End | null = null;

  /**
   * @param maxDeceleration Maximum deceleration of the frame in m/s² and rad/s²; null if unknown. An object that runs against a stopper stops at once, and so
   * does a simulated belt. Only with this limit is a sudden stop therefore the end of the data; without it, the rest is uncertain.
   */
  constructor(maxDeceleration: number | null) {
    this.#distance = new Path(LINEAR, maxDeceleration);
    this.#angle = new Path(ROTARY, maxDeceleration);
  }

  /** Time after the last pose at which the next pose of a moving frame is overdue, in ms. */
  get overdueMs(): number {
    return this.#distance.end.overdueMs;
  }

  /** Discards the motion, but keeps the observed decelerations. */
  restart(): void {
    for (const path of this.#paths) path.restart();
    this.#last = this.#end = null;
  }

  /** Adds a pose, which is newer than the previous one. A pose in another parent starts another motion. */
  add(stamp: Nanoseconds, pose: Pose): void {
    if (this.#last?.pose.parent !== pose.parent) this.restart();
    const { distance, angle, seconds } = stepBetween(this.#last ?? { stamp, pose }, { stamp, pose });
    this.#distance.add(stamp, distance, seconds);
    this.#angle.add(stamp, angle, seconds);
    [this.#last, this.#end] = [{ stamp, pose }, null];
  }

  /**
   * Whether a pose in the same parent is at a place that the motion so far does not explain.
   * @param samplingS Sampling interval of the source in seconds; 0 if unknown.
   */
  isJump(stamp: Nanoseconds, pose: Pose, samplingS: number): boolean {
    if (this.#last === null) return false;
    const { distance, angle, seconds } = stepBetween(this.#last, { stamp, pose });
    const isAtRest = seconds > REST_INTERVALS * Math.max(samplingS, this.#distance.end.interval);
    return this.#distance.isJump(distance, seconds, isAtRest) || this.#angle.isJump(angle, seconds, isAtRest);
  }

  /**
   * Judges whether the frame can have stopped at its last pose.
   * @param samplingS Sampling interval of the source in seconds; 0 if unknown.
   */
  end(samplingS: number): End {
    this.#end ??= this.#judge(samplingS);
    return this.#end;
  }

  get #paths(): Path[] {
    return [this.#distance, this.#angle];
  }

  #judge(samplingS: number): End {
    const reasons = this.#paths.map(({ end, kind: { unit } }): End => {
      // Independent objects may decelerate differently, so the motion of other frames is not evidence.
      const verdict = end.verdict(samplingS);
      const required = end.unobserved(samplingS) ?? verdict?.required ?? null;
      return {
        impossible: verdict?.basis === 'configured' ? silenceMessages.stopTooHard(verdict.required, verdict.limit, unit, verdict.basis) : null,
        unobserved: required === null ? null : silenceMessages.unobservedStop(required, unit),
      };
    });
    const first = (key: keyof End): string | null => reasons.map(reason => reason[key]).find(reason => reason !== null) ?? null;
    return { impossible: first('impossible'), unobserved: first('unobserved') };
  }
}

function stepBetween(from: StampedPose, to: StampedPose): { distance: number; angle: number; seconds: number } {
  return {
    distance: Math.hypot(...to.pose.position.map((metres, i) => metres - from.pose.position[i])),
    angle: angleBetween(from.pose.rotation, to.pose.rotation),
    seconds: toMilliseconds(to.stamp - from.stamp) / 1000,
  };
}

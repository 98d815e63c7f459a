import { decelerationFloor, EndOfData } from '../samples/endOfData';
import { silenceMessages } from '../messages/values';
import { type Nanoseconds, toMilliseconds } from '../times';
import type { Pose } from './messages';
import { angleBetween } from './rotation';

/** A speed above this multiple of the previous one is a jump to another place, which is not a part of the motion. */
const JUMP = 5;

/**
 * Assumed largest quantum of a position in m and of an angle in rad. Belts and turntables move at a constant speed, so all steps of a frame may be
 * equal.
 */
const MAX_QUANTUM = 1e-4;
const MAX_ANGLE_QUANTUM = 2e-3;

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
    readonly unit: string,
    isLinear: boolean,
    maxDeceleration: number | null,
  ) {
    this.end = new EndOfData(decelerationFloor(isLinear), maxDeceleration, isLinear ? MAX_QUANTUM : MAX_ANGLE_QUANTUM);
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
}

/** Watches the motion of one frame in its parent, to detect that its data ended during the motion. */
export class FrameMotion {
  readonly #distance: Path;
  readonly #angle: Path;
  #last: { stamp: Nanoseconds; pose: Pose } | null = null;
  /** The end of the motion at the last pose; null before it is judged. */
  #end: End | null = null;

  /** @param maxDeceleration Maximum deceleration of the frame in m/s² and rad/s²; null if unknown. */
  constructor(maxDeceleration: number | null) {
    this.#distance = new Path('m/s²', true, maxDeceleration);
    this.#angle = new Path('rad/s²', false, maxDeceleration);
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
    const { stamp: since, pose: from } = this.#last ?? { stamp, pose };
    const seconds = toMilliseconds(stamp - since) / 1000;
    const distance = Math.hypot(...pose.position.map((metres, i) => metres - from.position[i]));
    this.#distance.add(stamp, distance, seconds);
    this.#angle.add(stamp, angleBetween(from.rotation, pose.rotation), seconds);
    [this.#last, this.#end] = [{ stamp, pose }, null];
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
    const reasons = this.#paths.map(({ end, unit }): End => {
      // Independent objects may decelerate differently, so the motion of other frames is not evidence.
      const verdict = end.verdict(samplingS);
      const required = end.unobserved(samplingS);
      return {
        impossible: verdict === null ? null : silenceMessages.stopTooHard(verdict.required, verdict.limit, unit, verdict.basis),
        unobserved: required === null ? null : silenceMessages.unobservedStop(required, unit),
      };
    });
    const first = (key: keyof End): string | null => reasons.map(reason => reason[key]).find(reason => reason !== null) ?? null;
    return { impossible: first('impossible'), unobserved: first('unobserved') };
  }
}

import { type Nanoseconds, NS_PER_S } from '../times';
import { NOISE_INTERVALS, type Point, positionNoise } from './positionNoise';

/** Maximum number of stored samples of the current motion, and minimum number of samples for a decision about its end. */
const WINDOW = 24;
const MIN_SAMPLES = 4;

/** A motion ends at a gap that is longer than GAP_S, in s, and longer than GAP_INTERVALS times the median interval. */
const GAP_S = 0.3;
const GAP_INTERVALS = 6;

/** Number of newest second differences that are searched for braking. */
const BRAKING = 2;

/**
 * A motion is steady if no earlier speed was below STEADY times the newest speed. Steps are equal if the noise is below EQUAL times the smallest step.
 */
const STEADY = 0.7;
const EQUAL = 1e-9;

/** No sample was skipped in an interval that is shorter than this multiple of the source's sampling interval or of the shortest interval. */
const NO_GAP = 1.6;

/** Number of newest intervals whose median predicts the next interval. With a median, a single late sample does not hide the end of the data. */
const RECENT = 5;

/** Time after the last sample at which the next sample of a moving joint is overdue, as a multiple of the joint's usual interval. */
const OVERDUE_INTERVALS = 2;

/** Minimum number of consecutive second differences against the motion that count as a deceleration. Noise changes its sign more often. */
const SUSTAINED = 3;

/**
 * BRAKING_MARGIN: maximum ratio of the deceleration of a stop to the increase of the deceleration in the last samples, which show only a part of a
 * short stop. SEEN_MARGIN: factor on an observed deceleration, because the deceleration between samples may be larger.
 */
const BRAKING_MARGIN = 4;
const SEEN_MARGIN = 1.5;

/** Number of resolutions q to subtract for the errors of the positions. */
const RESOLUTION_MARGIN = 2;

/**
 * Number of deadbands to subtract. One is the motion that the source does not send after the last sample; the remainder is a reserve. While the floor
 * applies, more are necessary, because a deadband can also hide the braking: with 3, none of 30 000 emergency stops with a deadband exceeds the
 * floor.
 */
const DEADBAND_MARGIN = 1.5;
const FLOOR_DEADBAND_MARGIN = 3;

/** A joint continues to move if its newest sample is more than GOES_ON_S seconds later, and at least GOES_ON_STEPS steps all have one direction. */
const GOES_ON_S = 0.3;
const GOES_ON_STEPS = 3;

/** A joint counts as stopped at its last position if its next motion starts near that position: at most this fraction of its last step away. */
const STOPPED_NEAR = 0.25;

const TURN = 2 * Math.PI;

/** Deceleration that every joint is assumed to be capable of, in rad/s² and m/s²: a third of the deceleration in a hard emergency stop. */
const FLOOR_ROTARY = 12;
const FLOOR_LINEAR = 3;

export const decelerationFloor = (isLinear = false): number => (isLinear ? FLOOR_LINEAR : FLOOR_ROTARY);

/** @param maxDeceleration Configured maximum deceleration in rad/s² or m/s²; null if unknown. */
export const endOfJoint = (isLinear = false, maxDeceleration: number | null = null): EndOfData =>
  new EndOfData(decelerationFloor(isLinear), maxDeceleration, Infinity, !isLinear);

/** Origin of a deceleration limit: the configuration, the joint's samples, or the assumed floor. */
type LimitBasis = 'configured' | 'observed' | 'assumed';

/**
 * Decides whether the data of one joint ended while the joint moved. A source that sends only changes is silent both when the joint is at rest and
 * when the source has failed.
 * @remarks
 * If the joint has been at rest since the last sample xₙ at tₙ, its mean velocity is v = (xₙ − xₙ₋₁) / h₁ in the last interval h₁ and 0 in the
 * next interval h₂. The means belong to the middles of the intervals, which are (h₁ + h₂) / 2 apart. By the mean value theorem for divided
 * differences, the deceleration was therefore, at some instant, at least
 *
 *   a = (|v| − 2q/h₁ − max(2q, 1.5d)/h₂) / ((h₁ + h₂) / 2)      in rad/s² or m/s²
 *
 * where q is the resolution of the positions and d is the deadband, within which the source does not send the motion. While the floor applies, 3d
 * replaces 1.5d. If a is above the limit, the joint cannot have stopped, so the data ended during its motion. The limit is the configured one or,
 * without it, the largest of four values: the floor, 1.5 times the largest observed deceleration, 1.5 times the deceleration in the last samples, and
 * 4 times the increase of the deceleration in the last samples. The last two are sufficient: for a constant deceleration that lasts at least 0.4 h,
 * a does not exceed them. For a shorter one of size A, a ≤ 0.32 A, so the floor admits each stop with A up to 3 times the floor. The floor allows for
 * emergency stops, which stop all joints. It is therefore left out while another joint continues to move, if a deceleration of this joint has been
 * observed.
 */
export class EndOfData {
  readonly #points: Point[] = [];
  #start: Nanoseconds | null = null;
  #newest: Nanoseconds | null = null;
  /** Smallest nonzero change of position between two consecutive samples so far, and smallest mean speed of such a change. */
  #smallestStep = Infinity;
  #smallestSpeed = Infinity;
  #largestSeen = 0;

  /**
   * @param floor Deceleration that the joint is assumed to be capable of, in rad/s² or m/s².
   * @param configured Configured maximum deceleration in the same unit, which replaces the floor and the observed values. Null if unknown.
   * @param maxQuantum Largest quantum of a value that changes by one quantum per sample. Larger steps that are all equal are a constant speed.
   * @param isAngle Whether the position is an angle in rad, which a source may state without whole turns.
   */
  constructor(
    readonly floor: number,
    readonly configured: number | null = null,
    readonly maxQuantum = Infinity,
    readonly isAngle = false,
  ) {}

  /** Time after the last sample at which the next sample of a moving joint is overdue, in ms. */
  get overdueMs(): number {
    return 1000 * OVERDUE_INTERVALS * this.interval;
  }

  /** Median interval between the newest samples of the motion, in seconds; zero before the second sample. */
  get interval(): number {
    return median(this.#intervals().slice(-RECENT));
  }

  /** Adds a sample, which is newer than the previous one. */
  add(stamp: Nanoseconds, value: number): void {
    this.#start ??= stamp;
    const time = this.#secondsOf(stamp);
    const last = this.#points.at(-1);
    // Adds the whole turns that a modulo axis leaves out, since a joint moves by less than half a turn between two samples.
    const position = this.isAngle && last !== undefined ? value - TURN * Math.round((value - last.position) / TURN) : value;
    if (last !== undefined && (time <= last.time || this.#isGap(time - last.time))) {
      if (time > last.time) this.#learnStop(position);
      this.#points.length = 0;
    }
    const step = last === undefined ? 0 : Math.abs(position - last.position);
    if (step > 0 && time > last!.time) {
      this.#smallestStep = Math.min(this.#smallestStep, step);
      this.#smallestSpeed = Math.min(this.#smallestSpeed, step / (time - last!.time));
    }
    this.#points.push({ time, position });
    this.#newest = stamp;
    if (this.#points.length > WINDOW) this.#points.shift();
    this.#largestSeen = Math.max(this.#largestSeen, this.#sustained());
  }

  /** Prepares for a new connection: discards the motion, but keeps the observed properties of the joint. */
  restart(): void {
    this.#points.length = 0;
    this.#start = null;
    this.#newest = null;
  }

  /** Whether the joint continued to move for a while after a stamp. */
  goesOnAfter(stamp: Nanoseconds): boolean {
    const from = this.#start === null ? 0 : this.#secondsOf(stamp);
    const after = this.#points.filter(({ time }) => time > from);
    const directions = new Set(after.slice(1).map(({ position }, i) => Math.sign(position - after[i].position)));
    return after.length > GOES_ON_STEPS && after.at(-1)!.time - from > GOES_ON_S && directions.size === 1 && !directions.has(0);
  }

  /** Stamp of the last sample; null if there is none. */
  get newest(): Nanoseconds | null {
    return this.#newest;
  }

  /**
   * Gets the reason why the joint cannot have stopped at its last sample; null if it can.
   * @param samplingS Sampling interval of the source in seconds; 0 if unknown.
   * @param areOthersMoving Whether another joint continues to move, which excludes an emergency stop.
   */
  verdict(samplingS: number, areOthersMoving = false): { required: number; limit: number; basis: LimitBasis } | null {
    if (this.#points.length < MIN_SAMPLES) return null;
    const isFloorLeftOut = areOthersMoving && this.#largestSeen > 0;
    const observed = this.#observed();
    const required = this.#required(samplingS, isFloorLeftOut ? DEADBAND_MARGIN : FLOOR_DEADBAND_MARGIN);
    const limit = this.configured ?? (isFloorLeftOut ? observed : Math.max(this.floor, observed));
    const basis = this.configured !== null ? 'configured' : limit === observed ? 'observed' : 'assumed';
    return required > limit ? { required, limit, basis } : null;
  }

  /** Gets the deceleration required for a stop at the last sample if it exceeds the limit from the observed decelerations; null otherwise. */
  unobserved(samplingS: number): number | null {
    if (this.#points.length < MIN_SAMPLES || this.configured !== null) return null;
    const required = this.#required(samplingS, FLOOR_DEADBAND_MARGIN);
    return required > this.#observed() ? required : null;
  }

  /** Gets the deceleration that the joint is capable of according to its samples. */
  #observed(): number {
    const decelerations = this.#decelerations(BRAKING + 1).reverse();
    const newest = decelerations.slice(0, BRAKING);
    const increases = newest.map((deceleration, i) => deceleration - (decelerations[i + 1] ?? 0));
    return Math.max(SEEN_MARGIN * Math.max(this.#largestSeen, ...newest), BRAKING_MARGIN * Math.max(...increases));
  }

  /** Updates the largest observed deceleration if the joint starts again at its last position, because it has stopped there. */
  #learnStop(position: number): void {
    if (this.#points.length < MIN_SAMPLES) return;
    const [before, last] = this.#points.slice(-2);
    if (Math.abs(position - last.position) <= STOPPED_NEAR * Math.abs(last.position - before.position))
      this.#largestSeen = Math.max(this.#largestSeen, this.#required(0, DEADBAND_MARGIN));
  }

  #secondsOf(stamp: Nanoseconds): number {
    return Number(stamp - this.#start!) / Number(NS_PER_S);
  }

  #required(samplingS: number, deadbandMargin: number): number {
    const h1 = this.#intervals().at(-1)!;
    const h2 = Math.max(samplingS, this.interval);
    const [before, last] = this.#points.slice(-2);
    const speed = Math.abs(last.position - before.position) / h1;
    const q = this.#resolution(samplingS);
    // The deadband is at most the smallest step. A joint that has only moved at a single speed has no small step, so no deadband is assumed.
    const deadband = this.#smallestSpeed > STEADY * speed ? q : this.#smallestStep;
    const [error, hidden] = [RESOLUTION_MARGIN * q, deadbandMargin * deadband];
    return (speed - error / h1 - Math.max(error, hidden) / h2) / ((h1 + h2) / 2);
  }

  /**
   * Gets an upper bound of the resolution of the positions: the smallest step so far. If the source sent a sample at each sampling instant, the noise
   * of the positions is another upper bound, unless all steps are equal, as when a quantised value changes by one step per sampling instant.
   */
  #resolution(samplingS: number): number {
    const intervals = this.#intervals().slice(-NOISE_INTERVALS);
    const usual = Math.max(samplingS, Math.min(...intervals));
    const noise = intervals.every(interval => interval < NO_GAP * usual) ? positionNoise(this.#points) : null;
    const bound = noise === null ? Infinity : noise <= EQUAL * this.#smallestStep ? this.maxQuantum : noise;
    return Math.min(this.#smallestStep, bound);
  }

  /** Gets the decelerations from the newest second differences, the newest one last; 0 for an acceleration. */
  #decelerations(count: number): number[] {
    const points = this.#points;
    const decelerations: number[] = [];
    for (let i = Math.max(2, points.length - count); i < points.length; i++) {
      const [first, middle, last] = [points[i - 2], points[i - 1], points[i]];
      const h1 = middle.time - first.time;
      const h2 = last.time - middle.time;
      const v1 = (middle.position - first.position) / h1;
      const v2 = (last.position - middle.position) / h2;
      const acceleration = (v2 - v1) / ((h1 + h2) / 2);
      decelerations.push(Math.max(0, -Math.sign(v1 + v2) * acceleration));
    }
    return decelerations;
  }

  #sustained(): number {
    const newest = this.#decelerations(SUSTAINED);
    return newest.length < SUSTAINED ? 0 : Math.min(...newest);
  }

  #isGap(interval: number): boolean {
    if (interval <= GAP_S) return false;
    return interval > GAP_INTERVALS * median(this.#intervals());
  }

  #intervals(): number[] {
    return this.#points.slice(1).map(({ time }, i) => time - this.#points[i].time);
  }
}

/** Gets the median; zero for an empty list. */
function median(values: number[]): number {
  return values.length === 0 ? 0 : [...values].sort((a, b) => a - b)[values.length >> 1];
}

import type { ClockReading } from '../clock/plantClock';
import { type Nanoseconds, NS_PER_MS, NS_PER_S } from '../times';

/** Maximum rate difference between the controller's clock and this machine's; headsets use the same limit. */
const MAX_SKEW_PPM = 700n;

/** Maximum age of the newest package for reading the time. */
const SILENCE: Nanoseconds = NS_PER_S;

/** If all packages are late by this much for this period, the clock has stepped. Used when answers cannot show it. */
const LATE: Nanoseconds = 50n * NS_PER_MS;
const PERIOD: Nanoseconds = NS_PER_S;

/**
 * The controller's clock, measured only from the packages that it streams.
 *
 * A package arrives after its timestamp: controller time minus this machine's is at least timestamp − arrival, and the fastest package gives
 * the best lower bound. The first package after the answer to a request was sent after the request, and at most the send delay after its
 * timestamp: controller time minus this machine's is at most timestamp + send delay − time of the request. The true value lies between
 * the two bounds, which diverge with the largest rate difference until the next package or answer.
 */
export class RobotClock {
  #lower: Nanoseconds | null = null;
  #upper: Nanoseconds | null = null;
  #updated: Nanoseconds = 0n;
  #newest: Nanoseconds | null = null;
  /** Time since which all packages have been late, and the lower bound from the earliest of them. */
  #late: { since: Nanoseconds; lower: Nanoseconds } | null = null;
  /** Fixed distance of the bounds while no answer renews the upper one; null while answers do. */
  #kept: Nanoseconds | null = null;

  /**
   * @param sendDelay Maximum time from a package's timestamp until the controller sends it.
   * @param stepped Called when the clock contradicts its earlier times. It is then measured again.
   */
  constructor(
    readonly sendDelay: Nanoseconds,
    readonly stepped: (by: Nanoseconds) => void = () => {},
  ) {}

  /** Distance between the two bounds; null while the upper one is unknown. */
  get width(): Nanoseconds | null {
    return this.#lower === null || this.#upper === null ? null : this.#upper - this.#lower;
  }

  /**
   * Call this when the controller does not answer while it streams. From now on, the fastest package is assumed to take no longer than the
   * fastest answer's round-trip time before, or than shown by its first package.
   */
  expectNoAnswers(roundTrip: Nanoseconds): void {
    const longest = this.sendDelay + roundTrip;
    const { width } = this;
    this.#kept = width === null || longest < width ? longest : width;
  }

  /**
   * @param arrived Arrival time on this machine's counter.
   * @param asked Time of the request whose answer arrived just before this package; null without one.
   */
  heard(timestamp: Nanoseconds, arrived: Nanoseconds, asked: Nanoseconds | null): void {
    this.#age(arrived);
    this.#newest = arrived;
    const before = this.#lower;
    const lower = timestamp - arrived;
    const answered = asked === null ? null : timestamp + this.sendDelay - asked;
    if (before === null || lower > before) this.#lower = lower;
    if (answered !== null && (this.#upper === null || answered < this.#upper)) this.#upper = answered;
    if (this.#kept !== null) this.#upper = this.#lower! + this.#kept;
    if (before === null || !this.#isContradicted(before, lower, arrived)) return;
    const restarted = this.#late?.lower ?? lower;
    this.#lower = restarted;
    this.#upper = this.#kept === null ? answered : restarted + this.#kept;
    this.#late = null;
    this.stepped(restarted - before);
  }

  /** @throws Error The robot is silent, or its time is not bounded yet. */
  at(now: Nanoseconds): ClockReading {
    if (this.#newest === null || now - this.#newest > SILENCE) throw new Error('the robot sends no data');
    this.#age(now);
    const { width } = this;
    if (width === null) throw new Error("the robot's clock is not measured yet");
    // The fastest package is closest to the true value; the bound includes everything that a later one could show.
    const time = now + this.#lower!;
    return { received: time, sent: time, resolution: 1n, errorBound: width };
  }

  #age(now: Nanoseconds): void {
    const drift = now > this.#updated ? ((now - this.#updated) * MAX_SKEW_PPM) / 1_000_000n : 0n;
    this.#updated = now;
    if (this.#lower !== null) this.#lower -= drift;
    if (this.#upper !== null) this.#upper += this.#kept === null ? drift : -drift;
  }

  #isContradicted(before: Nanoseconds, lower: Nanoseconds, arrived: Nanoseconds): boolean {
    if (this.#kept === null) return this.#upper !== null && this.#upper < this.#lower!;
    if (before - lower < LATE) this.#late = null;
    else if (this.#late === null || lower > this.#late.lower) this.#late = { since: this.#late?.since ?? arrived, lower };
    return lower - before >= LATE || (this.#late !== null && arrived - this.#late.since >= PERIOD);
  }
}

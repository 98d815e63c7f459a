import type { ClockReading } from '../clock/plantClock';
import { type Nanoseconds, NS_PER_MS, NS_PER_S } from '../times';
import { rtdeMessages } from '../messages/rtde';

/** Maximum rate difference between the controller's clock and this machine's; headsets use the same limit. */
const MAX_SKEW_PPM = 700n;

/** Maximum age of the newest package for reading the time. */
const SILENCE: Nanoseconds = NS_PER_S;

/** If all packages are late by this much for the period, the clock has stepped. Used when answers cannot show it. */
const LATE: Nanoseconds = 50n * NS_PER_MS;

/** Minimum duration of a contradiction: a busy controller or machine is late for shorter times. */
const PERIOD: Nanoseconds = NS_PER_S;

/** Time constant with which a distance of the bounds that had to be widened returns to the assumed one. */
const RETURN: Nanoseconds = 60n * NS_PER_S;

/** Number of stored upper bounds. The next larger one takes over when the smallest is refuted. */
const ANSWERS = 8;

/** If this many answers in a row are below the lower bound for the period, the clock has stepped back. */
const REFUTED = 5;

/**
 * The controller's clock, measured only from the packages that it streams.
 *
 * A package arrives after its timestamp: controller time minus this machine's is at least timestamp − arrival, and the fastest package gives
 * the best lower bound. The first package after the answer to a request was sent after the request, and at most the send delay after its
 * timestamp: controller time minus this machine's is at most timestamp + send delay − time of the request. The true value lies between
 * the two bounds, which diverge with the largest rate difference until the next package or answer. A controller that sends a package later
 * than the send delay gives a wrong upper bound; one below the lower bound is refuted by it and ignored.
 */
export class RobotClock {
  #lower: Nanoseconds | null = null;
  /** The smallest upper bounds of answers, in ascending order, without those below the lower bound. */
  #uppers: Nanoseconds[] = [];
  #updated: Nanoseconds = 0n;
  #newest: Nanoseconds | null = null;
  /** Since when all answers or packages have been late, the number of these answers, and the lower bound from the earliest package since. */
  #late: { since: Nanoseconds; answers: number; lower: Nanoseconds } | null = null;
  /** Distance of the bounds while no answer renews the upper one, and its smallest value; null while answers do. */
  #kept: { assumed: Nanoseconds; width: Nanoseconds } | null = null;

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
    if (this.#lower === null) return null;
    return this.#kept?.width ?? (this.#uppers.length === 0 ? null : this.#uppers[0] - this.#lower);
  }

  /**
   * Call this when the controller does not answer while it streams. From now on, the fastest package is assumed to take no longer than the
   * fastest answer's round-trip time before, or than shown by its first package. A package that is faster by more than expected shows that the
   * ones before were late, and widens the bounds for the next minutes.
   */
  expectNoAnswers(roundTrip: Nanoseconds): void {
    const longest = this.sendDelay + roundTrip;
    const { width } = this;
    const assumed = width === null || longest < width ? longest : width;
    this.#kept = { assumed, width: assumed };
  }

  /**
   * @param arrived Arrival time on this machine's counter.
   * @param asked Time of the request whose answer arrived just before this package; null if there is none.
   */
  heard(timestamp: Nanoseconds, arrived: Nanoseconds, asked: Nanoseconds | null): void {
    this.#age(arrived);
    this.#newest = arrived;
    const lower = timestamp - arrived;
    const before = this.#lower ?? lower;
    this.#lower = lower > before ? lower : before;
    const answered = asked === null ? null : timestamp + this.sendDelay - asked;
    if (this.#late !== null && lower > this.#late.lower) this.#late.lower = lower;
    this.#widen(lower - before);
    const isContradicted = this.#kept === null ? this.#areAnswersRefuted(answered, lower, arrived) : this.#areAllFar(before, lower, arrived);
    if (!isContradicted) return;
    this.#lower = this.#late?.lower ?? lower;
    this.#uppers = answered === null || answered < this.#lower ? [] : [answered];
    this.#late = null;
    this.stepped(this.#lower - before);
  }

  /** @throws Error The robot is silent, or its time is not bounded yet. */
  at(now: Nanoseconds): ClockReading {
    if (this.#newest === null || now - this.#newest > SILENCE) throw new Error(rtdeMessages.noData);
    this.#age(now);
    const { width } = this;
    if (width === null) throw new Error(rtdeMessages.clockNotMeasured);
    // The fastest package is closest to the true value; the bound includes everything that a later one could show.
    const time = now + this.#lower!;
    return { received: time, sent: time, resolution: 1n, errorBound: width };
  }

  #age(now: Nanoseconds): void {
    const passed = now > this.#updated ? now - this.#updated : 0n;
    const drift = (passed * MAX_SKEW_PPM) / 1_000_000n;
    this.#updated = now;
    if (this.#kept !== null) this.#kept.width -= ((this.#kept.width - this.#kept.assumed) * (passed < RETURN ? passed : RETURN)) / RETURN;
    if (this.#lower !== null) this.#lower -= drift;
    this.#uppers = this.#uppers.map(upper => upper + drift);
  }

  /** Takes the time by which a package was faster than expected. Half of it is added, because the next late period may be longer. */
  #widen(faster: Nanoseconds): void {
    if (this.#kept === null || faster >= LATE) return;
    const width = this.#kept.assumed + (3n * faster) / 2n;
    if (width > this.#kept.width) this.#kept.width = width;
  }

  /** Takes an answer. Returns whether the lower bound is above all earlier answers, or several new ones in a row are below it. */
  #areAnswersRefuted(answered: Nanoseconds | null, lower: Nanoseconds, arrived: Nanoseconds): boolean {
    const isLate = answered !== null && answered < this.#lower!;
    if (isLate) {
      this.#late ??= { since: arrived, answers: 0, lower };
      this.#late.answers++;
    } else if (answered !== null) {
      this.#late = null;
    }
    const upheld = this.#uppers.filter(upper => upper >= this.#lower!);
    const areAllBelow = this.#uppers.length > 0 && upheld.length === 0;
    this.#uppers = answered === null || isLate ? upheld : [...upheld, answered].sort((a, b) => (a < b ? -1 : 1)).slice(0, ANSWERS);
    return areAllBelow || (this.#late !== null && this.#late.answers >= REFUTED && arrived - this.#late.since >= PERIOD);
  }

  /** Returns whether a package is far earlier, or all packages of a period are far later, than expected. */
  #areAllFar(before: Nanoseconds, lower: Nanoseconds, arrived: Nanoseconds): boolean {
    if (before - lower < LATE) this.#late = null;
    else this.#late ??= { since: arrived, answers: 0, lower };
    return lower - before >= LATE || (this.#late !== null && arrived - this.#late.since >= PERIOD);
  }
}

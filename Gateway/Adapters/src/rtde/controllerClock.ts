import type { ClockReading } from '../clock/offeredClock';
import { type Nanoseconds, NS_PER_MS, NS_PER_S } from '../times';
import { rtdeMessages } from '../messages/rtde';

/** Maximum skew between the controller's clock and this machine's counter. Headsets use the same limit. */
const MAX_SKEW_PPM = 700n;

/** Maximum age of the newest package. If it is older, the clock cannot be read. */
const SILENCE: Nanoseconds = NS_PER_S;

/**
 * If the controller does not respond to requests, its clock counts as stepped when one package arrives at least this much earlier than expected, or
 * when all packages within PERIOD arrive at least this much later than expected.
 */
const LATE: Nanoseconds = 50n * NS_PER_MS;

/** Minimum duration of a contradiction that shows a step of the clock. A busy controller or machine is late for shorter times. */
const PERIOD: Nanoseconds = NS_PER_S;

/** Time constant with which the distance between the bounds returns to the assumed distance after it was widened. */
const RETURN: Nanoseconds = 60n * NS_PER_S;

/** Maximum number of stored upper bounds. When the smallest bound is refuted, the next larger one is used. */
const ANSWERS = 8;

/**
 * Minimum number of consecutive responses with an upper bound below the lower bound that show, within at least PERIOD, that the clock stepped
 * back.
 */
const REFUTED = 5;

/**
 * The controller's clock. It is measured from the data packages that the controller streams and from its responses to requests.
 *
 * The offset is controller time minus this machine's time. A package arrives after its timestamp, so the offset is at least timestamp − arrival. The
 * fastest package gives the best lower bound. The first package after the response to a request was sent after the request, and at most the send
 * delay after its timestamp, so the offset is at most timestamp + send delay − time of the request. The offset lies between the two bounds, which
 * diverge with the maximum skew until the next package or response. If the controller sends a package later than the send delay, the upper bound is
 * wrong. An upper bound below the lower bound is therefore refuted and ignored.
 */
export class ControllerClock {
  #lower: Nanoseconds | null = null;
  /** The smallest upper bounds from responses that are not below the lower bound, in ascending order. */
  #uppers: Nanoseconds[] = [];
  #updated: Nanoseconds = 0n;
  #newest: Nanoseconds | null = null;
  /** Time since which all responses or packages have been late, number of these responses, and largest lower bound from a package since then. */
  #late: { since: Nanoseconds; answers: number; lower: Nanoseconds } | null = null;
  /**
   * Distance between the bounds while the controller does not respond: the current distance (`width`) and its minimum (`assumed`). Null while
   * responses give upper bounds.
   */
  #kept: { assumed: Nanoseconds; width: Nanoseconds } | null = null;

  /**
   * @param sendDelay Maximum time from a package's timestamp until the controller sends it.
   * @param stepped Called with the size of the step when the clock contradicts its earlier times. The clock is then measured again.
   */
  constructor(
    readonly sendDelay: Nanoseconds,
    readonly stepped: (by: Nanoseconds) => void = () => {},
  ) {}

  /** Distance between the two bounds; null while the upper bound is unknown. */
  get width(): Nanoseconds | null {
    if (this.#lower === null) return null;
    return this.#kept?.width ?? (this.#uppers.length === 0 ? null : this.#uppers[0] - this.#lower);
  }

  /**
   * Assumes a distance between the two bounds from now on. Call this method if the controller does not respond to requests while it streams, because
   * only responses give upper bounds. The assumed distance is the send delay plus the round-trip time, or the current distance if that is smaller.
   * A package that arrives earlier than expected shows that the previous packages were late. It increases the distance, which then returns to the
   * assumed distance.
   * @param roundTrip Shortest round-trip time of the requests so far that received a response.
   */
  expectNoAnswers(roundTrip: Nanoseconds): void {
    const longest = this.sendDelay + roundTrip;
    const { width } = this;
    const assumed = width === null || longest < width ? longest : width;
    this.#kept = { assumed, width: assumed };
  }

  /**
   * Adds a data package.
   * @param timestamp Timestamp of the package on the controller's clock.
   * @param arrived Arrival time on this machine's counter.
   * @param asked Time of the request whose response arrived just before this package; null if there is none.
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

  /**
   * Gets the controller's time for a given time of this machine's counter.
   * @throws Error The controller sends no data, or its clock is not measured yet.
   */
  at(now: Nanoseconds): ClockReading {
    if (this.#newest === null || now - this.#newest > SILENCE) throw new Error(rtdeMessages.noData);
    this.#age(now);
    const { width } = this;
    if (width === null) throw new Error(rtdeMessages.clockNotMeasured);
    // Uses the lower bound, because the fastest package is closest to the offset. The error bound includes every offset that is still possible.
    const time = now + this.#lower!;
    return { received: time, sent: time, resolution: 1n, errorBound: width };
  }

  #age(now: Nanoseconds): void {
    const passed = now > this.#updated ? now - this.#updated : 0n;
    const change = (passed * MAX_SKEW_PPM) / 1_000_000n;
    this.#updated = now;
    if (this.#kept !== null) this.#kept.width -= ((this.#kept.width - this.#kept.assumed) * (passed < RETURN ? passed : RETURN)) / RETURN;
    if (this.#lower !== null) this.#lower -= change;
    this.#uppers = this.#uppers.map(upper => upper + change);
  }

  /**
   * Widens the distance between the bounds if a package arrived earlier than expected: to the assumed distance plus 1.5 times this difference,
   * because the next late period may be longer.
   */
  #widen(faster: Nanoseconds): void {
    if (this.#kept === null || faster >= LATE) return;
    const width = this.#kept.assumed + (3n * faster) / 2n;
    if (width > this.#kept.width) this.#kept.width = width;
  }

  /**
   * Adds the upper bound from a response. Returns whether the clock has stepped. It has stepped if all earlier upper bounds are below the lower
   * bound, or if at least REFUTED consecutive new upper bounds have been below it for at least PERIOD.
   */
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

  /** Whether the clock has stepped: a package is earlier than expected by LATE or more, or all packages within PERIOD are later by LATE or more. */
  #areAllFar(before: Nanoseconds, lower: Nanoseconds, arrived: Nanoseconds): boolean {
    if (before - lower < LATE) this.#late = null;
    else this.#late ??= { since: arrived, answers: 0, lower };
    return lower - before >= LATE || (this.#late !== null && arrived - this.#late.since >= PERIOD);
  }
}

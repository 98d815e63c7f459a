import type { ClockReading } from '../clock/plantClock';
import { type Nanoseconds, NS_PER_MS, NS_PER_S } from '../times';

/** Largest rate difference between the controller's clock and this machine's, the one that headsets assume too. */
const GREATEST_SKEW_PPM = 700n;

/** Without a newer package the time is not told. */
const SILENCE: Nanoseconds = NS_PER_S;

/** Packages that all come this much too late, for a period, contradict the earlier ones where no answer can. */
const LATE: Nanoseconds = 50n * NS_PER_MS, PERIOD: Nanoseconds = NS_PER_S;

/**
 * The controller's clock, which tells its time by the packages that it streams alone.
 *
 * A package arrives after its timestamp: controller time minus this machine's is at least timestamp − arrival, and the fastest package tells
 * most. The first package behind the answer to a request was sent after the request, and at most the send delay after its timestamp:
 * controller time minus this machine's is at most timestamp + send delay − time of the request. The truth lies between the two bounds,
 * which move apart by the largest rate difference until the next package or answer.
 */
export class RobotClock {
  #least: Nanoseconds | null = null;
  #greatest: Nanoseconds | null = null;
  #updated: Nanoseconds = 0n;
  #newest: Nanoseconds | null = null;
  /** Since when all packages have been late, and the bound by the earliest of them. */
  #late: { since: Nanoseconds; least: Nanoseconds } | null = null;
  /** Distance of the bounds where no answer renews the upper one; null while answers do. */
  #kept: Nanoseconds | null = null;

  /**
   * @param sendDelay How long after its timestamp the controller sends a package, at most.
   * @param stepped Called when the clock contradicts what it showed before; it is measured anew then.
   */
  constructor(readonly sendDelay: Nanoseconds, readonly stepped: (by: Nanoseconds) => void = () => {}) {}

  /** Distance between the two bounds; null while the upper one is unknown. */
  get width(): Nanoseconds | null { return this.#least === null || this.#greatest === null ? null : this.#greatest - this.#least; }

  /**
   * The controller does not answer while it streams. From now on the fastest package is taken to travel no longer than the fastest answer's
   * round trip before, or than its first package proved.
   */
  expectNoAnswers(roundTrip: Nanoseconds): void {
    const longest = this.sendDelay + roundTrip, { width } = this;
    this.#kept = width === null || longest < width ? longest : width;
  }

  /**
   * @param arrived On this machine's counter.
   * @param asked When the request was sent whose answer came just before this package; null without one.
   */
  heard(timestamp: Nanoseconds, arrived: Nanoseconds, asked: Nanoseconds | null): void {
    this.#age(arrived);
    this.#newest = arrived;
    const before = this.#least, least = timestamp - arrived, answered = asked === null ? null : timestamp + this.sendDelay - asked;
    if (before === null || least > before) this.#least = least;
    if (answered !== null && (this.#greatest === null || answered < this.#greatest)) this.#greatest = answered;
    if (this.#kept !== null) this.#greatest = this.#least! + this.#kept;
    if (before === null || !this.#isContradicted(before, least, arrived)) return;
    const restarted = this.#late?.least ?? least;
    this.#least = restarted;
    this.#greatest = this.#kept === null ? answered : restarted + this.#kept;
    this.#late = null;
    this.stepped(restarted - before);
  }

  /** @throws Error The robot is silent, or nothing bounds its time yet. */
  at(now: Nanoseconds): ClockReading {
    if (this.#newest === null || now - this.#newest > SILENCE) throw new Error('the robot sends no data');
    this.#age(now);
    const { width } = this;
    if (width === null) throw new Error('the robot\'s clock is not measured yet');
    // The fastest package is nearest to the truth; the bound covers all that a later one could show.
    const time = now + this.#least!;
    return { received: time, sent: time, resolution: 1n, errorBound: width };
  }

  #age(now: Nanoseconds): void {
    const drift = now > this.#updated ? (now - this.#updated) * GREATEST_SKEW_PPM / 1_000_000n : 0n;
    this.#updated = now;
    if (this.#least !== null) this.#least -= drift;
    if (this.#greatest !== null) this.#greatest += this.#kept === null ? drift : -drift;
  }

  #isContradicted(before: Nanoseconds, least: Nanoseconds, arrived: Nanoseconds): boolean {
    if (this.#kept === null) return this.#greatest !== null && this.#greatest < this.#least!;
    if (before - least < LATE) this.#late = null;
    else if (this.#late === null || least > this.#late.least) this.#late = { since: this.#late?.since ?? arrived, least };
    return least - before >= LATE || this.#late !== null && arrived - this.#late.since >= PERIOD;
  }
}

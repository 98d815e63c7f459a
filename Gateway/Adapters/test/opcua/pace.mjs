/** Time in which the motion comes to rest, and in which it is as fast as before, ns. */
const RAMP = 500_000_000n;

/** Integral of a speed that rises from 0 to 1 during RAMP. */
const risen = t => t <= 0n ? 0n : t >= RAMP ? t - RAMP / 2n : t * t / (2n * RAMP);

/** Brings a motion to rest and lets it go on, without a jump of its speed. Times in ns. */
export class Pace {
  #lag = 0n;
  #rest = null;

  /** Time of the motion for a time of the clock. */
  at(time) {
    if (this.#rest === null) return time;
    return time - this.#lag - risen(time - this.#rest.from) + risen(time - this.#rest.until);
  }

  /** Slows down from a time on and stands still for a length. Returns the time at which the motion is as fast as before. */
  rest(from, length) {
    const until = from + RAMP + length;
    this.#lag = from - this.at(from);
    this.#rest = { from, until };
    return until + RAMP;
  }
}

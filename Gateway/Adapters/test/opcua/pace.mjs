/** Time in which the motion comes to rest, and in which it returns to full speed, in ns. */
const RAMP = 500_000_000n;

/** Integral of a speed factor that rises from 0 to 1 during RAMP, in ns. */
const risen = t => t <= 0n ? 0n : t >= RAMP ? t - RAMP / 2n : t * t / (2n * RAMP);

/** Brings a motion to rest and resumes it without a jump of its speed. Times in ns. */
export class Pace {
  #lag = 0n;
  #rest = null;

  /** Converts a time of the clock to a time of the motion. */
  at(time) {
    if (this.#rest === null) return time;
    return time - this.#lag - risen(time - this.#rest.from) + risen(time - this.#rest.until);
  }

  /** Slows down from `from` on and stands still for `length`. Returns the time at which the motion is at full speed again. */
  rest(from, length) {
    const until = from + RAMP + length;
    this.#lag = from - this.at(from);
    this.#rest = { from, until };
    return until + RAMP;
  }
}

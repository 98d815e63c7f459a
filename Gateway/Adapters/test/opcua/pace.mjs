/** Time in ns in which the motion comes to rest, and in which it later returns to full speed. */
const RAMP = 500_000_000n;

/** Integral from 0 to t, in ns, of a speed factor that increases linearly from 0 to 1 during RAMP. */
const risen = t => t <= 0n ? 0n : t >= RAMP ? t - RAMP / 2n : t * t / (2n * RAMP);

/** Brings a motion to rest and resumes it later, without a jump of its speed. All times are in ns. */
export class Pace {
  #lag = 0n;
  #rest = null;

  /** Converts a time of the clock to the time of the motion, which does not advance at rest. */
  at(time) {
    if (this.#rest === null) return time;
    return time - this.#lag - risen(time - this.#rest.from) + risen(time - this.#rest.until);
  }

  /** Slows the motion down from the time `from`, then holds it for `length`. Returns the time at which it has its full speed again. */
  rest(from, length) {
    const until = from + RAMP + length;
    this.#lag = from - this.at(from);
    this.#rest = { from, until };
    return until + RAMP;
  }
}

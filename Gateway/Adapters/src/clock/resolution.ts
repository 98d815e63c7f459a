import { type Nanoseconds, NS_PER_S } from '../times';

const STEPS: Nanoseconds[] = [1_000_000_000n, 100_000_000n, 10_000_000n, 1_000_000n, 100_000n, 10_000n, 1_000n, 100n, 1n];
const ENOUGH = 8;
const REMEMBERED = 32;

/** A clock that shows one time for longer is stopped, not coarse: a simulation that is paused. */
const STOPPED: Nanoseconds = NS_PER_S;

/** A standstill counts for this long, and for up to as long again. */
const PERIOD: Nanoseconds = 30n * NS_PER_S;

/**
 * How coarse a clock is, by the times that it told: the largest power of ten that divides all of them, or, for a clock that stands still
 * between two updates, how long it stood lately.
 */
export class Resolution {
  readonly #seen: Nanoseconds[] = [];
  #step = STEPS[0];
  #distinct = 0;
  #last: { time: Nanoseconds; heard: Nanoseconds } | null = null;
  #asked: Nanoseconds | null = null;
  #before: Nanoseconds | null = null;
  #standing: Nanoseconds = 0n;
  #stood: Nanoseconds = 0n;
  #stoodBefore: Nanoseconds = 0n;
  #since: Nanoseconds | null = null;

  /** Eight different times: by chance all of them would be whole milliseconds once in 10³². */
  get isKnown(): boolean { return this.#distinct >= ENOUGH; }

  /** Whether the newest time is one that the clock has shown for more than a second. */
  get isStopped(): boolean { return this.#standing > STOPPED; }

  /** Zero while unknown. */
  get value(): Nanoseconds {
    if (!this.isKnown) return 0n;
    const now = this.isStopped ? 0n : this.#standing;
    return [this.#stood, this.#stoodBefore, now].reduce(greatest, this.#step);
  }

  /**
   * @param asked On a counter of this machine, before the time was asked for.
   * @param heard On the same counter, when it had come.
   */
  observe(time: Nanoseconds, asked: Nanoseconds, heard: Nanoseconds): void {
    const askedBefore = this.#asked;
    this.#asked = asked;
    if (time === this.#last?.time) {
      // Both readings were surely taken between these two moments of ours.
      this.#standing = asked - this.#last.heard;
      return;
    }
    this.#endStandstill(time, heard, askedBefore ?? asked);
    this.#before = askedBefore;
    this.#last = { time, heard };
    while (time % this.#step !== 0n) this.#step = STEPS[STEPS.indexOf(this.#step) + 1];
    if (this.#seen.includes(time)) return;
    this.#distinct++;
    this.#seen.push(time);
    if (this.#seen.length > REMEMBERED) this.#seen.shift();
  }

  /** @param asked Before the newest reading that showed the same. */
  #endStandstill(time: Nanoseconds, heard: Nanoseconds, asked: Nanoseconds): void {
    this.#since ??= heard;
    if (heard - this.#since > PERIOD) {
      [this.#stoodBefore, this.#stood] = [heard - this.#since > 2n * PERIOD ? 0n : this.#stood, 0n];
      this.#since = heard;
    }
    const stood = this.#lengthOfStandstill(time, heard, asked);
    if (stood > this.#stood) this.#stood = stood;
    this.#standing = 0n;
  }

  /**
   * It was seen to stand for less than it stood: by how much it goes on tells the length, where it is read often enough. Said too small,
   * it would be believed to the nanosecond. A stop says nothing about how coarse the clock is.
   */
  #lengthOfStandstill(time: Nanoseconds, heard: Nanoseconds, asked: Nanoseconds): Nanoseconds {
    if (this.#standing <= 0n || this.#last === null || this.isStopped) return 0n;
    if (heard - asked > this.#standing) return this.#standing;
    const longest = least(heard - (this.#before ?? this.#last.heard), STOPPED);
    return greatest(this.#standing, least(time - this.#last.time, longest));
  }
}

const least = (a: Nanoseconds, b: Nanoseconds): Nanoseconds => a < b ? a : b;
const greatest = (a: Nanoseconds, b: Nanoseconds): Nanoseconds => a > b ? a : b;

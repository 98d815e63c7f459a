import { type Nanoseconds, NS_PER_S } from '../times';

const STEPS: Nanoseconds[] = [1_000_000_000n, 100_000_000n, 10_000_000n, 1_000_000n, 100_000n, 10_000n, 1_000n, 100n, 1n];
const ENOUGH = 8;
const REMEMBERED = 32;

/** A clock that shows one time for longer is stopped, not coarse, for example in a paused simulation. */
const STOPPED: Nanoseconds = NS_PER_S;

/** A standstill counts for one to two of these periods. */
const PERIOD: Nanoseconds = 30n * NS_PER_S;

/**
 * The resolution of a clock from its times: the largest power of ten that divides all of them or, for a clock that stands still
 * between two updates, the length of its recent standstills.
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

  /** Whether there are eight different times. By chance, all of them would be whole ms once in 10³² cases. */
  get isKnown(): boolean {
    return this.#distinct >= ENOUGH;
  }

  /** Whether the clock has shown the newest time for more than a second. */
  get isStopped(): boolean {
    return this.#standing > STOPPED;
  }

  /** The resolution, ns; zero while unknown. */
  get value(): Nanoseconds {
    if (!this.isKnown) return 0n;
    const now = this.isStopped ? 0n : this.#standing;
    return [this.#stood, this.#stoodBefore, now].reduce(max, this.#step);
  }

  /**
   * @param asked Time of this machine's counter before the reading.
   * @param heard Time of the same counter after the reading.
   */
  observe(time: Nanoseconds, asked: Nanoseconds, heard: Nanoseconds): void {
    const askedBefore = this.#asked;
    this.#asked = asked;
    if (time === this.#last?.time) {
      // Both readings were taken between these two times.
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

  /** @param asked Time before the newest reading with the same value. */
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
   * The observed standstill is shorter than the real one. If the clock is read often enough, its step shows the real length. A length that
   * is too small would be used without tolerance. A stopped clock shows nothing about its resolution.
   */
  #lengthOfStandstill(time: Nanoseconds, heard: Nanoseconds, asked: Nanoseconds): Nanoseconds {
    if (this.#standing <= 0n || this.#last === null || this.isStopped) return 0n;
    if (heard - asked > this.#standing) return this.#standing;
    const longest = min(heard - (this.#before ?? this.#last.heard), STOPPED);
    return max(this.#standing, min(time - this.#last.time, longest));
  }
}

const min = (a: Nanoseconds, b: Nanoseconds): Nanoseconds => (a < b ? a : b);
const max = (a: Nanoseconds, b: Nanoseconds): Nanoseconds => (a > b ? a : b);

import type { Nanoseconds } from '../times';

/**
 * Maximum number of readings at the same time during a resolution measurement. Without waiting for the response to the previous request, the clock
 * is read often enough to show a step that is shorter than the duration of a reading.
 */
export const READINGS_AT_ONCE = 16;

/**
 * Conditions for the end of a measurement: at least MIN_READINGS readings and CHANGES changes of the time, and a known resolution. If consecutive readings
 * have equal times, the step must be known too, or there must be MAX_READINGS readings. Between two changes lies a complete standstill.
 */
const MIN_READINGS = 16;
const MAX_READINGS = 64;
const CHANGES = 2;

/** Minimum number of gaps that are all multiples of the shortest one for this one to be the step. Those of a clock with small steps are not. */
const MIN_EQUAL = 12;

/** Pause before two readings. The longer pause is for steps of more than 16 ms, which the first MAX_READINGS readings do not show. */
const PAUSE_MS = 1;
const LONG_PAUSE_MS = 10;

/** Measures the step of a clock that stands still between two updates, from readings in quick succession, in the order of their arrival. */
export class ClockStep {
  #last: { time: Nanoseconds; asked: Nanoseconds; heard: Nanoseconds } | null = null;
  #readings = 0;
  /** Differences between consecutive readings with different times. */
  readonly #gaps: Nanoseconds[] = [];
  /** Time between the requests, and between the arrivals, of consecutive readings with equal times. */
  #askedApart: Nanoseconds = 0n;
  #heardApart: Nanoseconds = 0n;

  /**
   * @param isDense Whether the readings do not wait for each other. If they do, equal gaps may be the time that each reading waits: a PLC sends the first
   * notification at the start of its next cycle.
   */
  constructor(readonly isDense: boolean) {}

  /**
   * Adds a reading.
   * @param asked Time on this machine's counter before the reading.
   * @param heard Time on the same counter after the reading.
   */
  observe(time: Nanoseconds, asked: Nanoseconds, heard: Nanoseconds): void {
    this.#readings++;
    if (this.#last !== null && time !== this.#last.time) this.#gaps.push(time > this.#last.time ? time - this.#last.time : this.#last.time - time);
    else if (this.#last !== null) {
      this.#askedApart += asked - this.#last.asked;
      this.#heardApart += heard - this.#last.heard;
    }
    this.#last = { time, asked, heard };
  }

  /** Records that a reading has failed. The difference between the readings before and after it is not used, because it may be many steps. */
  interrupt(): void {
    this.#last = null;
  }

  /** Pause before the next two readings, ms. */
  get pauseMs(): number {
    return this.#readings < MAX_READINGS ? PAUSE_MS : LONG_PAUSE_MS;
  }

  /** @param isKnown Whether the resolution is known apart from standstills. */
  isMeasured(isKnown: boolean): boolean {
    if (this.#readings < MIN_READINGS || this.#gaps.length < CHANGES) return false;
    if (this.#readings >= MAX_READINGS) return isKnown || this.step > 0n;
    const isClear = this.step > 0n || this.#gaps.length === this.#readings - 1 || !this.isDense;
    return isKnown && isClear;
  }

  /** The step; zero if it is not known. */
  get step(): Nanoseconds {
    if (this.#gaps.length === 0 || this.#areInGroups || !this.#areMultiples(6n)) return 0n;
    const { shortest } = this;
    const all = this.#gaps.reduce((sum, gap) => sum + gap, 0n);
    // If more than one pair on average has read each time, the shortest gap is a single step. The other single steps are shorter than 1.5 of it: a
    // clock with steps of 15.625 ms that shows whole milliseconds has steps of 15 and 16 ms.
    if (BigInt(this.#readings) * shortest > 2n * all)
      return this.#gaps.filter(gap => 2n * gap < 3n * shortest).reduce((max, gap) => (gap > max ? gap : max), 0n);
    // Slower readings also show a step if all steps are equal. Equal gaps may be the time between two readings.
    const areEqual = this.isDense && this.#gaps.length >= MIN_EQUAL && this.#areMultiples(shortest) && this.#gaps.some(gap => gap > shortest);
    return areEqual ? shortest : 0n;
  }

  /**
   * Whether the server answers requests in groups, for example once in each cycle of a PLC: their times are equal although its clock advances, but the
   * responses arrive together. Those of a clock that stands still are as far apart as the requests.
   */
  get #areInGroups(): boolean {
    return this.isDense && 2n * this.#heardApart < this.#askedApart;
  }

  /** Whether each gap differs from a multiple of the shortest one by at most this part of it. */
  #areMultiples(part: Nanoseconds): boolean {
    const { shortest } = this;
    return this.#gaps.every(gap => {
      const rest = gap % shortest;
      return (rest < shortest - rest ? rest : shortest - rest) * part < shortest;
    });
  }

  /** The shortest gap, which is at least the step, even if the readings were too slow to show a standstill; zero before the first change. */
  get shortest(): Nanoseconds {
    return this.#gaps.reduce((min, gap) => (gap < min ? gap : min), this.#gaps[0] ?? 0n);
  }
}

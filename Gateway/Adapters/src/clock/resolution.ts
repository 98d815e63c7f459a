import { max, min, type Nanoseconds, NS_PER_S } from '../times';
import type { ClockStep } from './clockStep';

const STEPS: Nanoseconds[] = [1_000_000_000n, 100_000_000n, 10_000_000n, 1_000_000n, 100_000n, 10_000n, 1_000n, 100n, 1n];
const ENOUGH = 8;
const REMEMBERED = 32;

/** Maximum duration of a standstill. A clock that shows the same time for longer has stopped, for example in a paused simulation. */
const STOPPED: Nanoseconds = NS_PER_S;

/** The length of a standstill is taken into account for one to two of these periods. */
const PERIOD: Nanoseconds = 30n * NS_PER_S;

/**
 * Determines the resolution of a clock from its times: the largest power of ten, in ns, that divides all times, or the measured step or the length
 * of the recent standstills if the clock stands still between two updates.
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
  #measured: Nanoseconds = 0n;
  #shortest: Nanoseconds = 0n;

  /** Whether eight different times are known. For a resolution of 100 ns, all eight are whole milliseconds with a probability of 10⁻³². */
  get isKnown(): boolean {
    return this.#distinct >= ENOUGH;
  }

  /** Whether the clock has shown the newest time for more than a second. */
  get isStopped(): boolean {
    return this.#standing > STOPPED;
  }

  /** The resolution, ns; zero while unknown. */
  get value(): Nanoseconds {
    return this.isKnown && !this.isStopped ? max(this.observed, this.#standing) : this.observed;
  }

  /** The resolution without the present standstill, which may be a pause, ns; zero while unknown. */
  get observed(): Nanoseconds {
    return this.isKnown ? max(this.#step, this.#stood, this.#stoodBefore, this.#measured) : this.#measured;
  }

  /** Maximum resolution that the newest measurement did not exclude minus the resolution, ns. */
  get hidden(): Nanoseconds {
    return max(this.#shortest - this.observed, 0n);
  }

  /**
   * Takes the result of a measurement, which replaces that of the previous one. If the readings did not wait for each other, their gaps show how large a
   * step can be that they do not show.
   */
  measured(step: ClockStep): void {
    this.#measured = step.step;
    this.#shortest = step.isDense && step.step === 0n ? step.shortest : 0n;
  }

  /**
   * Adds a reading.
   * @param asked Time on this machine's counter before the reading.
   * @param heard Time on the same counter after the reading.
   */
  observe(time: Nanoseconds, asked: Nanoseconds, heard: Nanoseconds): void {
    const askedBefore = this.#asked;
    this.#asked = asked;
    if (time === this.#last?.time) {
      // The clock has stood still at least from the end of the first reading of this time to the start of the newest one.
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

  /**
   * Records the end of a standstill.
   * @param asked Counter before the last reading during the standstill.
   */
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
   * Gets the length of the standstill that ends now. The observed length is shorter than the actual one. If the clock is read often enough, the step
   * of its time shows the actual length, up to the longest possible one. Returns 0 for a stopped clock, which does not show its resolution.
   */
  #lengthOfStandstill(time: Nanoseconds, heard: Nanoseconds, asked: Nanoseconds): Nanoseconds {
    if (this.#standing <= 0n || this.#last === null || this.isStopped) return 0n;
    if (heard - asked > this.#standing) return this.#standing;
    const longest = min(heard - (this.#before ?? this.#last.heard), STOPPED);
    return max(this.#standing, min(time - this.#last.time, longest));
  }
}

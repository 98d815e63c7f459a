import type { Nanoseconds } from '../times';
import type { PlcNumber } from './decoding';

/** Number of cycles whose values may wait for the cycle's time, in addition to the cycles within two maximum delays. */
const MORE_WAITING = 16;

/** Maximum number of stored times. It covers the longest delay, 10 s, for a task with a cycle of 5 ms. */
const MAX_TIMES = 2048;

/** A value read from the PLC, with its index in the configuration. */
export interface CycleValue {
  index: number;
  value: PlcNumber;
  /** Whether this is the first value of a subscription. Its stamp may be old. */
  isFirst?: boolean;
}

/**
 * Assigns to each PLC value the time that the time variable had in the same cycle. Values with equal stamps belong to the same cycle.
 */
export class Cycles {
  readonly #waiting = new Map<bigint, CycleValue[]>();
  readonly #times = new Map<bigint, Nanoseconds | null>();

  /**
   * @param perDelay Number of cycles that are sampled within one maximum delay.
   * @param take Receives the time and the values of a cycle. The time is null if the variable had no valid time.
   * @param drop Receives the values of a cycle for which no time arrived.
   */
  constructor(
    readonly perDelay: number,
    readonly take: (time: Nanoseconds | null, values: CycleValue[]) => void,
    readonly drop: (values: CycleValue[]) => void,
  ) {}

  /** Adds the values of one cycle that one frame contains. `time` is undefined if the frame does not contain the time. */
  add(stamp: bigint, values: CycleValue[], time: Nanoseconds | null | undefined): void {
    if (time !== undefined) remember(this.#times, stamp, time, MAX_TIMES);
    const all = [...(this.#waiting.get(stamp) ?? []), ...values];
    if (all.length === 0) return;
    const known = this.#times.get(stamp);
    if (known !== undefined) {
      this.#waiting.delete(stamp);
      this.take(known, all);
    } else {
      this.drop(remember(this.#waiting, stamp, all, 2 * this.perDelay + MORE_WAITING) ?? []);
    }
  }
}

/** Adds an entry to a map with a maximum size. Beyond this size, removes the oldest entry and returns its value. */
function remember<T>(map: Map<bigint, T>, stamp: bigint, value: T, most: number): T | undefined {
  map.set(stamp, value);
  if (map.size <= most) return undefined;
  const [[oldest, gone]] = map;
  map.delete(oldest);
  return gone;
}

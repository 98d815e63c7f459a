import type { Nanoseconds } from '../times';

/**
 * Maximum number of cycles whose values wait for their time, beyond the cycles of one maximum delay. A PLC sends values and time within
 * that delay.
 */
const MORE_WAITING = 16;

/** Maximum number of stored times: those of 10 s, the longest delay, for a task of 5 ms. */
const MAX_TIMES = 2048;

/** The index of a value in the configuration, and the value in the PLC. */
export interface CycleValue {
  index: number;
  value: number;
}

/**
 * Assigns times to a PLC's values. The time comes from a variable of the same cycle: equal stamps mean the same cycle.
 */
export class Cycles {
  readonly #waiting = new Map<bigint, CycleValue[]>();
  readonly #times = new Map<bigint, Nanoseconds | null>();

  /**
   * @param perDelay Number of cycles sampled within a maximum delay.
   * @param take Receives the values of a cycle and its time; null if the variable had none.
   * @param drop Receives the values that never got a time.
   */
  constructor(
    readonly perDelay: number,
    readonly take: (time: Nanoseconds | null, values: CycleValue[]) => void,
    readonly drop: (values: CycleValue[]) => void,
  ) {}

  /** Adds the part of one cycle in a frame. `time` is undefined if the frame does not contain it.  */
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

/** Adds an entry; returns the oldest one if it was removed for it. */
function remember<T>(map: Map<bigint, T>, stamp: bigint, value: T, most: number): T | undefined {
  map.set(stamp, value);
  if (map.size <= most) return undefined;
  const [[oldest, gone]] = map;
  map.delete(oldest);
  return gone;
}

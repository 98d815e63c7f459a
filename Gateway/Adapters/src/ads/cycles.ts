import type { Nanoseconds } from '../times';

/** Cycles whose values wait for their time, beside those of a maximum delay, within which a PLC sends both. */
const MORE_WAITING = 16;

/** Cycles whose time is known: those of 10 s, the longest delay, of a task of 5 ms. */
const MOST_TIMES = 2048;

/** A joint's place in the configuration, and its value as the PLC has it. */
export interface CycleValue {
  joint: number;
  value: number;
}

/**
 * Gives a PLC's values the time that a variable of it told in the same cycle: what bears the same stamp was sampled in the same cycle.
 */
export class Cycles {
  readonly #waiting = new Map<bigint, CycleValue[]>();
  readonly #times = new Map<bigint, Nanoseconds | null>();

  /**
   * @param perDelay Cycles that are sampled within a maximum delay.
   * @param take Gets the values of a cycle and its time; null where the variable held none.
   * @param drop Gets the values that never met their time.
   */
  constructor(
    readonly perDelay: number, readonly take: (time: Nanoseconds | null, values: CycleValue[]) => void,
    readonly drop: (values: CycleValue[]) => void,
  ) {}

  /** What a frame brings of one cycle; `time` is undefined where the frame does not have it. */
  add(stamp: bigint, values: CycleValue[], time: Nanoseconds | null | undefined): void {
    if (time !== undefined) remember(this.#times, stamp, time, MOST_TIMES);
    const all = [...this.#waiting.get(stamp) ?? [], ...values];
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

/** Keeps the newest; returns what had to go for it. */
function remember<T>(map: Map<bigint, T>, stamp: bigint, value: T, most: number): T | undefined {
  map.set(stamp, value);
  if (map.size <= most) return undefined;
  const [[oldest, gone]] = map;
  map.delete(oldest);
  return gone;
}

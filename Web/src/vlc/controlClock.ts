/** Four timestamps: t1 and t4 on this page's clock, ms; t2 and t3 on the control clock, ns. */
export interface Exchange {
  t1: number;
  t2: bigint;
  t3: bigint;
  t4: number;
  /** The step in which the control clock advances, ns; it shows the beginning of the step. */
  resolutionNs: number;
}

/** What the control clock shows, and how wrong that may be, ms. */
export interface Reading {
  ns: bigint;
  boundMs: number;
}

const WINDOW_MS = 10_000;

/** Fewer exchanges tell nothing. */
export const LEAST_EXCHANGES = 8;

/** No two clocks run more differently: as in the protocol. */
const GREATEST_SKEW = 500e-6;

const NS_PER_MS = 1e6;

/**
 * The control clock as this page knows it. Each exchange says between which two values the offset lies; what all of the last ten seconds
 * agree on is what is known, so it is the exchanges with the shortest round trips that decide.
 */
export class ControlClock {
  private exchanges: { at: number; low: number; high: number }[] = [];
  private base = 0n;

  /** @param grainMs Steps in which t1 and t4 advance: they may be wrong by as much. */
  constructor(private readonly grainMs: number) {}

  get count(): number {
    return this.exchanges.length;
  }

  /** @returns Whether the clock stepped, so that what was known before is forgotten. */
  add({ t1, t2, t3, t4, resolutionNs }: Exchange): boolean {
    if (this.count === 0) this.base = t2;
    const received = Number(t2 - this.base) / NS_PER_MS, sent = Number(t3 - this.base) / NS_PER_MS, step = resolutionNs / NS_PER_MS;
    if (sent < received || sent - received > t4 - t1 + step + 2 * this.grainMs) return false;
    this.exchanges.push({ at: t4, low: sent - t4 - this.grainMs, high: received + step - t1 + this.grainMs });
    this.exchanges = this.exchanges.filter(e => e.at > t4 - WINDOW_MS);
    const { low, high } = this.limits(t4);
    if (low <= high) return false;
    this.forget();
    return true;
  }

  forget(): void {
    this.exchanges = [];
  }

  /** Since the newest exchange, ms. */
  age(now: number): number {
    return this.count === 0 ? Infinity : now - this.exchanges[this.count - 1].at;
  }

  /** Null before the first exchange. */
  at(now: number): Reading | null {
    if (this.count === 0) return null;
    const { low, high } = this.limits(now);
    return { ns: this.base + BigInt(Math.round((now + (low + high) / 2) * NS_PER_MS)), boundMs: (high - low) / 2 };
  }

  private limits(now: number): { low: number; high: number } {
    let low = -Infinity, high = Infinity;
    for (const e of this.exchanges) {
      const drift = GREATEST_SKEW * Math.max(0, now - e.at);
      low = Math.max(low, e.low - drift);
      high = Math.min(high, e.high + drift);
    }
    return { low, high };
  }
}

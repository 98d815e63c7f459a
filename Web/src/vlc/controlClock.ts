/** Four time stamps: t1 and t4 on this page's clock, ms; t2 and t3 on the control clock, ns. */
interface Exchange {
  t1: number;
  t2: bigint;
  t3: bigint;
  t4: number;
  /** Resolution of the control clock, ns. A reading is the start of the current step. */
  resolutionNs: number;
}

/** Control time in ns, and its error bound in ms. */
interface Reading {
  ns: bigint;
  boundMs: number;
}

const WINDOW_MS = 10_000;

/** Minimum number of exchanges for an estimate. */
export const MIN_EXCHANGES = 8;

/** Maximum skew between the two clocks. It is less than the 700 ppm that headsets assume. */
const MAX_SKEW = 500e-6;

const NS_PER_MS = 1e6;

/**
 * Estimates the control time. Each exchange gives a lower and an upper bound of the offset. The estimate is the middle of the intersection
 * of the bounds over the last ten seconds. The exchanges with the shortest round-trip times determine this intersection.
 */
export class ControlClock {
  private exchanges: { at: number; low: number; high: number }[] = [];
  private base = 0n;

  /** @param grainMs Resolution of t1 and t4, ms. It is also their maximum error. */
  constructor(private readonly grainMs: number) {}

  get count(): number {
    return this.exchanges.length;
  }

  /** @returns Whether the clock stepped and earlier exchanges were therefore discarded. */
  add({ t1, t2, t3, t4, resolutionNs }: Exchange): boolean {
    if (this.count === 0) this.base = t2;
    const received = Number(t2 - this.base) / NS_PER_MS;
    const sent = Number(t3 - this.base) / NS_PER_MS;
    const step = resolutionNs / NS_PER_MS;
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

  /** Time since the newest exchange, ms. */
  age(now: number): number {
    return this.count === 0 ? Infinity : now - this.exchanges[this.count - 1].at;
  }

  /** Returns the control time; null before the first exchange. */
  at(now: number): Reading | null {
    if (this.count === 0) return null;
    const { low, high } = this.limits(now);
    return { ns: this.base + BigInt(Math.round((now + (low + high) / 2) * NS_PER_MS)), boundMs: (high - low) / 2 };
  }

  private limits(now: number): { low: number; high: number } {
    let low = -Infinity;
    let high = Infinity;
    for (const e of this.exchanges) {
      const change = MAX_SKEW * Math.max(0, now - e.at);
      low = Math.max(low, e.low - change);
      high = Math.min(high, e.high + change);
    }
    return { low, high };
  }
}

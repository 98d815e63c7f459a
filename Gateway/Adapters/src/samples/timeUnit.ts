import { type Nanoseconds, NS_PER_MS, NS_PER_S, ofFileTime } from '../times';

/** Units of a number that represents a point in time. The epoch is 1601 for filetime, 2000 for dctime (EtherCAT), and 1970 for the others. */
export type TimeUnit = 'ns' | 'us' | 'ms' | 's' | 'filetime' | 'dctime';

const DCTIME_ZERO: Nanoseconds = 946_684_800n * NS_PER_S;

const NS_OF: Record<TimeUnit, bigint> = { ns: 1n, us: 1000n, ms: NS_PER_MS, s: NS_PER_S, filetime: 100n, dctime: 1n };

export function ofCount(count: bigint, unit: TimeUnit): Nanoseconds {
  switch (unit) {
    case 'filetime':
      return ofFileTime(count);
    case 'dctime':
      return DCTIME_ZERO + count;
    default:
      return count * NS_OF[unit];
  }
}

/** Converts a number with a fraction to a time. Converts whole units and fraction separately to avoid an additional rounding error. */
export function ofFraction(value: number, unit: TimeUnit): Nanoseconds {
  const count = Math.floor(value);
  const rest = value - count;
  return ofCount(BigInt(count), unit) + BigInt(Math.round(rest * Number(NS_OF[unit])));
}

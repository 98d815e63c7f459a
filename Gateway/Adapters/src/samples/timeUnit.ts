import { type Nanoseconds, NS_PER_MS, NS_PER_S, ofFileTime } from '../times';

/** Units of a number that is a point in time, with their epochs: 1970, 1601 (filetime), 2000 (dctime, EtherCAT's clocks). */
export const TIME_UNITS = ['ns', 'us', 'ms', 's', 'filetime', 'dctime'] as const;
export type TimeUnit = (typeof TIME_UNITS)[number];

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

/** Converts whole units and the fraction separately, to avoid another rounding of the product. */
export function ofFraction(value: number, unit: TimeUnit): Nanoseconds {
  const count = Math.floor(value);
  const rest = value - count;
  return ofCount(BigInt(count), unit) + BigInt(Math.round(rest * Number(NS_OF[unit])));
}

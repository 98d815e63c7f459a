/** Points in time are nanoseconds since 1970 as bigint: a double of today's date is a quarter of a microsecond coarse. */
export type Nanoseconds = bigint;

export interface RosTime {
  sec: number;
  nanosec: number;
}

export const NS_PER_MS = 1_000_000n;
export const NS_PER_S = 1_000_000_000n;

/** 1601-01-01 of OPC UA's DateTime and Windows' FILETIME, in their 100 ns before 1970. */
const FILETIME_OF_1970 = 116_444_736_000_000_000n;

/** Both spellings, ROS 1's secs and nsecs too; null where it is no time. */
export function ofRosTime(time: unknown): Nanoseconds | null {
  const { sec, nanosec, secs, nsecs } = (time ?? {}) as Record<string, unknown>;
  const [s, ns] = [sec ?? secs, nanosec ?? nsecs];
  return Number.isSafeInteger(s) && Number.isSafeInteger(ns) ? BigInt(s as number) * NS_PER_S + BigInt(ns as number) : null;
}

export const toRosTime = (time: Nanoseconds): RosTime => ({ sec: Number(time / NS_PER_S), nanosec: Number(time % NS_PER_S) });

/** From 100 ns since 1601. */
export const ofFileTime = (ticks: bigint): Nanoseconds => (ticks - FILETIME_OF_1970) * 100n;

export const ofMilliseconds = (ms: number): Nanoseconds => BigInt(Math.round(ms * 1e6));

export const toMilliseconds = (ns: Nanoseconds): number => Number(ns) / 1e6;

/** What this machine's own clock says; for labels only, never for t_k. */
export const machineTime = (): Nanoseconds => BigInt(Date.now()) * NS_PER_MS;

/** Nanoseconds of a counter that never jumps; its zero means nothing. */
export const monotonicTime = (): Nanoseconds => process.hrtime.bigint();

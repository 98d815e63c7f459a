/**
 * A point in time in nanoseconds since 1970, or a length in nanoseconds. A bigint, because a double has a resolution of 0.25 µs for current
 * dates.
 */
export type Nanoseconds = bigint;

interface RosTime {
  sec: number;
  nanosec: number;
}

export const NS_PER_MS = 1_000_000n;
export const NS_PER_S = 1_000_000_000n;

export const min = (...times: Nanoseconds[]): Nanoseconds => times.reduce((least, each) => (each < least ? each : least));
export const max = (...times: Nanoseconds[]): Nanoseconds => times.reduce((most, each) => (each > most ? each : most));

/** 1970-01-01 in units of 100 ns since 1601-01-01, as used by OPC UA's DateTime and Windows' FILETIME. */
const FILETIME_OF_1970 = 116_444_736_000_000_000n;

/** Converts a ROS time with the field names of ROS 1 or ROS 2; null if the time is invalid. */
export function ofRosTime(time: unknown): Nanoseconds | null {
  const { sec, nanosec, secs, nsecs } = (time ?? {}) as Record<string, unknown>;
  const [s, ns] = [sec ?? secs, nanosec ?? nsecs];
  return Number.isSafeInteger(s) && Number.isSafeInteger(ns) ? BigInt(s as number) * NS_PER_S + BigInt(ns as number) : null;
}

/** Whether a time has the field names of ROS 1. */
export const isTimeOfRos1 = (time: unknown): boolean => (time as { secs?: unknown } | null | undefined)?.secs !== undefined;

export const toRosTime = (time: Nanoseconds): RosTime => ({ sec: Number(time / NS_PER_S), nanosec: Number(time % NS_PER_S) });

/** Converts a time in units of 100 ns since 1601. */
export const ofFileTime = (ticks: bigint): Nanoseconds => (ticks - FILETIME_OF_1970) * 100n;

export const ofMilliseconds = (ms: number): Nanoseconds => BigInt(Math.round(ms * 1e6));

export const toMilliseconds = (ns: Nanoseconds): number => Number(ns) / 1e6;

/** Gets the Unix time of this machine in ms when the process started, plus the time since then. Steps of the machine's clock do not change it. */
export const unixTimeMs = (): number => performance.timeOrigin + performance.now();

/** Gets a monotonic time in ns with an arbitrary epoch. */
export const monotonicTime = (): Nanoseconds => process.hrtime.bigint();

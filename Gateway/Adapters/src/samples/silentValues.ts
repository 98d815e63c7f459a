/**
 * The rules for values without notifications, which an adapter reads to distinguish a value at rest from one that no longer exists. They apply to all
 * control systems that send notifications of changes.
 */

/** Minimum time without a notification after which a value is read. */
export const SILENT_MS = 60;

/** Maximum time from the stamp of a change until a read request returns the new value, in addition to the sampling interval. */
export const STAMP_LAG_MS = 50;

/** Assumed maximum delay of a notification in addition to the sampling and publishing intervals. */
const SLACK_MS = 100;

/** Minimum time without a confirmation after which a value at rest has a fault. Values at rest are confirmed several times per second. */
const UNCONFIRMED_MS = 1500;

/** A value counts as late after the longer of LATE_MS and DELAYS times the maximum delay of its notifications. */
const LATE_MS = 400;
const DELAYS = 2;

/** The intervals at which a source samples and sends values, ms. */
interface Intervals {
  samplingMs: number;
  publishingMs: number;
}

/** Gets the maximum delay of a notification, ms. */
export const delayOf = ({ samplingMs, publishingMs }: Intervals): number => SLACK_MS + samplingMs + publishingMs;

/** Gets the time in ms without a notification after which a value is read. A value that changes causes a notification within the two intervals. */
export const silentAfterMs = ({ samplingMs, publishingMs }: Intervals): number => Math.max(SILENT_MS, samplingMs + publishingMs);

/** Gets the time in ms without a confirmation after which a value has a fault. Long delays increase it. */
export const unconfirmedAfterMs = (delayMs: number): number => Math.max(UNCONFIRMED_MS, UNCONFIRMED_MS / 2 + 3 * delayMs);

/** Gets the time in ms after which an expected notification counts as late. */
export const lateAfterMs = (delayMs: number): number => Math.max(LATE_MS, DELAYS * delayMs);

/**
 * Whether the source is assumed to send no notifications of a value, because reads have returned values without their notifications for too long.
 * @param since Time of the first of these reads, ms; null if the last read is not one of them.
 */
export const isUnnotified = (since: number | null, now: number, delayMs: number): boolean => since !== null && now - since >= lateAfterMs(delayMs);

import { pause } from '../backoff';

/** Time after a connection within which the description of a robot and a pose of each frame are expected, ms. */
export const EXPECTED_MS = 10_000;

const FIRST_MS = 5000;
const MAX_MS = 300_000;

/**
 * Calls `renew` after 5, 10, 20, 40 s and so on, at intervals of at most 300 s, until the signal is aborted. The intervals grow, because each ended
 * subscription may stop a rosbridge of ROS 2 of before April 2026, and because most topics without a message never have one.
 * @param renew Called with the time since the start, ms.
 */
export async function renewing(ended: AbortSignal, renew: (ms: number) => void, wait = pause): Promise<void> {
  for (let ms = FIRST_MS, waitMs = FIRST_MS; ; ms += waitMs) {
    await wait(waitMs, ended);
    if (ended.aborted) return;
    renew(ms);
    waitMs = Math.min(ms, MAX_MS);
  }
}

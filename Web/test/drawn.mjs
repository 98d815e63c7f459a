import { setTimeout } from 'node:timers/promises';

const LIMIT_MS = 20_000;

/** Interval between two looks. Without it, the looks would take a whole core, and the page would be drawn even later. */
const PAUSE_MS = 50;

/** Takes screenshots until one meets a condition, because slow machines draw late. If none does, returns the last one. */
export async function drawn(look, isExpected) {
  for (const end = performance.now() + LIMIT_MS; ; await setTimeout(PAUSE_MS)) {
    const seen = await look();
    if (isExpected(seen) || performance.now() > end) return seen;
  }
}

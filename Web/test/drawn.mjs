const LIMIT_MS = 20_000;

/** Takes screenshots until one meets a condition, because slow machines draw late. If none does, returns the last one. */
export async function drawn(look, isExpected) {
  for (const end = performance.now() + LIMIT_MS; ;) {
    const seen = await look();
    if (isExpected(seen) || performance.now() > end) return seen;
  }
}

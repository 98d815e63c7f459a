const LIMIT_MS = 20_000;

/** Takes pictures until one is as expected, because slow machines draw late. Returns the last one if none is. */
export async function drawn(look, isExpected) {
  for (const end = performance.now() + LIMIT_MS; ;) {
    const seen = await look();
    if (isExpected(seen) || performance.now() > end) return seen;
  }
}

const LIMIT_MS = 20_000;

/** Takes pictures of a page until one is as expected, because a slow machine draws late. Returns the last picture if none is. */
export async function drawn(look, isExpected) {
  for (const end = performance.now() + LIMIT_MS; ;) {
    const seen = await look();
    if (isExpected(seen) || performance.now() > end) return seen;
  }
}

const STEPS = 5;

/** Lower limit of the returned resolution, ms. Browsers do not document a finer resolution. */
const MIN_MS = 0.1;

/**
 * Measures the resolution of the page's clock, ms. Browsers reduce it to prevent timing attacks: to 1 ms or more if the page was loaded over
 * HTTP from another machine.
 * @param now The clock. It is read until it has advanced a few times.
 */
export function grainOf(now: () => number): number {
  let shortest = Infinity;
  for (let step = 0; step < STEPS; step++) {
    const begin = now();
    let end = begin;
    while (end === begin) end = now();
    // If the page is interrupted, the clock advances by several steps at once, so the shortest step is used.
    shortest = Math.min(shortest, end - begin);
  }
  return Math.max(shortest, MIN_MS);
}

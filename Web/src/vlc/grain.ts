const STEPS = 5;

/** Resolution of the finest clocks, ms. Browsers do not document it more precisely. */
const MIN_MS = 0.1;

/**
 * Measures the resolution of a page's clock, ms. Browsers coarsen clocks against timing attacks: to 1 ms and more if the page was loaded
 * over plain http from another machine.
 * @param now The clock. It is read until it has advanced a few times.
 */
export function grainOf(now: () => number): number {
  let shortest = Infinity;
  for (let step = 0; step < STEPS; step++) {
    const begin = now();
    let end = begin;
    while (end === begin) end = now();
    // An interrupted page sees several steps at once.
    shortest = Math.min(shortest, end - begin);
  }
  return Math.max(shortest, MIN_MS);
}

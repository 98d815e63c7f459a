const STEPS = 5;

/** Step of the finest clocks, ms; no browser documents it more exactly. */
const LEAST_MS = 0.1;

/**
 * The steps in which a page's clock advances, ms. Browsers coarsen it against pages that measure others: to 1 ms and more where the page
 * was loaded over plain http from another machine.
 * @param now The clock. It is asked until it has advanced a few times.
 */
export function grainOf(now: () => number): number {
  let least = Infinity;
  for (let step = 0; step < STEPS; step++) {
    const begin = now();
    let end = begin;
    while (end === begin) end = now();
    // A page that is interrupted here sees several steps at once.
    least = Math.min(least, end - begin);
  }
  return Math.max(least, LEAST_MS);
}

// Tests the statistics and the search of the pages.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { buildSync } from 'esbuild';

const source = fileURLToPath(new URL('../src/numbers.ts', import.meta.url));
const { outputFiles } = buildSync({ entryPoints: [source], bundle: true, write: false, format: 'esm' });
const { lastUpTo, quantile, statistics } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

describe('quantile', () => {
  // The command line computes the same numbers (R7).
  for (const [share, expected] of [[0, 1], [0.5, 3.5], [0.9, 8.5], [0.95, 9.25], [1, 10]])
    it(`${share} of 1, 2, 5 and 10 is ${expected}`, () => assert.equal(Number(quantile([10, 1, 5, 2], share).toFixed(9)), expected));

  it('of one value is the value', () => assert.equal(quantile([7], 0.95), 7));

  it('without values is not a number', () => assert.ok(Number.isNaN(quantile([], 0.95))));
});

describe('statistics', () => {
  it('use the absolute values for the percentile', () => assert.equal(Number(statistics([-10, 1, null, 5, -2, NaN]).p95.toFixed(9)), 9.25));
});

describe('the search in ascending numbers', () => {
  it('finds the last number up to a limit, as a search from the end does', () => {
    for (const numbers of [[], [3], [1, 2], [0, 0, 1, 4, 4, 4, 9]])
      for (let limit = -1; limit <= 10; limit += 0.5)
        assert.equal(lastUpTo(numbers, limit), numbers.findLastIndex(number => number <= limit), `${limit} in ${numbers}`);
  });
});

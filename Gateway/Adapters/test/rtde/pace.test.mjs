// Tests the estimate of a controller's rate.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';

const { Pace } = await parts('rtde/pace');

describe('pace', () => {
  for (const [name, hz, expected] of [['ExactlyHalf', 62.5, false], ['AThird', 125 / 3, true]])
    it(`IsBelowHalfOf_${name}OfTheRequestedRate_Is${expected ? 'True' : 'False'}`, () => {
      const pace = new Pace();

      for (let i = 0; i < 40; i++) pace.lostBefore(1000 + i / hz);

      assert.equal(pace.isBelowHalfOf(125), expected);
    });
});

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { unused, unusedExports } from './exports.mjs';

describe('exports', () => {
  it('are unused if no other file contains their name', () =>
    assert.deepEqual(unusedExports({
      'a.ts': 'export const used = 1;\nexport function own() { return own; }\nexport interface Shape { own: number }\nconst local = 2;',
      'b.ts': "import { used } from './a';\nexport class Tested {}",
      'b.test.mjs': 'const { Tested } = parts;',
    }), ['a.ts: own', 'a.ts: Shape']));

  it('of the products all have a user', () => assert.deepEqual(unused(), []));
});

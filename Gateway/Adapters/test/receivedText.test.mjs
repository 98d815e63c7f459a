// Tests how a text from a rosbridge or gateway is read.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';

const { parsed } = await parts('gateway/messages');

describe('a received text', () => {
  it('may contain numbers that are not finite, but not in its strings', () =>
    assert.deepEqual(parsed('{"a":NaN,"b":"NaN \\" -Infinity","c":[-Infinity,1]}'), { a: null, b: 'NaN " -Infinity', c: [null, 1] }));

  // With a search that starts again at each quotation mark, this text takes an hour.
  it('of the maximum length without the end of its string is refused at once', () => assert.equal(parsed(`{"a":"${'\\"'.repeat(1e6)}`), null));
});

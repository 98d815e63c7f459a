// Tests when tests that need a program are skipped.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { skipWithout } from './required.mjs';

describe('tests that need a program', () => {
  it('run if it exists', () => {
    for (const environment of [{}, { NOWPOSE_CI: 'true' }]) assert.equal(skipWithout(true, 'no program', environment), false);
  });

  it('are skipped with the reason if it does not exist', () => assert.equal(skipWithout(false, 'no program', {}), 'no program'));

  it('fail in CI if it does not exist', () => assert.throws(() => skipWithout(false, 'no program', { NOWPOSE_CI: 'true' }), { message: 'no program' }));
});

// Checks the wording of the message catalogue of the picture search.
import assert from 'node:assert/strict';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { faultsIn, textsOf } from '../.ci/lint/wording.mjs';

const catalogue = join(dirname(fileURLToPath(import.meta.url)), 'src', 'messages.ts');
const { outputFiles } = await build({ entryPoints: [catalogue], bundle: true, format: 'esm', write: false });
const messages = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);

/** A sample for each parameter of the catalogue's functions. */
const samples = { width: 20000, height: 15000, maxMegapixels: 120 };

describe('the message catalogue of the picture search', () => {
  for (const [name, text] of Object.entries(textsOf(messages, samples)))
    it(`has a well-formed text ${name}`, () => assert.deepEqual(faultsIn(text, false), [], text));

  it('states the size of a picture and the maximum', () =>
    assert.match(messages.pictureMessages.tooLarge(20000, 15000, 120), /20000x15000.*120 megapixels: reduce the resolution$/));
});

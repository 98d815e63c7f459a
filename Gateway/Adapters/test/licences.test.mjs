// Checks that the licence file of the bundles contains the licences of all packages in the bundles.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { adapters } from './program.mjs';

const text = readFileSync(join(adapters, 'dist', 'adapter-licences.txt'), 'utf8');

it('Licences_AllPackages_AreListed', () => {
  assert.match(text, /^node-opcua-client [\d.]+, MIT$/m);
  assert.doesNotMatch(text, /, undefined$|no text with it/m);
});

for (const [name, holder] of [['precond', 'Mathieu Turcotte'], ['assert-plus', 'Mark Cavage']])
  it(`Licence_TextMissingInPackage${name}_IsAddedToTheFile`, () => {
    const stated = `The MIT License \\(MIT\\)\\nCopyright .* ${holder}\\s+Permission is hereby granted`;

    assert.match(text, new RegExp(`^${name} [\\d.]+, MIT\\n\\n${stated}`, 'm'));
  });

// Parses the parts of configurations that the manual shows, because users copy them.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { parse } from 'yaml';
import { adapters } from './program.mjs';

const folder = join(adapters, '../../Packages/com.nowpose.mril/Documentation~');

/** Returns the YAML blocks of a page and the mappings within its lines. */
const snippetsOf = page => [
  ...[...page.matchAll(/^```ya?ml\n(.*?)^```/gms)].map(([, block]) => block),
  ...[...page.matchAll(/`(\{ [^`\n]*)`/g)].map(([, mapping]) => mapping),
];

const pages = readdirSync(folder).filter(name => name.endsWith('.md'))
  .map(name => [name, snippetsOf(readFileSync(join(folder, name), 'utf8'))]).filter(([, snippets]) => snippets.length > 0);

it('Manual_PagesAboutPlants_HaveSnippets', () => {
  for (const name of ['objects-from-a-plc.md', 'plant-configuration.md', 'plant-mqtt.md'])
    assert.ok(pages.some(([page, snippets]) => page === name && snippets.length >= 2), name);
});

for (const [name, snippets] of pages)
  it(`Snippets_Of${name}_AreValid`, () => {
    for (const snippet of snippets) assert.doesNotThrow(() => parse(snippet), snippet);
  });

for (const [name, snippets] of pages)
  it(`Snippets_Of${name}_HaveTheUrisOfNamespaces`, () => {
    // The number of a namespace depends on the server's configuration.
    assert.deepEqual(snippets.filter(snippet => /\bns=\d+;/.test(snippet)), []);
  });

it('ObjectsFromAPlc_DeclaredVariables_AreVisibleToOpcUa', () => {
  const [declarations] = readFileSync(join(folder, 'objects-from-a-plc.md'), 'utf8').match(/VAR_GLOBAL.*?END_VAR/s);
  const namesIn = pattern => [...declarations.matchAll(pattern)].map(([, name]) => name);

  // An attribute applies only to the declaration that follows it.
  const visible = namesIn(/'OPC\.UA\.DA' := '1'.*'OPC\.UA\.DA\.Access' := '1'.*\n\s*(\w+) :/g);

  assert.ok(visible.length > 0);
  assert.deepEqual(visible, namesIn(/^\s*(\w+) : /gm));
});

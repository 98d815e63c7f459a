// Compares the explanations of terms on the pages with the definitions in docs/glossary.md.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

const plain = text => text.trim().replaceAll('`', '').replaceAll('’', "'");
const rows = readFileSync(new URL('../../docs/glossary.md', import.meta.url), 'utf8').split('\n').filter(line => line.startsWith('| '))
  .map(line => line.split('|').slice(1, 3).map(plain));

/** Requires that the glossary has the entry and that its definition begins with the meaning. */
export function assertDefined(entry, meaning) {
  const definition = rows.find(([term]) => term === plain(entry))?.[1];
  assert.ok(definition, `docs/glossary.md has no entry “${entry}”`);
  assert.ok(meaning.length > 10 && definition.startsWith(plain(meaning)), `${entry}: “${meaning}” is not the beginning of “${definition}”`);
}

/** Returns the explained terms of a page. Requires that each has its meaning, as in the glossary. */
export async function explainedTerms(page) {
  const terms = await page.locator('abbr').evaluateAll(all => all.map(abbr => [abbr.textContent, abbr.title]));
  for (const [term, title] of terms) {
    const [entry, ...meaning] = title.split(': ');
    assert.ok(entry.toLowerCase().split(', ').includes(term.toLowerCase()), `“${term}” has the meaning of “${entry}”`);
    assertDefined(entry, meaning.join(': '));
  }
  return [...new Set(terms.map(([term]) => term))];
}

// Checks that the manual's pictures are up to date: the pages must have the same text as when the pictures were taken.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { describe, it } from 'node:test';
import { openOperations, path, PICTURES, setState, stored, textsOf } from '../pictures/screens.mjs';
import { FakeGateway } from './fakeGateway.mjs';
import { browserWith, closeLater, opener } from './pages.mjs';

const MAX_WIDTH = 1400, MAX_BYTES = 250_000, WIDTH_OFFSET = 16;
const texts = JSON.parse(readFileSync(path('texts.json'), 'utf8'));
const OUTDATED = 'the page has changed: run `npm run pictures` in Web, look at the pictures and commit them';

describe('a picture of the manual', () => {
  for (const [page, data] of [['report', 'demo'], ['calibration', 'calibration']]) {
    it(`has the texts of the current ${page} page`, async () => {
      assert.deepEqual(await textsOf(await opener(page)(stored(data))), texts[page], OUTDATED);
    });
  }

  it('has the texts of the current operations page', async () => {
    const gateway = await FakeGateway.start();
    try {
      setState(gateway);
      const page = closeLater(await openOperations((await browserWith()).browser, gateway));

      assert.deepEqual(await textsOf(page), texts.operations, OUTDATED);
    } finally {
      await gateway.stop();
    }
  });

  for (const [name, { file, shownBy }] of Object.entries(PICTURES)) {
    it(`is small and used by a page of the manual: ${name}`, () => {
      const picture = readFileSync(path(file));

      assert.ok(picture.length <= MAX_BYTES, `${picture.length} bytes`);
      assert.ok(picture.readUInt32BE(WIDTH_OFFSET) <= MAX_WIDTH, `${picture.readUInt32BE(WIDTH_OFFSET)} px wide`);
      assert.match(readFileSync(path(shownBy), 'utf8'), new RegExp(`!\\[[^\\]]{20,}\\]\\([^)]*${basename(file)}\\)`));
    });
  }
});

const MIN_LETTERS = 12;
const STORED_OUTDATED = 'the command line has changed: run `npm run pictures -- --record` in Web, look at the pictures and commit them';

const PART = String.raw`(?:\$?"(?:[^"\\\n]|\\.)*"|FormattableString\.Invariant\(\$"(?:[^"\\\n]|\\.)*"\)|[A-Z]\w*)`;
const ENTRY = new RegExp(String.raw`(?:const string (\w+)\s*=|static string (\w+)\([^)]*\)\s*=>)\s*(${PART}(?:\s*\+\s*${PART})*);`, 'g');

/** Returns patterns of the texts in a file of the command line's message catalogue: of its constants, and of its methods with any values. */
function patternsOf(source) {
  const patterns = {};
  const escaped = text => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const patternOf = part => {
    const text = /"(.*)"/s.exec(part)?.[1];
    if (text === undefined) return patterns[part] ?? '.+';
    return part.includes('$"') ? text.split(/\{[^}]*\}/).map(escaped).join('.+') : escaped(JSON.parse(`"${text}"`));
  };
  for (const [, constant, method, parts] of source.matchAll(ENTRY))
    patterns[constant ?? method] = parts.match(new RegExp(PART, 'g')).map(patternOf).join('');
  return Object.values(patterns);
}

describe('the stored data of a picture', () => {
  const filesIn = folder => readdirSync(path(folder), { recursive: true }).filter(file => file.endsWith('.cs'))
    .map(file => readFileSync(join(path(folder), file), 'utf8'));
  const sources = folder => filesIn(folder).join('\n').toLowerCase();
  // A pattern with few words, such as that of "NAME is VALUE", matches too many texts.
  const isLong = pattern => pattern.replace(/\P{L}/gu, '').length >= MIN_LETTERS;
  const catalogue = new RegExp(`^(?:${filesIn('../../Cli/Messages').flatMap(patternsOf).filter(isLong).join('|')})$`);

  for (const [name, folder] of [['demo', '../../Cli/Demo'], ['calibration', '../../Cli/Calibrate']]) {
    it(`has labels that the command line still writes: ${name}`, () => {
      const { facts, settings = [], subtitle = '', sections = [] } = stored(name), source = sources(folder) + sources('../../Cli/Messages');
      const labels = [...facts, ...settings].map(([label]) => label.replace(/^– .*/, '')).concat(subtitle, sections.map(each => each.heading));

      const unknown = labels.filter(label => !source.includes(label.toLowerCase()));

      assert.deepEqual(unknown, [], STORED_OUTDATED);
    });
  }

  it('has sentences and reasons of rejected pictures that the command line still writes', () => {
    const { facts, result, warnings, sections } = stored('calibration');
    const reasons = facts.map(([label]) => label).filter(label => label.startsWith('– '));
    // The reason follows the code to which it applies.
    const texts = reasons.map(reason => reason.replace(/^– (?:(?:control|headset) code (?!partly outside))?/, ''));

    const unknown = [result, ...warnings, ...sections.map(({ words }) => words), ...texts].filter(text => !catalogue.test(text));

    assert.ok(reasons.length > 0);
    assert.deepEqual(unknown, [], STORED_OUTDATED);
  });
});

// Checks that the manual's pictures are up to date: the pages must have the same text as when the pictures were taken.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { openOperations, path, PICTURES, setState, stored, textsOf } from '../pictures/screens.mjs';
import { Browser, NO_WEBGL } from './browser.mjs';
import { FakeGateway } from './fakeGateway.mjs';

const MAX_WIDTH = 1400, MAX_BYTES = 250_000, WIDTH_OFFSET = 16;
const texts = JSON.parse(readFileSync(path('texts.json'), 'utf8'));
const OUTDATED = 'the page has changed: run `npm run pictures` in Web, look at the pictures and commit them';

describe('a picture of the manual', () => {
  let browser;
  before(async () => { browser = await Browser.start('report', NO_WEBGL); });
  after(() => browser.stop());

  for (const [page, data] of [['report', 'demo'], ['calibration', 'calibration']]) {
    it(`has the texts of the current ${page} page`, async () => {
      assert.deepEqual(await textsOf(await browser.open(stored(data), { name: page })), texts[page], OUTDATED);
    });
  }

  it('has the texts of the current operations page', async () => {
    const gateway = await FakeGateway.start();
    try {
      setState(gateway);

      assert.deepEqual(await textsOf(await openOperations(browser.browser, gateway)), texts.operations, OUTDATED);
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

describe('the stored data of a picture', () => {
  const sources = folder => readdirSync(path(folder), { recursive: true }).filter(file => file.endsWith('.cs'))
    .map(file => readFileSync(join(path(folder), file), 'utf8')).join('\n').toLowerCase();

  for (const [name, folder] of [['demo', '../../Cli/Demo'], ['calibration', '../../Cli/Calibrate']]) {
    it(`has labels that the command line still writes: ${name}`, () => {
      const { facts, settings = [], subtitle = '', sections = [] } = stored(name), source = sources(folder) + sources('../../Cli/Messages');
      const labels = [...facts, ...settings].map(([label]) => label.replace(/^– .*/, '')).concat(subtitle, sections.map(each => each.heading));

      const unknown = labels.filter(label => !source.includes(label.toLowerCase()));

      assert.deepEqual(unknown, [], 'the command line has changed: run `npm run pictures -- --record` in Web, look at the pictures and commit them');
    });
  }
});

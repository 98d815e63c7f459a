import assert from 'node:assert/strict';
import { before, describe, it } from 'node:test';
import { calibration } from './calibrationSample.mjs';
import { explainedTerms } from './glossary.mjs';
import { hasInk } from './inks.mjs';
import { repeatedLandmarks } from './landmarks.mjs';
import { opener } from './pages.mjs';

const HOSTILE = '</script><script>alert(1)</script><img src=x onerror=alert(2)>';

const open = opener('calibration');

const texts = (page, selector) => page.locator(selector).allInnerTexts();

/** Returns the share of pixels in one column of a plot's canvas that have the colour of a trace: large for an error bar, and small for a line. */
const inked = (page, plot, ink) => page.locator('.plot canvas').nth(plot).evaluate((canvas, name) => {
  const probe = document.createElement('canvas').getContext('2d');
  probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  probe.fillRect(0, 0, 1, 1);
  const wanted = probe.getImageData(0, 0, 1, 1).data, { data, width, height } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let tallest = 0, columns = 0;
  for (let x = 0; x < width; x++) {
    let count = 0;
    for (let y = 0; y < height; y++) {
      const at = 4 * (y * width + x);
      if (Math.abs(data[at] - wanted[0]) + Math.abs(data[at + 1] - wanted[1]) + Math.abs(data[at + 2] - wanted[2]) < 24 && data[at + 3] > 200) count++;
    }
    tallest = Math.max(tallest, count);
    if (count > 0) columns++;
  }
  return { tallest, columns };
}, ink);

describe('the calibration page', () => {
  // The tests that only read the page share it.
  let complete;
  before(async () => { complete = await open(calibration()); });

  it('explains terms of the glossary on hover', async () => {
    assert.deepEqual(await explainedTerms(complete), ['L_visu']);
  });

  it('has no landmark with the same name twice, and the terms in a landmark', async () => {
    assert.deepEqual(await repeatedLandmarks(complete), []);
    assert.equal(await complete.locator('footer .terms').count(), 1);
  });

  it('opens without an error or a request, with the result first', async () => {
    assert.deepEqual(complete.complaints, []);
    assert.equal(await complete.title(), 'Constant-latency range · Nowpose');
    assert.match((await texts(complete, 'header'))[0], /L\s*visu is 40\.0 ms ± 1\.0 ms while the render time is below 15\.13 ms/);
    assert.deepEqual(await texts(complete, 'table.facts tbody td'), ['40.00 ms', 'HoloLens 2']);
  });

  it('shows its warnings', async () => {
    const page = await open(calibration({ warnings: ['limit not reached: sweep on'] }));

    assert.deepEqual(await texts(page, '.warning'), ['limit not reached: sweep on']);
  });

  it('draws an error bar at each mean with a deviation', async () => {
    const bars = await inked(complete, 0, '--adaptive');
    const none = calibration();
    none.sections[0].plots[0].traces[0].deviation = null;
    const plain = await inked(await open(none), 0, '--adaptive');

    assert.ok(bars.tallest > plain.tallest + 20, `${bars.tallest} of ${plain.tallest} pixels`);
  });

  it('draws individual pictures as points without a line between them', async () => {
    const points = await inked(complete, 1, '--adaptive');
    const joined = calibration();
    joined.sections[1].plots[0].traces[0].scattered = false;
    const line = await inked(await open(joined), 1, '--adaptive');

    assert.ok(points.columns > 60, `${points.columns} columns`);
    assert.ok(line.tallest >= 1.5 * points.tallest, `${line.tallest} of ${points.tallest} pixels: the step is drawn only by the line`);
  });

  it('cites the figure and keeps the numbers in a table', async () => {
    assert.match((await texts(complete, 'main section'))[1], /Schnierle & Röck 2022, Fig\. 11a/);
    await complete.locator('section summary').click();
    assert.deepEqual(await texts(complete, 'details tbody td'), ['40', '41', '–']);
  });

  it('draws plots in the colours of their signals in the dark scheme', async () => {
    const page = await open(calibration(), { colorScheme: 'dark' });

    assert.ok(await hasInk(page, 0, '--adaptive'));
    assert.ok(await hasInk(page, 1, '--adaptive'));
  });

  it('shows hostile text as text', async () => {
    const page = await open(calibration({ title: HOSTILE, result: HOSTILE, warnings: [HOSTILE], facts: [[HOSTILE, HOSTILE]] }));

    assert.deepEqual(page.complaints, []);
    assert.equal((await texts(page, 'h1'))[0], HOSTILE);
  });

  it('fits a narrow window', async () => {
    const page = await open(calibration(), { viewport: { width: 360, height: 700 } });

    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(overflow <= 0, `${overflow} px too wide`);
  });
});

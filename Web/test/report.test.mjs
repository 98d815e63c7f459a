import assert from 'node:assert/strict';
import { before, describe, it } from 'node:test';
import { contrast, hasInk, luminance, painted, settled, shadedShare } from './inks.mjs';
import { figures } from './figuresSample.mjs';
import { explainedTerms } from './glossary.mjs';
import { messages } from './messages.mjs';
import { opener } from './pages.mjs';
import { report } from './sample.mjs';

const HOSTILE = '</script><script>alert(1)</script><img src=x onerror=alert(2)>&lt;b&gt;"\'';
const PLOTS = 6;
const { claimTitles, plotMessages, plotValueMessages, reportLabels } = messages;

const open = opener('report');

const text = (page, selector) => page.locator(selector).allInnerTexts();
const plain = words => words.map(w => w.replaceAll('\u00ad', '').replaceAll('\u00a0', ' '));

// Pages that several tests share because they only read them, in the light and in the dark scheme.
let complete, dark;
before(async () => {
  const data = report();
  data.summary[0] = { label: 'Tool error, RMS', unit: 'mm', uncompensated: 20, compensated: 3.5 };
  [complete, dark] = [await open(data), await open(report(), { colorScheme: 'dark' })];
});

describe('a complete report', () => {

  it('opens without an error or a request', async () => {
    assert.deepEqual(complete.complaints, []);
  });

  it('has its headings in order', async () => {
    assert.deepEqual(await text(complete, 'h1'), ['Nowpose: youBot over WiFi']);
    assert.equal(await complete.title(), 'Nowpose: youBot over WiFi');
    assert.deepEqual(await text(complete, 'h2'), ['Result', claimTitles.error, 'Joint position: arm_joint_1', 'Error field',
      'Clock synchronisation', 'Application latency of the samples', 'Conditions and figures']);
  });

  it('shows the reduction, the table and the error plot on the first screen', async () => {
    const [headline] = plain(await text(complete, '.headline'));
    assert.match(headline, /^82\.5 %\s[^]*\sTool error, RMS: 20 mm → 3\.50 mm$/);
    assert.ok(headline.includes(reportLabels.lessError));
    for (const selector of ['.headline', '.overview table', '#error .plot']) {
      const box = await complete.locator(selector).boundingBox();
      assert.ok(box.y + box.height <= 800, `${selector} ends at ${box.y + box.height} px`);
    }
  });

  it('reports an increased error', async () => {
    const page = await open({ summary: [{ label: 'RMS', unit: 'mm', uncompensated: 4, compensated: 5 }] });

    const [headline] = plain(await text(page, '.headline'));
    assert.ok(headline.startsWith('25 %') && headline.includes(reportLabels.moreError), headline);
    assert.deepEqual(plain(await text(page, '.overview tbody td')), ['4', '5', '+25 %']);
  });

  it('has captions and header cells on each table', async () => {
    const faults = await complete.evaluate(() => [...document.querySelectorAll('table')]
      .filter(t => !t.caption?.textContent || !t.querySelector('thead th[scope=col]') || !t.querySelector('tbody th[scope=row]'))
      .map(t => t.outerHTML));
    assert.deepEqual(faults, []);
    assert.deepEqual(plain(await text(complete, '.overview thead th')), ['Quantity', 'Uncompensated', 'Compensated', 'Change']);
    assert.ok((await text(complete, '#facts tbody tr')).includes('total latency error P95\t–'), 'a fact without value is a dash');
  });

  it('names the unit of each table of numbers', async () => {
    const captions = await complete.locator('details caption').allTextContents();
    assert.deepEqual(captions, ['Tool error (mm)', 'Joint position (rad)', `${reportLabels.latencyOfPoints} (ms)`, 'Clock (µs)',
      'Samples by latency']);
  });

  it('draws each plot in the colours of its signals', async () => {
    const plots = await painted(complete);
    assert.equal(plots.length, PLOTS);
    for (const { pixels, colours } of plots) assert.ok(pixels > 2000 && colours > 2, `${pixels} pixels, ${colours} colours`);
    const inks = [['--hold', '--compensated'], ['--truth', '--hold', '--compensated'], ['--hold', '--compensated'],
      ['--compensated'], ['--compensated'], ['--compensated']];
    for (const [i, wanted] of inks.entries()) {
      for (const ink of wanted) assert.ok(await hasInk(complete, i, ink), `plot ${i} has no ${ink}`);
    }
  });

  it('explains terms of the glossary on hover', async () => {
    const terms = await explainedTerms(complete);
    for (const term of ['Tool error', 'sampling interval', 'predictor', 'offset', 'Application latency']) assert.ok(terms.includes(term), term);
  });

  it('describes each plot and its claim in words, with the paper as source', async () => {
    const words = await complete.evaluate(() => [...document.querySelectorAll('.plot')].map(p => p.getAttribute('aria-label')));
    assert.equal(words.length, PLOTS);
    for (const w of words) assert.match(w, /\d/);
    const sources = await complete.locator('.claim a').evaluateAll(links => links.map(a => [a.href, a.textContent]));
    assert.deepEqual(sources.map(s => s[1].replace('Schnierle & Röck 2022, ', '')), ['Sect. 3', 'Fig. 16', 'Fig. 18', 'Fig. 8', 'Eq. 2']);
    assert.ok(sources.every(s => s[0] === 'https://doi.org/10.1007/s11740-022-01175-2'));
  });
});

describe('a report of a run with a load', () => {
  const t = Array.from({ length: 600 }, (_, i) => i / 60);
  const isLoaded = s => s >= 4 && s < 7;
  const range = { t, render_ms: t.map(s => (isLoaded(s) ? 17 : 4)), visu_ms: t.map(s => (isLoaded(s) ? 57 : 40)), limit_ms: 15, alarms: [[4.1, 7.5]] };

  it('shows both plots with the limit, shades the alarm and states its time', async () => {
    const page = await open({ ...report(), range });

    assert.deepEqual(page.complaints, []);
    assert.equal(await page.locator('#range .plot canvas').count(), 2);
    const words = await page.locator('#range .plot').first().getAttribute('aria-label');
    assert.match(words, new RegExp(`render time: 4 to 17.ms.*limit: 15 to 15.ms.*${plotValueMessages.alarm('4.10', '7.50.s')}`));
    assert.ok(await shadedShare(page, 5.5) > 0.5, 'during the alarm');
    assert.ok(await shadedShare(page, 2) < 0.1, 'before the alarm, only the line of the limit');
  });

  it('states that no alarm occurred', async () => {
    const page = await open({ ...report(), range: { ...range, alarms: [] } });

    assert.match(await page.locator('#range .plot').first().getAttribute('aria-label'), new RegExp(plotValueMessages.noAlarm));
    assert.ok(await shadedShare(page, 5.5) < 0.1);
  });
});

describe('missing measurements', () => {
  for (const [name, data] of [['absent', {}], ['null', { settings: null, summary: null, facts: null, error: null, joint: null,
    field: null, clock: null, latency: null }], ['empty', { settings: [], summary: [], facts: [], error: { t: [], hold: [], compensated: [] },
    joint: { name: 'a', unit: 'rad', truth: null, received: { t: [], v: [] } }, field: { hold: null, compensated: null, iso_mm: [] },
    clock: { t: [], offset_us: [], error_us: [], bound_us: [] }, latency: { bin_ms: [], count: [] } }]]) {
    it(`are stated in each section (${name})`, async () => {
      const page = await open(data);

      assert.deepEqual(page.complaints, []);
      assert.equal(await page.locator('.plot').count(), 0);
      const words = await text(page, '.missing');
      assert.equal(words.length, 9);
      const forms = [plotMessages.notMeasured, ...['Tool error', 'Comparison', 'Settings', 'Measured'].map(plotMessages.partNotMeasured)];
      assert.deepEqual([...new Set(words)].sort(), forms.sort());
    });
  }

  it('of one signal do not affect the others', async () => {
    const data = report();
    data.joint.predicted = null;
    data.field.compensated = null;
    data.summary[0].compensated = null;
    const page = await open(data);

    assert.deepEqual(page.complaints, []);
    assert.deepEqual(await text(page, '#joint .key'), ['ground truth', 'received']);
    assert.deepEqual(await text(page, '#field .key'), ['uncompensated', 'equal error']);
  });

  it('of single values are drawn as gaps', async () => {
    const data = report();
    data.error.compensated = data.error.compensated.map((v, i) => (i % 7 ? v : null));
    data.clock.error_us = data.clock.error_us.map(() => null);
    const page = await open(data);

    assert.deepEqual(page.complaints, []);
    assert.equal(await page.locator('.plot').count(), PLOTS);
  });
});

describe('any window and any text', () => {
  it('shows hostile text as text', async () => {
    const data = report();
    data.title = data.subtitle = data.joint.name = data.latency.label = HOSTILE;
    data.settings = [[HOSTILE, HOSTILE]];
    data.facts = [[HOSTILE, HOSTILE]];
    data.summary = [{ label: HOSTILE, unit: HOSTILE, uncompensated: 2, compensated: 1 }];
    const page = await open(data);

    assert.deepEqual(page.complaints, []);
    assert.equal(await page.locator('img').count(), 0);
    assert.equal((await text(page, 'h1'))[0], HOSTILE);
    assert.equal((await text(page, '#facts td'))[0], HOSTILE);
  });

  // The width of this page changes.
  let page;
  before(async () => {
    const data = report();
    data.summary = ['RMS', 'P95', 'Maximum'].map(label => ({ label, unit: 'mm', uncompensated: 133.513, compensated: 11.268 }));
    data.claims = [{ figure: '16', claim: 'The signal follows.', paper: '−80 %', measured: '81 % ± 2 %', verdict: 'does not hold' }];
    data.figures = figures().figures.filter(f => f.number === '16');
    page = await open(data, { viewport: { width: 320, height: 800 } });
  });
  const widen = async width => {
    await page.setViewportSize({ width, height: 800 });
    await settled(page);
  };

  for (const width of [320, 360, 768, 1920]) {
    it(`fits a window of ${width} px`, async () => {
      await widen(width);

      const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(content <= window, `${content} px of content`);
      const outside = await page.evaluate(() => [...document.querySelectorAll('section button, .plot canvas')]
        .filter(e => e.getBoundingClientRect().right > e.closest('section').getBoundingClientRect().right).length);
      assert.equal(outside, 0);
    });
  }

  for (const width of [400, 1000, 1280]) {
    it(`shows all columns of the results and the claims in a window of ${width} px`, async () => {
      await widen(width);

      for (const section of ['.overview', '#claims']) {
        const [content, shown] = await page.locator(`${section} .table`).evaluate(table => [table.scrollWidth, table.clientWidth]);
        assert.ok(content <= shown, `${section}: ${content} px of ${shown} px`);
      }
    });
  }

  it('refits the plots when the window changes', async () => {
    await widen(1280);
    await widen(500);

    const widths = await page.evaluate(() => [...document.querySelectorAll('.plot')]
      .map(p => p.clientWidth - p.querySelector('canvas').getBoundingClientRect().width));
    assert.ok(widths.every(w => w >= 0 && w < 2), widths.join(', '));
  });

  it('uses light ink on dark and dark ink on light', async () => {
    const lightness = async page => {
      assert.ok(await hasInk(page, 0, '--compensated'));
      return page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number)[0]);
    };

    assert.ok(await lightness(complete) > 200);
    assert.ok(await lightness(dark) < 50);
  });

  it('repaints when the colour scheme changes', async () => {
    const page = await open(report(), { colorScheme: 'light' });

    await page.emulateMedia({ colorScheme: 'dark' });
    await settled(page);

    assert.ok(await hasInk(page, 0, '--compensated'));
    assert.ok(await hasInk(page, 2, '--hold'));
  });

  it('distinguishes signals by lightness', async () => {
    for (const [colorScheme, page] of Object.entries({ light: complete, dark })) {
      const [hold, compensated, truth, surface] = await luminance(page, ['--hold', '--compensated', '--truth', '--surface']);
      assert.ok(contrast(hold, compensated) > 1.7, `${colorScheme}: hold and compensated`);
      // A contrast of 3 to both the page and the compensated signal is impossible in the light scheme.
      assert.ok(contrast(truth, compensated) > 2.8, `${colorScheme}: truth and compensated`);
      assert.ok(contrast(hold, surface) > 3 && contrast(compensated, surface) > 4.5 && contrast(truth, surface) > 3, `${colorScheme}: on the page`);
    }
  });

  it('prints in the light scheme, with plots as wide as the page', async () => {
    await dark.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await settled(dark);
    const [surface, widths] = await dark.evaluate(() => [getComputedStyle(document.documentElement).getPropertyValue('--surface').trim(),
      [...document.querySelectorAll('.plot canvas')].map(c => Math.round(c.getBoundingClientRect().width))]);
    assert.ok(await hasInk(dark, 0, '--compensated'));
    await dark.evaluate(() => dispatchEvent(new Event('afterprint')));

    assert.equal(surface, '#ffffff');
    assert.ok(widths.every(w => w === 700), widths.join(', '));
  });
});

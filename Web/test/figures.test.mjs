import assert from 'node:assert/strict';
import { before, describe, it } from 'node:test';
import { figures } from './figuresSample.mjs';
import { explainedTerms } from './glossary.mjs';
import { contrast, hasInk, luminance, settled } from './inks.mjs';
import { messages } from './messages.mjs';
import { opener } from './pages.mjs';

const { criterionLabels } = messages;

const HOSTILE = '</script><script>alert(1)</script><img src=x onerror=alert(2)>&lt;b&gt;"\'';
const PLOTS = 5;

const open = opener('figures');

const texts = (page, selector) => page.locator(selector).allInnerTexts();

// Pages that several tests share, in the light and in the dark scheme. A test that changes one restores it.
let complete, dark;
before(async () => { [complete, dark] = [await open(figures()), await open(figures(), { colorScheme: 'dark' })]; });

describe('the figures page', () => {

  it('opens without an error or a request', async () => {
    assert.deepEqual(complete.complaints, []);
    assert.equal(await complete.title(), 'The paper\u2019s figures, recomputed');
  });

  it('lists each figure with its verdict, linked to its section', async () => {
    assert.deepEqual(await texts(complete, 'nav tbody .badge'), ['holds', 'does not hold', 'holds partly', 'holds', 'holds']);
    const links = await complete.locator('nav tbody a').evaluateAll(all => all.map(a => [a.textContent, !!document.querySelector(a.getAttribute('href'))]));
    assert.deepEqual(links, [['Fig. 4', true], ['Fig. 8', true], ['Fig. 13a', true], ['Fig. 16', true], ['Fig. 17', true]]);
  });

  it('sets the indices of symbols as subscripts', async () => {
    const data = figures();
    data.figures[0].claim = 'T_s, ε_L and (ε_i) differ';
    const page = await open(data);

    assert.deepEqual(await texts(page, '#fig-4 .words .symbol'), ['Ts', 'εL', 'εi']);
  });

  it('explains terms of the glossary on hover', async () => {
    const terms = await explainedTerms(complete);
    for (const term of ['Sampling interval', 'sampling interval', 'hold']) assert.ok(terms.includes(term), term);
  });

  it('shows the paper\'s claim beside the measurement, with the met criteria in words', async () => {
    const words = await texts(complete, '#fig-13a .words');
    assert.match(words[0], /The paper says[^]*large parts of the range of T\s*s the quadratic[^]*Schnierle & Röck 2022, Fig\. 13a/);
    assert.match(words[0], /We measure[^]*Measured: best at 50 ms\.[^]*the cubic is better at 10 ms[^]*Beyond the paper[^]*adaptive leaves 50 %/);
    const signs = await complete.locator('#fig-13a .sign').evaluateAll(all => all.map(s => s.getAttribute('aria-label')));
    assert.deepEqual(signs, [`${criterionLabels.met}:`, `${criterionLabels.notMet}:`]);
  });

  it('draws plots in the colours of their signals, with units on the axes and a description', async () => {
    assert.equal(await complete.locator('.plot').count(), PLOTS);
    const inks = [['--hold', '--quadratic'], ['--quadratic', '--adaptive'], ['--linear'],
      ['--linear', '--quadratic', '--cubic', '--adaptive'], ['--truth', '--hold', '--quadratic']];
    for (const [i, wanted] of inks.entries()) {
      for (const ink of wanted) assert.ok(await hasInk(complete, i, ink), `plot ${i} has no ${ink}`);
    }
    const labels = await complete.locator('.plot').evaluateAll(all => all.map(p => p.getAttribute('aria-label')));
    assert.match(labels[3], /^Fig\. 13a, RMS error: linear RMS error from 15 to 46\smm; quadratic/);
    assert.match(labels[0], /hold latency from 55 to 275\sms/);
  });

  it('reads values at the cursor with the unit of the horizontal axis', async () => {
    await complete.locator('#fig-13a .u-over').hover();

    const [position] = await texts(complete, '#fig-13a .position');
    assert.match(position, /^sampling interval \d\d\.\d\sms$/);
  });

  it('zooms, moves and resets with the keyboard', async () => {
    const plot = complete.locator('#fig-16 .plot');
    const picture = () => plot.locator('canvas').evaluate(c => c.toDataURL());
    const first = await picture();

    await plot.focus();
    await complete.keyboard.press('+');
    await settled(complete);
    const zoomed = await picture();
    await complete.keyboard.press('0');
    await settled(complete);

    assert.notEqual(zoomed, first);
    assert.equal(await picture(), first);
  });

  it('shows each drawing with its description, in the colours of the page', async () => {
    const drawings = await dark.locator('#fig-17 svg[role=img]').evaluateAll(all => all.map(s => [s.getAttribute('aria-label'),
      getComputedStyle(s.querySelector('line')).stroke, s.getBoundingClientRect().width]));
    assert.equal(drawings.length, 3);
    assert.equal(drawings[0][0], 'At A the uncompensated gripper is 78 mm off.');
    assert.equal(drawings[0][1], 'rgb(217, 138, 61)');
    assert.ok(drawings.every(d => d[2] > 150));
  });

  it('has the data of each figure in a table with a caption, and a dash for missing values', async () => {
    await complete.locator('#fig-13a summary').click();

    assert.match((await texts(complete, '#fig-13a summary'))[0], /figure-13a\.csv/);
    assert.deepEqual(await texts(complete, '#fig-13a details tbody td'), ['6.40', '18.4', '–']);
    await complete.locator('#fig-13a summary').click();
    const faults = await complete.evaluate(() => [...document.querySelectorAll('table')]
      .filter(t => !t.caption?.textContent || !t.querySelector('thead th[scope=col]') || !t.querySelector('tbody th[scope=row]')).length);
    assert.equal(faults, 0);
  });

  it('names each region and has unique ids', async () => {
    const [unnamed, ids] = await complete.evaluate(() => [
      [...document.querySelectorAll('[role=region], nav, section')].filter(e => !e.hasAttribute('aria-label') && !e.hasAttribute('aria-labelledby')).length,
      [...document.querySelectorAll('[id]')].map(e => e.id)]);
    assert.equal(unnamed, 0);
    assert.equal(new Set(ids).size, ids.length);
  });

  it('lists the figures that an interrupted run did not compute', async () => {
    const page = await open({ ...figures(), missing: ['12', '18'] });

    assert.deepEqual(await texts(page, '.missing'), [messages.figuresMessages.notComputed('Fig. 12, Fig. 18')]);
  });

  it('opens at the section that the address names', async () => {
    const page = await open(figures(), { fragment: '#fig-17' });

    const top = await page.locator('#fig-17').evaluate(s => s.getBoundingClientRect().top);
    assert.ok(top > -5 && top < 500, `at ${top} px`);
  });
});

describe('any window and any text', () => {
  it('shows hostile text as text, and runs no script of a drawing', async () => {
    const data = figures();
    data.title = data.subtitle = HOSTILE;
    data.conditions = [[HOSTILE, HOSTILE]];
    Object.assign(data.figures[2], { title: HOSTILE, claim: HOSTILE, beyond: HOSTILE, conditions: HOSTILE, file: HOSTILE });
    data.figures[2].criteria[0].measured = HOSTILE;
    const page = await open(data);

    assert.deepEqual(page.complaints, []);
    assert.equal(await page.locator('img').count(), 0);
    assert.equal((await texts(page, 'h1'))[0], HOSTILE);
  });

  // The width of this page changes.
  let page;
  before(async () => { page = await open(figures(), { viewport: { width: 320, height: 800 } }); });

  for (const width of [320, 360, 768, 1920]) {
    it(`fits a window of ${width} px`, async () => {
      await page.setViewportSize({ width, height: 800 });
      await settled(page);

      const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(content <= window, `${content} px of content`);
    });
  }

  it('distinguishes Nowpose\u2019s, the paper\u2019s and the uncompensated signals by lightness, from each other and from the page', async () => {
    for (const [colorScheme, page] of Object.entries({ light: complete, dark })) {
      const [adaptive, gp, quadratic, cubic, linear, truth, surface] = await luminance(
        page, ['--adaptive', '--gp', '--quadratic', '--cubic', '--linear', '--truth', '--surface']);
      assert.ok(contrast(adaptive, quadratic) > 1.5, `${colorScheme}: adaptive and quadratic`);
      for (const [name, ink] of Object.entries({ adaptive, gp, quadratic, cubic, linear, truth })) {
        assert.ok(contrast(ink, surface) > 3, `${colorScheme}: ${name} on the page, ${contrast(ink, surface)}`);
      }
    }
  });

  it('shows verdicts with sufficient contrast', async () => {
    for (const [colorScheme, page] of Object.entries({ light: complete, dark })) {
      const [met, partly, unmet, surface] = await luminance(page, ['--met', '--partly', '--unmet', '--surface']);
      for (const ink of [met, partly, unmet]) assert.ok(contrast(ink, surface) > 4.5, `${colorScheme}: ${contrast(ink, surface)}`);
    }
  });

  it('prints in the light scheme, with plots as wide as the page', async () => {
    await dark.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await settled(dark);
    const [surface, widths] = await dark.evaluate(() => [getComputedStyle(document.documentElement).getPropertyValue('--surface').trim(),
      [...document.querySelectorAll('.plot canvas')].map(c => Math.round(c.getBoundingClientRect().width))]);
    await dark.evaluate(() => dispatchEvent(new Event('afterprint')));

    assert.equal(surface, '#ffffff');
    assert.ok(widths.every(w => w === 700), widths.join(', '));
  });
});

import assert from 'node:assert/strict';
import { before, describe, it } from 'node:test';
import { figures } from './figuresSample.mjs';
import { messages } from './messages.mjs';
import { opener } from './pages.mjs';
import { report } from './sample.mjs';

const HOSTILE = '</script><script>alert(1)</script><img src=x onerror=alert(2)>&lt;b&gt;"\'';
const PLOTS = 6;
const { criterionLabels, figuresLabels } = messages;

const open = opener('report');

const text = (page, selector) => page.locator(selector).allInnerTexts();
const plain = words => words.map(w => w.replaceAll('\u00ad', '').replaceAll('\u00a0', ' '));

describe('a report of the paper’s scenario', () => {
  const ofPaper = () => ({
    ...report(),
    claims: [
      { figure: '8', claim: 'The fitting error is less than 1 ms.', paper: '1 ms', measured: '0.3 ms', verdict: 'holds' },
      { figure: '16', claim: 'The signal follows.', paper: '', measured: '81 % ± 2 %', verdict: 'does not hold' },
    ],
    figures: figures().figures.filter(f => f.number === '8' || f.number === '16'),
  });

  // Two tests that only read the page share it.
  let page;
  before(async () => { page = await open(ofPaper()); });

  it('opens without an error and shows the paper’s figures in place of the demo’s sections', async () => {
    assert.deepEqual(page.complaints, []);
    const headings = await text(page, 'h2');
    assert.ok(headings.includes(figuresLabels.claimsAndRun));
    assert.ok(headings.some(h => h.startsWith('Fig. 8')) && headings.some(h => h.startsWith('Fig. 16')));
    assert.ok(!headings.includes('Clock synchronisation') && !headings.includes('Error field'));
  });

  it('shows each claim with both numbers and its verdict', async () => {
    const rows = await page.locator('#claims tbody tr').evaluateAll(all => all.map(row => [...row.children].map(cell => cell.innerText)));
    assert.deepEqual(plain(rows[0]), ['Fig. 8', 'The fitting error is less than 1 ms.', '1 ms', '0.3 ms', 'holds']);
    assert.deepEqual(plain(rows[1]).slice(2), ['–', '81 % ± 2 %', 'does not hold']);
    await page.locator('#claims a').first().click();
    assert.match(page.url(), /#fig-8$/);
  });

  it('shows an undecided claim as undecided, not as held or failed', async () => {
    const data = ofPaper();
    const [clock] = data.figures;
    Object.assign(data.claims[0], { measured: '0.9 ms ± 0.3 ms', verdict: 'undecided' });
    clock.verdict = 'undecided';
    Object.assign(clock.criteria[0], { is_met: null, is_undecided: true, measured: '0.9 ms ± 0.3 ms' });

    const page = await open(data);

    assert.deepEqual(page.complaints, []);
    const badges = page.locator('#claims tr:first-child .badge, #fig-8 h2 .badge');
    assert.deepEqual(await badges.allInnerTexts(), ['undecided', 'undecided']);
    const ink = await page.locator('#claims .badge').evaluateAll(all => all.map(badge => getComputedStyle(badge).color));
    assert.notEqual(ink[0], ink[1], 'undecided and does not hold');
    const criterion = page.locator('#fig-8 .criteria li').first();
    assert.equal(await criterion.locator('.sign').getAttribute('aria-label'), 'undecided:');
    assert.match(await criterion.innerText(), /^\?[^]*Measured: 0\.9\sms ± 0\.3\sms\.$/);
  });

  it('links only claims whose figure is on the page', async () => {
    const data = ofPaper();
    data.figures = data.figures.filter(f => f.number === '8');

    const page = await open(data);

    assert.deepEqual(page.complaints, []);
    assert.deepEqual(plain(await text(page, '#claims tbody th')), ['Fig. 8', 'Fig. 16']);
    assert.deepEqual(plain(await text(page, '#claims a')), ['Fig. 8']);
  });

  it('shows a figure without data and without a verdict', async () => {
    const data = ofPaper();
    const [clock] = data.figures;
    Object.assign(clock, { verdict: 'not measured', plots: [], table: { columns: ['time (s)'], rows: [] } });
    for (const criterion of clock.criteria) Object.assign(criterion, { is_met: null, measured: 'not measured: the run was too short' });

    const page = await open(data);

    assert.deepEqual(page.complaints, []);
    const signs = await page.locator('#fig-8 .sign').evaluateAll(all => all.map(s => s.getAttribute('aria-label')));
    assert.deepEqual(signs, Array(2).fill(`${criterionLabels.notMeasured}:`));
    assert.match((await text(page, '#fig-8 .criteria')).join(), /below 50 ms\.\snot measured: the run was too short\./);
  });
});

// Tests the controls and the accessibility of the operations page, with different windows and settings.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { coloursInThemes, contrast, luminance, settled } from '../inks.mjs';
import { repeatedLandmarks } from '../landmarks.mjs';
import { messages } from '../messages.mjs';
import { readElement } from '../qr.mjs';
import { ago, becomes, cells, gateway, nextState, open, showsToolError, withGraphics } from './page.mjs';

const { emptyMessages, gatewayReasons, operationsMessages, recorderLabels } = messages;

/** Returns the minimum contrast between the text of the content and the background of the page, after opacity and greyscale. */
const weakestText = page => page.evaluate(() => {
  const channels = colour => colour.match(/[\d.]+/g).slice(0, 3).map(c => c / 255);
  const linear = c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  const back = channels(getComputedStyle(document.body).backgroundColor);
  let weakest = Infinity;
  for (const e of document.querySelectorAll('#content dt, #content dd, #content p, #content th, #content td')) {
    if (!e.checkVisibility() || !e.textContent.trim()) continue;
    let ink = channels(getComputedStyle(e).color), opacity = 1, isGrey = false;
    for (let at = e; at; at = at.parentElement) {
      const { opacity: own, filter } = getComputedStyle(at);
      opacity *= own;
      isGrey ||= filter.includes('grayscale');
    }
    if (isGrey) ink = ink.map((_, __, [r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b);
    const [a, b] = [luminance(ink.map((c, i) => opacity * c + (1 - opacity) * back[i])), luminance(back)];
    weakest = Math.min(weakest, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05));
  }
  return weakest;
});

describe('actions', () => {
  it('switch the recorder on and off', async () => {
    const page = await open();

    await page.locator('#record').focus();
    await page.keyboard.press('Enter');
    await becomes(page, '#recording', recorderLabels.recording('press-3.jsonl', '12 lines'));
    assert.equal(await page.textContent('#record'), recorderLabels.stop);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'record', 'the button keeps the focus');
    await becomes(page, '#record-done', recorderLabels.hasStarted);
    assert.equal(await page.getAttribute('#record', 'aria-pressed'), null, 'the text already states it');
    await page.click('#record');
    await becomes(page, '#recording', 'stopped');
    await becomes(page, '#record-done', recorderLabels.hasStopped);

    assert.deepEqual(gateway.posts, [['/operations/recording', { on: 'true' }], ['/operations/recording', { on: 'false' }]]);
  });

  it('do not include recording if the gateway has no folder', async () => {
    gateway.state.recording = { can: false, on: false };
    const page = await open();

    assert.ok(await page.locator('#record').isHidden());
    assert.ok(await page.locator('#recordings-section').isHidden());
    assert.equal(await page.textContent('#recording'), operationsMessages.noFolder);
  });

  it('list and download recordings with their sizes, and show a deleted one', async () => {
    const page = await open({ hasVirtualTime: true });
    await becomes(page, '#recordings', 'press-1.jsonl');
    assert.equal((await cells(page, 'press-1.jsonl'))[0], '2.50');

    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#recordings a')]);
    assert.equal(download.suggestedFilename(), 'press-1.jsonl');
    assert.match(download.url(), /\/operations\/recordings\/press-1\.jsonl$/);

    gateway.recordings = [];
    // The page requests the list every 5 s.
    await page.clock.fastForward(5000);
    await becomes(page, '#recordings', emptyMessages.recordings);
    assert.equal(await page.textContent('#recordings-note'), '', 'a recording of another folder is not deleted');
    gateway.state.events = [{ id: 7, kind: 'recording', which: 'press-1.jsonl', what: 'was deleted', reason: '', level: 'warning', since_utc: ago(1), until_utc: ago(1) }];
    await becomes(page, '#recordings-note', recorderLabels.deleted('press-1.jsonl'));
    gateway.state.recording = { can: true, on: false, file: 'press-1.jsonl', lines: 5, bytes: 10, lost: 0, deleted: true };
    await becomes(page, '#recording', `last press-1.jsonl: ${recorderLabels.fileDeleted}`);
    gateway.state.recording = { can: true, on: true, file: 'press-4.jsonl', files: 3, lines: 5, bytes: 3_000_000, lost: 0 };
    await becomes(page, '#recording', recorderLabels.size('5', '3\u00a0MB', 3));
  });

  it('list recordings only for operators', async () => {
    gateway.state.role = 'observer';
    const page = await open();

    await becomes(page, '#recordings-note', operationsMessages.listAsOperator);
    assert.equal(await page.locator('#recordings a').count(), 0);
  });

  it('explain a missing permission to record and a recorder\'s problem', async () => {
    gateway.state.role = 'observer';
    const page = await open();
    assert.ok(await page.isDisabled('#record'));
    assert.equal(await page.textContent('#may-record'), operationsMessages.recordAsOperator);

    gateway.state.recording = { can: true, on: false, file: 'a.jsonl', lines: 5, bytes: 10, lost: 3, problem: 'the disk is full' };
    await becomes(page, '#recording', '3 lines are missing. Problem: the disk is full');
  });

  it('show and hide the pairing code', async () => {
    const page = await open({ hasVirtualTime: true });
    const requests = [];
    page.on('request', request => requests.push(request.url()));
    assert.deepEqual(gateway.posts, []);

    await page.click('#show-code');
    await page.waitForSelector('#token svg');
    assert.equal(await readElement(page.locator('#token svg')), 'nowpose:token/1?t=AAAAAAAAAAAAAAAAAAAAAA&x=1');
    await page.click('#show-code');

    assert.ok(await page.locator('#code').isHidden());
    assert.equal(await page.locator('#token svg').count(), 0);
    requests.length = 0;
    await page.clock.fastForward(2500);
    await page.waitForRequest(/state$/);
    assert.deepEqual(requests.filter(url => url.includes('/pair/')), []);
  });
});

describe('the pairing code', () => {
  it('is not shown if it arrives after it was hidden', async () => {
    const page = await open();
    let release;
    gateway.codeIsLate = new Promise(resolve => { release = resolve; });
    await Promise.all([page.waitForRequest(/pair\/code/), page.click('#show-code')]);

    await page.click('#show-code');
    const answered = page.waitForResponse(/pair\/code/);
    release();
    await (await answered).finished();
    await nextState(page);

    assert.equal(await page.locator('#token svg').count(), 0);
    assert.equal(gateway.posts.length, 1);
  });
});

describe('a gateway that does not respond', () => {
  it('is reported once and its data are marked as stale until it responds', async () => {
    const page = await open({ hasVirtualTime: true });
    // The page waits 4 s for a response.
    const failure = () => Promise.all([page.waitForEvent('requestfailed'), page.clock.runFor(5000)]);

    gateway.isSilent = true;
    await failure();
    await becomes(page, '#trouble', operationsMessages.noNewState(gatewayReasons.noAnswer, ''));
    assert.ok(await page.locator('#content.stale').count());
    assert.ok(await weakestText(page) > 4.5, 'stale data are readable');
    await page.evaluate(() => {
      window.changes = 0;
      const watch = new MutationObserver(() => window.changes++);
      watch.observe(document.querySelector('#trouble'), { childList: true, characterData: true, subtree: true });
    });
    // The page has processed the first two failures when the third request fails.
    for (let i = 0; i < 3; i++) await failure();
    assert.equal(await page.evaluate(() => window.changes), 0, 'repeated announcements of the live region');

    gateway.isSilent = false;
    await page.waitForFunction(() => document.querySelector('#trouble').textContent === '');
    assert.equal(await page.locator('#content.stale').count(), 0);
  });
});

describe('accessibility in any window', () => {
  withGraphics();

  it('reaches every control with the keyboard and shows the focus', async () => {
    const page = await open({ reducedMotion: 'reduce' });
    const wanted = await page.evaluate(() => [...document.querySelectorAll('a, button, input, [tabindex="0"]')]
      .filter(e => e.checkVisibility() && !e.disabled && !(e.type === 'radio' && !e.checked)).length);

    const reached = new Set();
    for (let i = 0; i < wanted; i++) {
      await page.keyboard.press('Tab');
      const { id, outlined } = await page.evaluate(() => {
        const e = document.activeElement;
        return { id: [...document.querySelectorAll('*')].indexOf(e), outlined: parseFloat(getComputedStyle(e).outlineWidth) >= 2 };
      });
      assert.ok(outlined, 'the focus is outlined');
      reached.add(id);
    }
    assert.ok(wanted > 15, `${wanted} controls`);
    assert.equal(reached.size, wanted);
  });

  it('has a name for each control and region, and one top heading', async () => {
    const page = await open();

    const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, [tabindex="0"], section, table')].filter(e => {
      const labels = [e.getAttribute('aria-label'), e.textContent, e.labels?.[0]?.textContent, e.caption?.textContent,
        document.getElementById(e.getAttribute('aria-labelledby'))?.textContent];
      return e.checkVisibility() && !labels.some(label => label?.trim());
    }).map(e => e.outerHTML.slice(0, 80)));

    assert.deepEqual(nameless, []);
    assert.equal(await page.locator('h1').count(), 1);
    const live = await page.locator('[role="status"], [aria-live]').evaluateAll(all => all.map(e => e.id));
    assert.deepEqual(live, ['condition', 'trouble', 'record-done']);
  });

  it('has no landmark with the same name twice, and the terms in a landmark', async () => {
    const page = await open();

    assert.deepEqual(await repeatedLandmarks(page), []);
    assert.equal(await page.locator('footer .terms').count(), 1);
  });

  it('reports changes of counts to no screen reader while all is well', async () => {
    const page = await open();
    await becomes(page, '#status', 'OK');
    await page.evaluate(() => {
      window.changes = [];
      const condition = document.querySelector('#condition');
      const watch = new MutationObserver(() => window.changes.push(condition.textContent));
      watch.observe(condition, { childList: true, characterData: true, subtree: true });
    });

    gateway.state.status = { level: 'ok', text: '4 joints live, 1 at rest, 2 headsets' };
    await becomes(page, '#status', '4 joints live, 1 at rest');
    assert.deepEqual(await page.evaluate(() => window.changes), []);
    gateway.state.status = { level: 'error', text: 'the plant is gone' };
    await becomes(page, '#status', 'the plant is gone');

    assert.deepEqual(await page.evaluate(() => window.changes), ['Fault: the plant is gone']);
  });

  it('fits a window of any size', async () => {
    const page = await open();
    await showsToolError(page);
    await page.waitForFunction(() => document.querySelectorAll('.plot canvas').length === 4);

    for (const [width, height] of [[1280, 720], [390, 844], [320, 640]]) {
      await page.setViewportSize({ width, height });
      await settled(page);
      const [content, stage] = [await page.evaluate(() => document.documentElement.scrollWidth), await page.locator('.stage').boundingBox()];
      assert.ok(content <= width && stage.x >= 0 && stage.x + stage.width <= width, `${width} × ${height}: ${content} px, view ${JSON.stringify(stage)}`);
    }
  });

  it('shows all columns of headsets and latencies without scrolling in half a window', async () => {
    const page = await open({ viewport: { width: 800, height: 900 } });

    for (const [table, last] of [['Headsets', 'Error reduction'], ['Latency by hop', 'total']]) {
      const outer = await page.locator(`[aria-label="${table} table"]`).boundingBox();
      const inner = await page.locator(`[aria-label="${table} table"] th:has-text("${last}")`).boundingBox();
      assert.ok(inner.x + inner.width <= outer.x + outer.width + 1, `${last}: ${inner.x + inner.width} beyond ${outer.x + outer.width}`);
    }
  });

  it('follows the system\'s light or dark scheme, readable in both', async () => {
    const page = await open();
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme });
      const [ink, muted, surface, accent] = await luminance(page, ['--ink', '--muted', '--surface', '--accent']);
      assert.ok(contrast(ink, surface) > 7 && contrast(muted, surface) > 4.5 && contrast(accent, surface) > 4.5, colorScheme);
      const hops = await luminance(page, ['plant', 'gateway', 'network', 'queue', 'render', 'display'].map(hop => `--hop-${hop}`));
      for (let i = 1; i < hops.length; i++) assert.ok(contrast(hops[i - 1], hops[i]) > 1.5, `${colorScheme}: hops ${i - 1} and ${i}`);
    }
  });

  it('keeps the colours of bars and legends in a contrast theme', async () => {
    const page = await open();

    const [normal, forced] = await coloursInThemes(page, '.hop');

    assert.ok(new Set(normal).size > 7);
    assert.deepEqual(forced, normal);
  });

  it('redraws only once a second with reduced motion', async () => {
    const page = await open({ hasVirtualTime: true });
    const frames = async reducedMotion => {
      await page.emulateMedia({ reducedMotion });
      await page.reload();
      await showsToolError(page);
      await page.locator('.stage').scrollIntoViewIfNeeded();
      await page.evaluate(() => {
        window.clears = 0;
        const { clear } = WebGL2RenderingContext.prototype;
        WebGL2RenderingContext.prototype.clear = function (...all) { window.clears++; return clear.apply(this, all); };
      });
      await page.waitForFunction(() => window.clears > 0 && ((window.clears = 0), true));
      await page.clock.runFor(2000);
      return page.evaluate(() => window.clears);
    };

    const [calm, moving] = [await frames('reduce'), await frames('no-preference')];
    // Counts how often the canvas is cleared within two seconds: twice per frame. Without reduced motion, even a busy machine draws more frames.
    assert.ok(calm >= 1 && calm <= 8 && moving > calm, `${calm} against ${moving} clears`);
  });

  it('contains the licences of its libraries and loads nothing from other servers', () => {
    const html = readFileSync(new URL('../../dist/operations.html', import.meta.url), 'utf8');
    for (const words of ['three.js authors', 'Leon Sorokin', 'Kazuhiko Arase', 'California Institute of Technology', 'Apache License']) assert.match(html, new RegExp(words));
    assert.doesNotMatch(html.split('<script>')[0], /(src|href)="(?!data:)/);
    assert.ok(html.length < 1_000_000, `${html.length} bytes`);
  });
});

// Tests the plots of the operations page.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../drawn.mjs';
import { hasInk } from '../inks.mjs';
import { becomes, gateway, nextState, open } from './page.mjs';

describe('the plots of the last two minutes', () => {
  it('show the chosen headset and the plant', async () => {
    const page = await open();
    await page.waitForFunction(() => document.querySelectorAll('.plot canvas').length === 4);
    await becomes(page, '#plots', '82');

    // With one source, the fastest and the slowest are the same, and the slowest is drawn on top.
    for (const [i, ink] of ['--compensated', '--compensated', '--compensated', '--hold'].entries()) assert.ok(await drawn(() => hasInk(page, i, ink), Boolean), `plot ${i}`);
    const [, second] = await page.locator('#plots .legend').allInnerTexts();
    assert.match(second, /410\s*µs[^]*120\s*µs/);
  });

  it('are drawn if the browser reports an invalid language', async () => {
    const page = await open();
    await page.addInitScript(() => Object.defineProperty(navigator, 'language', { value: 'C' }));

    await page.reload();

    await becomes(page, '#plots', '82');
    assert.deepEqual(page.complaints, []);
  });

  const pauses = {
    // A browser runs the timers of a page in the background rarely.
    'in the background': page => page.clock.fastForward(60_000),
    // Does not change performance.now().
    'in which the computer sleeps': async page => page.clock.setSystemTime(await page.evaluate(() => Date.now() + 60_000)),
  };
  for (const [name, pause] of Object.entries(pauses))
    it(`do not connect the points before and after a time ${name}`, async () => {
      const page = await open({ hasVirtualTime: true });
      await becomes(page, '#plots', '82');

      await pause(page);
      await nextState(page);
      const plot = page.locator('#plots .u-over').first(), { width, height } = await plot.boundingBox();
      await plot.hover({ position: { x: 0.75 * width, y: height / 2 } });

      assert.match(await page.locator('#plots .legend .position').first().innerText(), /[23]\d/);
      assert.deepEqual(await page.locator('#plots .legend').first().locator('.value').allInnerTexts(), ['–', '–', '–']);
    });

  it('begin again if the clock of the browser is set back', async () => {
    const page = await open({ hasVirtualTime: true });
    await becomes(page, '#plots', '82');
    // A response of before the change of the clock can arrive after it.
    gateway.state.headsets[0].l_app_ms = 85;
    await becomes(page, '#plots', '85');

    await page.clock.setSystemTime(await page.evaluate(() => Date.now() - 3_600_000));
    gateway.state.headsets[0].l_app_ms = 86;
    await becomes(page, '#plots', '86');

    const plot = page.locator('#plots .u-over').first(), { width, height } = await plot.boundingBox();
    await plot.hover({ position: { x: 1, y: height / 2 } });
    assert.match(await page.locator('#plots .legend').first().innerText(), /8[56]/);
  });

  it('have no points of a headset that is silent', async () => {
    const page = await open();
    await becomes(page, '#plots', '82');

    gateway.state.headsets[0].seen_s_ago = 3.5;
    await nextState(page);

    assert.deepEqual(await page.locator('#plots .legend').first().locator('.value').allInnerTexts(), ['–', '–', '–']);
  });

  it('have the current values at a cursor that does not move', async () => {
    const page = await open();
    await becomes(page, '#plots', '82');
    const plot = page.locator('#plots .u-over').first(), { width, height } = await plot.boundingBox();
    await plot.hover({ position: { x: width - 1, y: height / 2 } });

    // A value within the range of the vertical axis. A change of the range would move the cursor.
    gateway.state.headsets[0].l_app_ms = 61;

    await becomes(page, '#plots .legend', '61');
    assert.match(await page.locator('#plots .legend .position').first().innerText(), /\d/);
  });

  it('fit the vertical axis to new values while they are zoomed', async () => {
    const page = await open();
    await becomes(page, '#plots', '82');
    await page.evaluate(() => {
      window.ticks = new Set();
      const { fillText } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.fillText = function (text, ...at) { window.ticks.add(text); return fillText.call(this, text, ...at); };
    });
    const plot = page.locator('#plots .plot').first(), { width, height } = await plot.locator('.u-over').boundingBox();
    await plot.locator('.u-over').hover({ position: { x: width - 1, y: height / 2 } });
    await plot.press('+');

    gateway.state.headsets[0].l_app_ms = 7000;

    await page.waitForFunction(() => window.ticks.has('6000'));
  });
});

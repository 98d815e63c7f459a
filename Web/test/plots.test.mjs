// Tests ranges, cursors, zoom and legends of the report's plots.
import assert from 'node:assert/strict';
import { before, describe, it } from 'node:test';
import { hasInk, heightOf, settled, shot } from './inks.mjs';
import { messages } from './messages.mjs';
import { opener } from './pages.mjs';
import { report } from './sample.mjs';

const open = opener('report');

const text = (page, selector) => page.locator(selector).allInnerTexts();
const plain = words => words.map(w => w.replaceAll('\u00ad', '').replaceAll('\u00a0', ' '));

describe('the range of a plot', () => {
  const seconds = Array.from({ length: 200 }, (_, i) => i / 5);
  const clock = (first, error, bound) => ({
    t: seconds, offset_us: seconds.map(() => 0), error_us: seconds.map(t => (t < 2 ? first : error)), bound_us: seconds.map(() => bound),
  });

  for (const [first, error, bound, height] of [[150, 150, 6000, 0.575], [-5000, 150, 6000, 0.575], [0, 3000, 9000, 0.833]]) {
    it(`covers the settled clock error (${first}, then ${error} µs within ${bound} µs)`, async () => {
      const page = await open({ clock: clock(first, error, bound) });

      assert.ok(Math.abs(await heightOf(page, 1, '--compensated') - height) < 0.02, `at ${await heightOf(page, 1, '--compensated')}`);
      assert.match(plain(await text(page, '#clock .claim'))[0], new RegExp(`\\b${bound} µs\\.`));
    });
  }

  it('covers the uncompensated operating points', async () => {
    const points = Array.from({ length: 100 }, (_, i) => i);
    const speed = points.map(i => 10 + 3 * i);
    const hold = { latency_ms: points.map(i => (i < 96 ? 100 + i : 2100)), speed };
    const compensated = { latency_ms: points.map(i => (i < 70 ? 5 : 3000)), speed };
    const page = await open({ field: { hold, compensated, iso_mm: [10] } });
    const box = await page.locator('#field .u-over').boundingBox();

    await page.locator('#field .u-over').hover({ position: { x: box.width - 1, y: box.height / 2 } });

    const [, latency] = plain(await text(page, '#field .position'))[0].match(/^([\d.]+) ms/);
    assert.ok(latency > 200 && latency < 220, `${latency} ms`);
    assert.ok((await text(page, '#field .claim'))[0].includes(messages.reportMessages.pointsBeyond(34)));
  });
});

describe('using a plot', () => {
  // A test that changes this page restores it.
  let page;
  before(async () => { page = await open(report()); });

  it('reads values at the cursor', async () => {
    const data = report();
    data.error = { t: [0, 1, 2, 3, 4], hold: [10, 10, 10, 10, 10], compensated: [1, 1, 1, 1, 1] };
    const page = await open(data);

    await page.locator('#error .u-over').hover();

    assert.match((await text(page, '#error .position'))[0], /^t = 2\.0\d\d s$|^t = 1\.9\d\d s$/);
    assert.deepEqual(plain(await text(page, '#error .value')), ['10 mm', '1 mm']);
  });

  it('shows latency, speed and their product at the pointer in the error field', async () => {
    await page.locator('#field .u-over').hover();

    const [, latency, speed, error] = plain(await text(page, '#field .position'))[0].match(/^([\d.]+) ms × ([\d.]+) mm\/s = ([\d.]+) mm$/);
    assert.ok(Math.abs(latency * speed / 1000 / error - 1) < 0.02);
  });

  for (const [name, index, section] of [['time', 0, '#error'], ['field', 2, '#field'], ['histogram', 5, '#latency']]) {
    it(`zooms by drag and resets by double-click (${name})`, async () => {
      const before = await shot(page, index);
      const over = page.locator(`${section} .u-over`);
      await over.scrollIntoViewIfNeeded();
      const box = await over.boundingBox();

      await page.mouse.move(box.x + box.width * 0.3, box.y + box.height * 0.2);
      await page.mouse.down();
      await page.mouse.move(box.x + box.width * 0.6, box.y + box.height * 0.8, { steps: 4 });
      await page.mouse.up();
      await settled(page);
      const zoomed = await shot(page, index);
      await over.dblclick();
      await settled(page);

      assert.notEqual(zoomed, before);
      assert.equal(await shot(page, index), before);
      assert.deepEqual(page.complaints, []);
    });
  }

  it('zooms and resets with the keyboard', async () => {
    for (const [index, section] of ['#error', '#joint', '#field', '#clock', '#latency'].entries()) {
      const plot = page.locator(`${section} .plot`).first();
      const picture = () => plot.locator('canvas').evaluate(c => c.toDataURL());
      const before = await picture();

      await plot.focus();
      await page.keyboard.press('+');
      await settled(page);
      const zoomed = await picture();
      await page.keyboard.press('0');
      await settled(page);

      assert.notEqual(zoomed, before, `${section} (${index})`);
      assert.equal(await picture(), before, section);
    }
  });

  it('moves the cursor with the arrow keys', async () => {
    await page.locator('#error .plot').focus();
    await page.keyboard.press('ArrowRight');
    const [first] = await text(page, '#error .position');
    await page.keyboard.press('Shift+ArrowRight');

    assert.match(first, /^t = \d/);
    assert.notEqual((await text(page, '#error .position'))[0], first);
  });

  it('switches signals off and on in the legend', async () => {
    for (const [index, section, ink] of [[0, '#error', '--hold'], [2, '#field', '--hold']]) {
      const key = page.locator(`${section} .legend button`).first();

      await key.click();
      await settled(page);
      assert.equal(await key.getAttribute('aria-pressed'), 'false');
      assert.equal(await hasInk(page, index, ink), false, section);
      await key.click();
      await settled(page);
      assert.equal(await hasInk(page, index, ink), true, section);
    }
  });

  it('reaches every control with the keyboard and shows the focus', async () => {
    const page = await open(report());
    const wanted = await page.evaluate(() => document.querySelectorAll('a, button, summary, [tabindex="0"]').length
      - document.querySelectorAll('details:not([open]) [tabindex="0"]').length);

    const reached = new Set();
    for (let i = 0; i < wanted; i++) {
      await page.keyboard.press('Tab');
      const { id, outlined } = await page.evaluate(() => {
        const all = [...document.querySelectorAll('*')], e = document.activeElement;
        return { id: all.indexOf(e), outlined: parseFloat(getComputedStyle(e).outlineWidth) >= 2 };
      });
      assert.ok(outlined, 'the focus is outlined');
      reached.add(id);
    }

    assert.ok(wanted > 20);
    assert.equal(reached.size, wanted);
  });

});

describe('a plot of an hour with 60 frames a second', () => {
  const data = report({ seconds: 3600 });
  let page;
  before(async () => { page = await open(data); });

  it('is drawn at the resolution of its width, with each step of the samples', async () => {
    const arrived = data.joint.received.t.length;

    for (const [section, stepped] of [['#error', 0], ['#joint', arrived], ['#field', 0]]) {
      const { steps, width } = await page.evaluate(async section => {
        const plot = document.querySelector(`${section} .plot`), { prototype } = Path2D, drawn = { steps: 0, width: plot.clientWidth };
        for (const step of ['moveTo', 'lineTo', 'rect', 'arc']) {
          const { [step]: draw } = prototype;
          prototype[step] = function (...all) { drawn.steps++; return draw.apply(this, all); };
        }
        plot.dispatchEvent(new KeyboardEvent('keydown', { key: '+', bubbles: true }));
        plot.dispatchEvent(new KeyboardEvent('keydown', { key: '0', bubbles: true }));
        await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
        return drawn;
      }, section);
      assert.ok(steps > width / 4 + stepped, `${section}: ${steps} steps of ${width} pixels`);
      // Each signal is drawn twice. A step goes to the right, then up or down.
      assert.ok(steps < 20 * width + 4 * stepped, `${section}: ${steps} steps of ${width} pixels`);
    }
    assert.deepEqual(page.complaints, []);
  });

  it('has at most one operating point per pixel and path', async () => {
    const squares = await page.evaluate(async () => {
      const { rect } = Path2D.prototype, plot = document.querySelector('#field .plot'), drawn = [];
      Path2D.prototype.rect = function (...place) { drawn.push(place.join()); rect.apply(this, place); };
      plot.dispatchEvent(new KeyboardEvent('keydown', { key: '0', bubbles: true }));
      plot.dispatchEvent(new KeyboardEvent('keydown', { key: '+', bubbles: true }));
      await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
      return { count: drawn.length, places: new Set(drawn).size };
    });

    assert.ok(squares.places > 100, `${squares.places} places`);
    // Each of the two paths draws its own squares.
    assert.ok(squares.count <= 2 * squares.places, `${squares.count} squares at ${squares.places} places`);
  });
});

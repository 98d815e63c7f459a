import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { Browser } from './browser.mjs';
import { contrast, hasInk, luminance, settled } from './inks.mjs';
import { figures } from './figuresSample.mjs';
import { report } from './sample.mjs';

const HOSTILE = '</script><script>alert(1)</script><img src=x onerror=alert(2)>&lt;b&gt;"\'';
const PLOTS = 6;

let browser;
before(async () => { browser = await Browser.start(); });
after(() => browser.stop());

const text = (page, selector) => page.locator(selector).allInnerTexts();
const plain = words => words.map(w => w.replaceAll('\u00ad', '').replaceAll('\u00a0', ' '));

/** Number of painted pixels and of colours in the canvas of each plot. */
const painted = page => page.evaluate(() => [...document.querySelectorAll('.plot canvas')].map(canvas => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const colours = new Set();
  let pixels = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 128) continue;
    pixels++;
    colours.add(`${data[i] >> 5},${data[i + 1] >> 5},${data[i + 2] >> 5}`);
  }
  return { pixels, colours: colours.size };
}));

/** Median height of a plot's signal, from 0 at the bottom of the plot area to 1 at its top. */
const heightOf = (page, index, ink) => page.evaluate(([index, ink]) => {
  const plot = document.querySelectorAll('.plot')[index], canvas = plot.querySelector('canvas');
  const over = plot.querySelector('.u-over').getBoundingClientRect(), top = over.top - canvas.getBoundingClientRect().top;
  const want = getComputedStyle(document.documentElement).getPropertyValue(ink).trim().match(/\w\w/g).map(h => parseInt(h, 16));
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const rows = [];
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 200 || !want.every((w, c) => Math.abs(data[i + c] - w) < 12)) continue;
    rows.push(Math.floor(i / 4 / canvas.width) + 0.5 - top);
  }
  return 1 - rows[rows.length >> 1] / over.height;
}, [index, ink]);

/** Share of the render time plot's column, at a time within the 10 s shown, that has the alarm's shade. */
const shadedShare = (page, time) => page.evaluate(time => {
  const plot = document.querySelector('#range .plot'), canvas = plot.querySelector('canvas');
  const over = plot.querySelector('.u-over').getBoundingClientRect(), left = over.left - canvas.getBoundingClientRect().left;
  const { data } = canvas.getContext('2d').getImageData(Math.round((left + (over.width * time) / 10) * devicePixelRatio), 0, 1, canvas.height);
  let shaded = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 20 && data[i] > data[i + 2] + 80) shaded++;
  return shaded / canvas.height;
}, time);

const shot = (page, index) => page.evaluate(i => document.querySelectorAll('.plot canvas')[i].toDataURL(), index);

describe('a complete report', () => {
  it('opens without an error or a request', async () => {
    const page = await browser.open(report());

    assert.deepEqual(page.complaints, []);
  });

  it('has its headings in order', async () => {
    const page = await browser.open(report());

    assert.deepEqual(await text(page, 'h1'), ['Nowpose: youBot over WiFi']);
    assert.equal(await page.title(), 'Nowpose: youBot over WiFi');
    assert.deepEqual(await text(page, 'h2'), ['Result', 'Tool error over time', 'Joint position: arm_joint_1', 'Error field',
      'Clock synchronisation', 'Application latency of the samples', 'Conditions and figures']);
  });

  it('shows the reduction, the table and the error plot on the first screen', async () => {
    const data = report();
    data.summary[0] = { label: 'Tool error, RMS', unit: 'mm', uncompensated: 20, compensated: 3.5 };
    const page = await browser.open(data);

    assert.match(plain(await text(page, '.headline'))[0], /^82\.5 %\s+less tool error with compensation\s+Tool error, RMS: 20 mm → 3\.50 mm$/);
    for (const selector of ['.headline', '.overview table', '#error .plot']) {
      const box = await page.locator(selector).boundingBox();
      assert.ok(box.y + box.height <= 800, `${selector} ends at ${box.y + box.height} px`);
    }
  });

  it('reports an increased error', async () => {
    const page = await browser.open({ summary: [{ label: 'RMS', unit: 'mm', uncompensated: 4, compensated: 5 }] });

    assert.match(plain(await text(page, '.headline'))[0], /^25 %\s+more tool error/);
    assert.deepEqual(plain(await text(page, '.overview tbody td')), ['4', '5', '+25 %']);
  });

  it('has captions and header cells on each table', async () => {
    const page = await browser.open(report());

    const faults = await page.evaluate(() => [...document.querySelectorAll('table')]
      .filter(t => !t.caption?.textContent || !t.querySelector('thead th[scope=col]') || !t.querySelector('tbody th[scope=row]'))
      .map(t => t.outerHTML));
    assert.deepEqual(faults, []);
    assert.deepEqual(plain(await text(page, '.overview thead th')), ['Quantity', 'Uncompensated', 'Compensated', 'Change']);
    assert.ok((await text(page, '#facts tbody tr')).includes('total latency error P95\t–'), 'a fact without value is a dash');
  });

  it('names the unit of each table of numbers', async () => {
    const page = await browser.open(report());

    const captions = await page.locator('details caption').allTextContents();
    assert.deepEqual(captions, ['Tool error (mm)', 'Joint position (rad)', 'Latency of the operating points (ms)', 'Clock (µs)',
      'Samples by latency']);
  });

  it('draws each plot in the colours of its signals', async () => {
    const page = await browser.open(report());

    const plots = await painted(page);
    assert.equal(plots.length, PLOTS);
    for (const { pixels, colours } of plots) assert.ok(pixels > 2000 && colours > 2, `${pixels} pixels, ${colours} colours`);
    const inks = [['--hold', '--compensated'], ['--truth', '--hold', '--compensated'], ['--hold', '--compensated'],
      ['--compensated'], ['--compensated'], ['--compensated']];
    for (const [i, wanted] of inks.entries()) {
      for (const ink of wanted) assert.ok(await hasInk(page, i, ink), `plot ${i} has no ${ink}`);
    }
  });

  it('describes each plot and its claim in words, with the paper as source', async () => {
    const page = await browser.open(report());

    const words = await page.evaluate(() => [...document.querySelectorAll('.plot')].map(p => p.getAttribute('aria-label')));
    assert.equal(words.length, PLOTS);
    for (const w of words) assert.match(w, /\d/);
    const sources = await page.locator('.claim a').evaluateAll(links => links.map(a => [a.href, a.textContent]));
    assert.deepEqual(sources.map(s => s[1].replace('Schnierle & Röck 2022, ', '')), ['Sect. 3', 'Fig. 16', 'Fig. 18', 'Fig. 8', 'Eq. 2']);
    assert.ok(sources.every(s => s[0] === 'https://doi.org/10.1007/s11740-022-01175-2'));
  });
});

describe('a report of a run with a load', () => {
  const t = Array.from({ length: 600 }, (_, i) => i / 60);
  const isLoaded = s => s >= 4 && s < 7;
  const range = { t, render_ms: t.map(s => (isLoaded(s) ? 17 : 4)), visu_ms: t.map(s => (isLoaded(s) ? 57 : 40)), limit_ms: 15, alarms: [[4.1, 7.5]] };

  it('shows both plots with the limit, shades the alarm and states its time', async () => {
    const page = await browser.open({ ...report(), range });

    assert.deepEqual(page.complaints, []);
    assert.equal(await page.locator('#range .plot canvas').count(), 2);
    const words = await page.locator('#range .plot').first().getAttribute('aria-label');
    assert.match(words, /render time: 4 to 17.ms.*limit: 15 to 15.ms.*Alarm from 4\.10 to 7\.50.s\./);
    assert.ok(await shadedShare(page, 5.5) > 0.5, 'during the alarm');
    assert.ok(await shadedShare(page, 2) < 0.1, 'before the alarm, only the line of the limit');
  });

  it('states that there was no alarm', async () => {
    const page = await browser.open({ ...report(), range: { ...range, alarms: [] } });

    assert.match(await page.locator('#range .plot').first().getAttribute('aria-label'), /No alarm\./);
    assert.ok(await shadedShare(page, 5.5) < 0.1);
  });
});

describe('the range of a plot', () => {
  const seconds = Array.from({ length: 200 }, (_, i) => i / 5);
  const clock = (first, error, bound) => ({
    t: seconds, offset_us: seconds.map(() => 0), error_us: seconds.map(t => (t < 2 ? first : error)), bound_us: seconds.map(() => bound),
  });

  for (const [first, error, bound, height] of [[150, 150, 6000, 0.575], [-5000, 150, 6000, 0.575], [0, 3000, 9000, 0.833]]) {
    it(`covers the settled clock error (${first}, then ${error} µs within ${bound} µs)`, async () => {
      const page = await browser.open({ clock: clock(first, error, bound) });

      assert.ok(Math.abs(await heightOf(page, 1, '--compensated') - height) < 0.02, `at ${await heightOf(page, 1, '--compensated')}`);
      assert.match(plain(await text(page, '#clock .claim'))[0], new RegExp(`reaches ${bound} µs\\.`));
    });
  }

  it('covers the uncompensated operating points', async () => {
    const points = Array.from({ length: 100 }, (_, i) => i);
    const speed = points.map(i => 10 + 3 * i);
    const hold = { latency_ms: points.map(i => (i < 96 ? 100 + i : 2100)), speed };
    const compensated = { latency_ms: points.map(i => (i < 70 ? 5 : 3000)), speed };
    const page = await browser.open({ field: { hold, compensated, iso_mm: [10] } });
    const box = await page.locator('#field .u-over').boundingBox();

    await page.locator('#field .u-over').hover({ position: { x: box.width - 1, y: box.height / 2 } });

    const [, latency] = plain(await text(page, '#field .position'))[0].match(/^([\d.]+) ms/);
    assert.ok(latency > 200 && latency < 220, `${latency} ms`);
    assert.match(plain(await text(page, '#field .claim'))[0], / 34 of the points lie beyond the plot\./);
  });
});

describe('using a plot', () => {
  it('reads values at the cursor', async () => {
    const data = report();
    data.error = { t: [0, 1, 2, 3, 4], hold: [10, 10, 10, 10, 10], compensated: [1, 1, 1, 1, 1] };
    const page = await browser.open(data);

    await page.locator('#error .u-over').hover();

    assert.match((await text(page, '#error .position'))[0], /^t = 2\.0\d\d s$|^t = 1\.9\d\d s$/);
    assert.deepEqual(plain(await text(page, '#error .value')), ['10 mm', '1 mm']);
  });

  it('reads latency, speed and their product in the error field', async () => {
    const page = await browser.open(report());

    await page.locator('#field .u-over').hover();

    const [, latency, speed, error] = plain(await text(page, '#field .position'))[0].match(/^([\d.]+) ms × ([\d.]+) mm\/s = ([\d.]+) mm$/);
    assert.ok(Math.abs(latency * speed / 1000 / error - 1) < 0.02);
  });

  for (const [name, index, section] of [['time', 0, '#error'], ['field', 2, '#field'], ['histogram', 5, '#latency']]) {
    it(`zooms by drag and resets by double-click (${name})`, async () => {
      const page = await browser.open(report());
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
    const page = await browser.open(report());
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
    const page = await browser.open(report());

    await page.locator('#error .plot').focus();
    await page.keyboard.press('ArrowRight');
    const [first] = await text(page, '#error .position');
    await page.keyboard.press('Shift+ArrowRight');

    assert.match(first, /^t = \d/);
    assert.notEqual((await text(page, '#error .position'))[0], first);
  });

  it('switches signals off and on in the legend', async () => {
    const page = await browser.open(report());
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

  it('reaches every control with the keyboard, visibly', async () => {
    const page = await browser.open(report());
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

  it('draws an hour of 60 frames a second at the resolution of its width, with each step of the samples', async () => {
    const data = report({ seconds: 3600 }), page = await browser.open(data);
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
      // Each signal is drawn twice; a step goes right, then up or down.
      assert.ok(steps < 20 * width + 4 * stepped, `${section}: ${steps} steps of ${width} pixels`);
    }
    assert.deepEqual(page.complaints, []);
  });

  it('draws at most one operating point per pixel and path', async () => {
    const page = await browser.open(report({ seconds: 600 }));

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

describe('missing measurements', () => {
  for (const [name, data] of [['absent', {}], ['null', { settings: null, summary: null, facts: null, error: null, joint: null,
    field: null, clock: null, latency: null }], ['empty', { settings: [], summary: [], facts: [], error: { t: [], hold: [], compensated: [] },
    joint: { name: 'a', unit: 'rad', truth: null, received: { t: [], v: [] } }, field: { hold: null, compensated: null, iso_mm: [] },
    clock: { t: [], offset_us: [], error_us: [], bound_us: [] }, latency: { bin_ms: [], count: [] } }]]) {
    it(`are stated in each section (${name})`, async () => {
      const page = await browser.open(data);

      assert.deepEqual(page.complaints, []);
      assert.equal(await page.locator('.plot').count(), 0);
      const words = await text(page, '.missing');
      assert.equal(words.length, 9);
      for (const w of words) assert.match(w, /not measured in this run\.$/i);
    });
  }

  it('of one signal do not affect the others', async () => {
    const data = report();
    data.joint.predicted = null;
    data.field.compensated = null;
    data.summary[0].compensated = null;
    const page = await browser.open(data);

    assert.deepEqual(page.complaints, []);
    assert.deepEqual(await text(page, '#joint .key'), ['ground truth', 'received']);
    assert.deepEqual(await text(page, '#field .key'), ['uncompensated', 'equal error']);
  });

  it('of single values are drawn as gaps', async () => {
    const data = report();
    data.error.compensated = data.error.compensated.map((v, i) => (i % 7 ? v : null));
    data.clock.error_us = data.clock.error_us.map(() => null);
    const page = await browser.open(data);

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
    const page = await browser.open(data);

    assert.deepEqual(page.complaints, []);
    assert.equal(await page.locator('img').count(), 0);
    assert.equal((await text(page, 'h1'))[0], HOSTILE);
    assert.equal((await text(page, '#facts td'))[0], HOSTILE);
  });

  for (const width of [320, 360, 768, 1920]) {
    it(`fits a window of ${width} px`, async () => {
      const page = await browser.open(report(), { viewport: { width, height: 800 } });

      const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(content <= window, `${content} px of content`);
      const outside = await page.evaluate(() => [...document.querySelectorAll('section button, .plot canvas')]
        .filter(e => e.getBoundingClientRect().right > e.closest('section').getBoundingClientRect().right).length);
      assert.equal(outside, 0);
    });
  }

  it('refits the plots when the window changes', async () => {
    const page = await browser.open(report());

    await page.setViewportSize({ width: 500, height: 800 });
    await settled(page);

    const widths = await page.evaluate(() => [...document.querySelectorAll('.plot')]
      .map(p => p.clientWidth - p.querySelector('canvas').getBoundingClientRect().width));
    assert.ok(widths.every(w => w >= 0 && w < 2), widths.join(', '));
  });

  it('uses light ink on dark and dark ink on light', async () => {
    const lightness = async colorScheme => {
      const page = await browser.open(report(), { colorScheme });
      assert.ok(await hasInk(page, 0, '--compensated'));
      return page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number)[0]);
    };

    assert.ok(await lightness('light') > 200);
    assert.ok(await lightness('dark') < 50);
  });

  it('repaints when the colour scheme changes', async () => {
    const page = await browser.open(report(), { colorScheme: 'light' });

    await page.emulateMedia({ colorScheme: 'dark' });
    await settled(page);

    assert.ok(await hasInk(page, 0, '--compensated'));
    assert.ok(await hasInk(page, 2, '--hold'));
  });

  it('distinguishes signals by lightness', async () => {
    for (const colorScheme of ['light', 'dark']) {
      const page = await browser.open(report(), { colorScheme });
      const [hold, compensated, truth, surface] = await luminance(page, ['--hold', '--compensated', '--truth', '--surface']);
      assert.ok(contrast(hold, compensated) > 1.7, `${colorScheme}: hold and compensated`);
      assert.ok(contrast(truth, compensated) > 3, `${colorScheme}: truth and compensated`);
      assert.ok(contrast(hold, surface) > 3 && contrast(compensated, surface) > 4.5, `${colorScheme}: on the page`);
    }
  });

  it('prints in the light scheme, with plots as wide as the page', async () => {
    const page = await browser.open(report(), { colorScheme: 'dark' });

    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await settled(page);
    const [surface, widths] = await page.evaluate(() => [getComputedStyle(document.documentElement).getPropertyValue('--surface').trim(),
      [...document.querySelectorAll('.plot canvas')].map(c => Math.round(c.getBoundingClientRect().width))]);
    assert.ok(await hasInk(page, 0, '--compensated'));
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));

    assert.equal(surface, '#ffffff');
    assert.ok(widths.every(w => w === 700), widths.join(', '));
  });
});

describe('a report of the paper’s scenario', () => {
  const ofPaper = () => ({
    ...report(),
    claims: [
      { figure: '8', claim: 'The fitting error is less than 1 ms.', paper: '1 ms', measured: '0.3 ms', holds: true },
      { figure: '16', claim: 'The signal follows.', paper: '', measured: '81 % ± 2 %', holds: false },
    ],
    figures: figures().figures.filter(f => f.number === '8' || f.number === '16'),
  });

  it('opens without an error and shows the paper’s figures in place of the demo’s sections', async () => {
    const page = await browser.open(ofPaper());

    assert.deepEqual(page.complaints, []);
    const headings = await text(page, 'h2');
    assert.ok(headings.includes('The paper’s claims and this run'));
    assert.ok(headings.some(h => h.startsWith('Fig. 8')) && headings.some(h => h.startsWith('Fig. 16')));
    assert.ok(!headings.includes('Clock synchronisation') && !headings.includes('Error field'));
  });

  it('shows each claim with both numbers and its verdict', async () => {
    const page = await browser.open(ofPaper());

    const rows = await page.locator('#claims tbody tr').evaluateAll(all => all.map(row => [...row.children].map(cell => cell.innerText)));
    assert.deepEqual(plain(rows[0]), ['Fig. 8', 'The fitting error is less than 1 ms.', '1 ms', '0.3 ms', 'holds']);
    assert.deepEqual(plain(rows[1]).slice(2), ['–', '81 % ± 2 %', 'does not hold']);
    await page.locator('#claims a').first().click();
    assert.match(page.url(), /#fig-8$/);
  });
});

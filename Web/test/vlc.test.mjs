// Tests the page with the control clock's code, served by the real gateway if it has been built, and by a substitute with a known clock.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { createInterface } from 'node:readline';
import { afterEach, describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { ClockGateway } from './clockGateway.mjs';
import { drawn } from './drawn.mjs';
import { explainedTerms } from './glossary.mjs';
import { messages } from './messages.mjs';
import { browserWith, closeLater } from './pages.mjs';
import { skipWithout } from './required.mjs';
import { load } from './vlcParts.mjs';

const path = relative => fileURLToPath(new URL(relative, import.meta.url));
const gateways = ['Debug', 'Release'].map(kind => path(`../../Gateway/bin/${kind}/net10.0/Nowpose.Gateway.dll`)).filter(existsSync);
const PERIOD = 65536;
const { clockCodeReasons, gatewayReasons } = messages;

const { controlCells } = await load('code');

/** Reads the canvas directly after the page has drawn a frame, like a camera, and requests the time in the same way as the page. */
const sight = page => page.evaluate(async () => {
  const times = [];
  for (let i = 0; i < 12; i++) {
    const t1 = performance.now();
    const response = await fetch('/vlc/time', { method: 'POST' });
    const t4 = performance.now();
    const { t2_ns: t2, t3_ns: t3 } = await response.json();
    times.push({ t1, t4, t2, t3 });
  }
  const canvas = document.getElementById('code');
  // On a busy machine, the page may need another exchange with a short round-trip time.
  for (let frame = 0; ; frame++) {
    const at = await new Promise(requestAnimationFrame);
    if (document.body.dataset.state !== 'synchronised' && frame < 600) continue;
    const size = canvas.width / 8, { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const cells = Array.from({ length: 64 }, (_, i) => {
      const x = Math.floor((i % 8 + 0.5) * size), y = Math.floor((Math.floor(i / 8) + 0.5) * size);
      return data[4 * (y * canvas.width + x)] > 128;
    });
    return { at, cells, times };
  }
});

const valueOf = cells => {
  const value = codes.indexOf(text(cells));
  return value < 0 ? null : value;
};
const text = cells => cells.map(Number).join('');
const codes = Array.from({ length: PERIOD }, (_, value) => text(controlCells(value)));

/** Returns the time of the code minus the clock's time at the start of the frame, ms, and the error bound of the fastest exchange. */
function errorOf({ at, cells, times }) {
  const value = valueOf(cells);
  assert.notEqual(value, null, 'the cells are not a code');
  const { t1, t2, t3, t4 } = times.reduce((a, b) => (b.t4 - b.t1 < a.t4 - a.t1 ? b : a));
  const base = BigInt(t2), processing = Number(BigInt(t3) - base) / 1e6;
  const expected = Number(base % BigInt(PERIOD * 1e6)) / 1e6 + processing / 2 + at - (t1 + t4) / 2;
  const error = value + 0.5 - expected;
  return { error: error - PERIOD * Math.round(error / PERIOD), bound: (t4 - t1 - processing) / 2 };
}

/** Asserts that the error is less than the sum of half a millisecond of rounding, the bound of the exchanges, and the page's tolerance. */
function assertRight(seen) {
  const { error, bound } = errorOf(seen);
  assert.ok(Math.abs(error) < 0.5 + bound + 3, `error ${error.toFixed(2)} ms, bound ${bound.toFixed(2)} ms`);
}

const synchronised = page => page.waitForSelector('body[data-state="synchronised"]', { timeout: 60_000 });
/** Presses the button after the warning about the flashing code, and waits until the page is synchronised. */
async function start(page) {
  await page.click('#show');
  await synchronised(page);
}
const unsynchronised = (page, why) => page.waitForFunction(
  why => document.body.dataset.state === 'not synchronised' && document.getElementById('code').hidden
    && document.getElementById('warning').textContent.includes(why), why, { timeout: 60_000 });

describe('the page of the control clock\'s code', () => {
  let gateway;
  afterEach(() => gateway?.stop());

  /** @param options See `Browser.newPage`. */
  async function open(address, options) {
    const page = closeLater(await (await browserWith()).newPage(new URL('/nothing', address).href, options));
    page.faults = [];
    page.on('pageerror', e => page.faults.push(e.message));
    await page.goto(address);
    return page;
  }

  it('explains terms of the glossary on hover', async () => {
    const page = await open(await (gateway = new ClockGateway()).start());

    assert.deepEqual(await explainedTerms(page), ['control clock']);
  });

  it('shows the control time of each frame', async () => {
    const page = await open(await (gateway = new ClockGateway()).start());
    await start(page);

    for (let i = 0; i < 3; i++) assertRight(await sight(page));

    assert.deepEqual(page.faults, []);
    // Reads both texts in the same frame: without an exchange for a while, as on a busy machine, the page shows neither.
    const [time, facts] = await (await page.waitForFunction(() => {
      const [time, facts] = ['time', 'facts'].map(id => document.getElementById(id).textContent);
      return /L_monitor ≈ \d+ ± \d+ ms/.test(facts) && [time, facts];
    })).jsonValue();
    assert.match(time, /^C1 17\d{8}\.\d{3} s$/);
    assert.match(facts, /± \d\.\d ms.*L_monitor/);
  });

  it('shows no code while the gateway is down, and the new time after its restart', async () => {
    const page = await open(await (gateway = new ClockGateway()).start());
    await start(page);

    gateway.stop();
    await unsynchronised(page, gatewayReasons.noAnswer);
    gateway.aheadNs += 12_345_000_000n;
    await gateway.start(gateway.port);
    await synchronised(page);

    assertRight(await sight(page));
  });

  it('shows no code while the control clock is not synchronised', async () => {
    gateway = Object.assign(new ClockGateway(), { isSynchronised: false });
    const page = await open(await gateway.start());

    await unsynchronised(page, clockCodeReasons.controlClock);
  });

  it('does not repeat the reason why it shows no code for screen readers', async () => {
    gateway = Object.assign(new ClockGateway(), { isSynchronised: false });
    const page = await open(await gateway.start());
    await unsynchronised(page, clockCodeReasons.controlClock);

    const changes = await page.evaluate(async () => {
      let count = 0;
      const watch = new MutationObserver(all => { count += all.length; });
      watch.observe(document.getElementById('warning'), { childList: true, characterData: true, subtree: true });
      for (let frame = 0; frame < 5; frame++) await new Promise(requestAnimationFrame);
      return count;
    });

    assert.equal(changes, 0);
  });

  it('asks for the gateway\'s token and does not keep it in address or storage', async () => {
    gateway = Object.assign(new ClockGateway(), { token: 'sesame' });
    const page = await open(await gateway.start(), { hasVirtualTime: true });
    await unsynchronised(page, gatewayReasons.tokenRequired);

    await page.fill('#token input', 'guess');
    await page.press('#token input', 'Enter');
    await unsynchronised(page, gatewayReasons.tokenRefused);
    // Longer than the interval between many exchanges.
    await page.clock.fastForward(5000);
    await unsynchronised(page, gatewayReasons.tokenRefused);

    await page.fill('#token input', 'sesame');
    await page.press('#token input', 'Enter');
    // The page is not synchronised quickly, because its substituted clock advances in steps.
    await page.waitForFunction(why => !document.getElementById('warning').textContent.includes(why), gatewayReasons.tokenRefused);
    assert.ok(gateway.accepted > 0);

    // The exchanges follow one another, so each one without the token would have been refused before.
    assert.equal(gateway.refused, 2);
    assert.equal(await page.locator('#token').isVisible(), false);
    const kept = await page.evaluate(() => [location.href, document.cookie, JSON.stringify({ ...localStorage, ...sessionStorage })].join());
    assert.ok(!kept.includes('sesame') && !(await page.content()).includes('sesame'));
  });

  it('shows the flashing code only after its warning was read and a button pressed', async () => {
    const page = await open(await (gateway = new ClockGateway()).start());
    await synchronised(page);

    const isVisible = () => Promise.all(['#code', '#start', '#hide'].map(id => page.locator(id).isVisible()));
    assert.deepEqual(await isVisible(), [false, true, false]);
    assert.match(await page.locator('#start').textContent(), /flashes.*sensitive to flashing light/);

    await page.keyboard.press('f');
    await page.mouse.click(5, 5);
    assert.deepEqual(await isVisible(), [false, true, false]);
    assert.equal(await page.evaluate(() => document.fullscreenElement), null, 'neither a letter nor a click beside the buttons has an effect');

    await page.click('#show');
    await page.waitForSelector('#code:not([hidden])');
    assert.deepEqual((await isVisible()).slice(1), [false, true]);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'hide');

    await page.keyboard.press('Enter');
    await page.waitForSelector('#code', { state: 'hidden' });
    assert.deepEqual(await isVisible(), [false, true, false]);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'show');
  });

  it('fills the screen with a readable code in any window', async () => {
    const page = await open(await (gateway = new ClockGateway()).start(), { viewport: { width: 500, height: 900 } });
    await start(page);

    await page.click('#full-screen');
    await page.waitForFunction(() => document.fullscreenElement != null);
    const isLargeSquare = box => box !== null && box.width > 300 && Math.abs(box.width - box.height) < 2;
    const box = await drawn(() => page.locator('#code').boundingBox(), isLargeSquare);

    assert.ok(isLargeSquare(box), JSON.stringify(box));
    assertRight(await sight(page));
  });

  it('keeps the screen on in full screen, also after the page was hidden', async () => {
    const page = await open(await (gateway = new ClockGateway()).start());
    await page.evaluate(() => {
      window.locks = 0;
      const request = async () => (window.locks++, { release: async () => void window.locks-- });
      Object.defineProperty(navigator, 'wakeLock', { value: { request } });
    });
    const locksBecome = count => page.waitForFunction(count => window.locks === count, count);

    await page.click('#full-screen');
    await locksBecome(1);
    // The browser ends the lock of a page that it hides.
    await page.evaluate(() => { window.locks = 0; document.dispatchEvent(new Event('visibilitychange')); });
    await locksBecome(1);
    await page.click('#full-screen');

    await locksBecome(0);
  });

  it('keeps the screen on after the browser has refused it once, and not after the end of full screen', async () => {
    const page = await open(await (gateway = new ClockGateway()).start());
    await page.evaluate(() => {
      [window.locks, window.answers] = [0, []];
      const request = () => new Promise((resolve, reject) => window.answers.push({
        accept: () => resolve((window.locks++, { release: async () => void window.locks-- })), refuse: () => reject(new Error('hidden')),
      }));
      Object.defineProperty(navigator, 'wakeLock', { value: { request } });
    });
    const asked = count => page.waitForFunction(count => window.answers.length === count, count);
    const isFull = value => page.waitForFunction(value => (document.fullscreenElement !== null) === value, value);

    await page.click('#full-screen');
    await asked(1);
    await page.evaluate(() => window.answers[0].refuse());
    await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
    await asked(2);
    await page.click('#full-screen');
    await isFull(false);
    await page.evaluate(() => window.answers[1].accept());

    await page.waitForFunction(() => window.locks === 0);
  });

  it('shows the control time in a browser without full screen and without a timeout for requests', async () => {
    const page = await open(await (gateway = new ClockGateway()).start());
    await page.addInitScript(() => {
      delete AbortSignal.timeout;
      delete Element.prototype.requestFullscreen;
    });
    await page.reload();
    await start(page);

    await page.click('#full-screen');

    assertRight(await sight(page));
    assert.deepEqual(page.faults, []);
  });

  it('is served by the gateway', { skip: skipWithout(gateways.length > 0, 'the gateway is not built: dotnet build Gateway') }, async () => {
    const clock = ['--clock-start-s', '5000', '--skew-ppm', '200'];
    const child = spawn('dotnet', [gateways[0], 'serve', '--ws-port', '0', '--sync-port', '0', ...clock]);
    try {
      const page = await open(await announced(child));
      await start(page);

      assertRight(await sight(page));
    } finally {
      child.kill('SIGKILL');
    }
  });

  async function announced(child) {
    for await (const line of createInterface(child.stdout)) if (line.startsWith('vlc ')) return line.slice(4);
    throw new Error('the gateway announced no page');
  }
});

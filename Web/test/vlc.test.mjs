// The page with the control clock's code, served by the real gateway where it was built, and by a stand-in whose clock is known.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createInterface } from 'node:readline';
import { after, afterEach, before, describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { Browser } from './browser.mjs';

const path = relative => fileURLToPath(new URL(relative, import.meta.url));
const html = readFileSync(path('../dist/vlc.html'));
const gateways = ['Debug', 'Release'].map(kind => path(`../../Gateway/bin/${kind}/net10.0/Nowpose.Gateway.dll`)).filter(existsSync);
const PERIOD = 65536;

const { outputFiles: [bundle] } = await build({ entryPoints: [path('../src/vlc/code.ts')], bundle: true, format: 'esm', write: false });
const { controlCells } = await import(`data:text/javascript;base64,${Buffer.from(bundle.text).toString('base64')}`);

/** A gateway whose control clock is this process's counter, far from zero. */
class StandIn {
  aheadNs = 1_700_000_000_000_000_000n;
  isSynchronised = true;
  token = null;
  resolution = 1n;

  now = () => (process.hrtime.bigint() + this.aheadNs) / this.resolution * this.resolution;

  async start(port = 0) {
    this.server = createServer((request, response) => this.answer(request, response));
    this.server.listen(port, '127.0.0.1');
    await once(this.server, 'listening');
    this.port = this.server.address().port;
    return `http://127.0.0.1:${this.port}/vlc`;
  }

  answer(request, response) {
    const t2 = this.now();
    if (request.url === '/vlc') return response.setHeader('Content-Type', 'text/html').end(html);
    if (request.method !== 'POST' || request.url !== '/vlc/time') return response.writeHead(404).end();
    if (this.token && request.headers.authorization !== `Bearer ${this.token}`) return response.writeHead(401).end();
    const facts = { resolution_ns: Number(this.resolution), is_synchronised: this.isSynchronised };
    response.end(JSON.stringify({ ...facts, t2_ns: `${t2}`, t3_ns: `${this.now()}` }));
  }

  stop() {
    this.server?.close();
    this.server?.closeAllConnections();
    this.server = null;
  }
}

/** Reads the canvas as a camera would, right after the page has drawn a frame, and asks for the time as the page does. */
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
  // On a busy machine the page may have to wait for a quick exchange again.
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
  for (let value = 0; value < PERIOD; value++) if (codes[value] === text(cells)) return value;
  return null;
};
const text = cells => cells.map(Number).join('');
const codes = Array.from({ length: PERIOD }, (_, value) => text(controlCells(value)));

/** What the code shows minus what the clock showed at the frame's begin, ms, and the bound that the quickest of the exchanges leaves. */
function errorOf({ at, cells, times }) {
  const value = valueOf(cells);
  assert.notEqual(value, null, 'the cells are no code');
  const { t1, t2, t3, t4 } = times.reduce((a, b) => (b.t4 - b.t1 < a.t4 - a.t1 ? b : a));
  const base = BigInt(t2), processing = Number(BigInt(t3) - base) / 1e6;
  const expected = Number(base % BigInt(PERIOD * 1e6)) / 1e6 + processing / 2 + at - (t1 + t4) / 2;
  const error = value + 0.5 - expected;
  return { error: error - PERIOD * Math.round(error / PERIOD), bound: (t4 - t1 - processing) / 2 };
}

/** Within half a millisecond for the cut to whole ones, what the exchanges leave open here, and what the page allows itself. */
function assertRight(seen) {
  const { error, bound } = errorOf(seen);
  assert.ok(Math.abs(error) < 0.5 + bound + 3, `${error.toFixed(2)} ms off, known to ${bound.toFixed(2)} ms`);
}

const synchronised = page => page.waitForSelector('body[data-state="synchronised"]', { timeout: 15_000 });
const unsynchronised = (page, why) => page.waitForFunction(
  why => document.body.dataset.state === 'not synchronised' && document.getElementById('code').hidden
    && document.getElementById('doubt').textContent.includes(why), why, { timeout: 15_000 });

describe('the page of the control clock\'s code', () => {
  let browser, gateway, pages;
  before(async () => { browser = await Browser.start('vlc'); });
  after(() => browser.stop());
  afterEach(async () => {
    await Promise.all(pages.map(page => page.context().close()));
    gateway?.stop();
  });

  async function open(address, options) {
    const page = await (await browser.browser.newContext({ viewport: { width: 1280, height: 800 }, ...options })).newPage();
    (pages = []).push(page);
    page.faults = [];
    page.on('pageerror', e => page.faults.push(e.message));
    await page.goto(address);
    return page;
  }

  it('draws the codes of the vector file', () => {
    const [, ...lines] = readFileSync(path('../../Packages/com.nowpose.mril/Documentation~/led-matrix/timestamp-codes.csv'), 'utf8').trim().split('\n');
    const controls = lines.map(line => line.split(',')).filter(([, kind]) => kind === 'control');

    assert.ok(controls.length > 100);
    for (const [value, , rows] of controls) {
      const bits = BigInt(`0x${rows}`).toString(2).padStart(64, '0');
      assert.equal(text(controlCells(Number(value))), bits, `${value} ms`);
    }
    pages = [];
  });

  it('shows the control time of each frame', async () => {
    const page = await open(await (gateway = new StandIn()).start());
    await synchronised(page);

    for (let i = 0; i < 3; i++) assertRight(await sight(page));

    assert.deepEqual(page.faults, []);
    await page.waitForFunction(() => /L_monitor ≈ \d+ ± \d+ ms/.test(document.getElementById('facts').textContent));
    assert.match(await page.locator('#time').textContent(), /^C1 17\d{8}\.\d{3} s$/);
    assert.match(await page.locator('#facts').textContent(), /known to ± \d\.\d ms.*L_monitor/);
  });

  it('adds half the step of a clock that counts whole milliseconds', async () => {
    gateway = Object.assign(new StandIn(), { resolution: 1_000_000n });
    const page = await open(await gateway.start());
    await synchronised(page);
    gateway.resolution = 1n;

    assertRight(await sight(page));
  });

  it('shows no code while the gateway is gone, and a right one when it is back with another time', async () => {
    const page = await open(await (gateway = new StandIn()).start());
    await synchronised(page);

    gateway.stop();
    await unsynchronised(page, 'the gateway does not answer');
    gateway.aheadNs += 12_345_000_000n;
    await gateway.start(gateway.port);
    await synchronised(page);

    assertRight(await sight(page));
  });

  it('begins anew when the control clock steps', async () => {
    const page = await open(await (gateway = new StandIn()).start());
    await synchronised(page);

    gateway.aheadNs += 20_000_000n;
    await unsynchronised(page, 'exchanges');
    await synchronised(page);

    assertRight(await sight(page));
  });

  it('shows no code of a control clock that is not synchronised itself', async () => {
    gateway = Object.assign(new StandIn(), { isSynchronised: false });
    const page = await open(await gateway.start());

    await unsynchronised(page, 'the control clock itself');
  });

  it('asks for the token that the gateway wants, and keeps it out of address and storage', async () => {
    gateway = Object.assign(new StandIn(), { token: 'sesame' });
    const page = await open(await gateway.start());
    await unsynchronised(page, 'asks for a token');

    await page.fill('#token input', 'sesame');
    await page.press('#token input', 'Enter');
    await synchronised(page);

    assert.equal(await page.locator('#token').isVisible(), false);
    const kept = await page.evaluate(() => [location.href, document.cookie, JSON.stringify({ ...localStorage, ...sessionStorage })].join());
    assert.ok(!kept.includes('sesame') && !(await page.content()).includes('sesame'));
  });

  it('fills the screen on F, large and readable, on any window', async () => {
    const page = await open(await (gateway = new StandIn()).start(), { viewport: { width: 500, height: 900 } });
    await synchronised(page);

    await page.keyboard.press('f');
    await page.waitForFunction(() => document.fullscreenElement != null);
    const box = await page.locator('#code').boundingBox();

    assert.ok(box.width > 300 && Math.abs(box.width - box.height) < 2, JSON.stringify(box));
    assertRight(await sight(page));
  });

  it('is served by the gateway', { skip: gateways.length === 0 && 'the gateway is not built' }, async () => {
    const serve = async port => {
      const clock = ['--clock-start-s', '5000', '--skew-ppm', '200'];
      const child = spawn('dotnet', [gateways[0], 'serve', '--ws-port', `${port}`, '--sync-port', '0', ...clock]);
      for await (const line of createInterface(child.stdout)) if (line.startsWith('vlc ')) return { child, address: line.slice(4) };
      throw new Error('the gateway announced no page');
    };
    let { child, address } = await serve(0);
    try {
      const page = await open(address);
      await synchronised(page);
      assertRight(await sight(page));

      child.kill('SIGKILL');
      await unsynchronised(page, 'the gateway does not answer');
      ({ child } = await serve(new URL(address).port));
      await synchronised(page);
      assertRight(await sight(page));
    } finally {
      child.kill('SIGKILL');
    }
  });
});

// Takes the manual's pictures of web pages, and writes the texts of the pages that the test compares. Run by `npm run pictures`.
// `npm run pictures -- --record` first replaces the stored data with the data of new runs of `demo` and `calibrate`.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { Browser, NO_WEBGL, WEBGL } from '../test/browser.mjs';
import { FakeGateway } from '../test/fakeGateway.mjs';
import { settled } from '../test/inks.mjs';
import { picture } from '../test/pixels.mjs';
import { openOperations, path, PICTURES, setState, stored, textsOf } from './screens.mjs';

/** Replaces the stored data with the data of new runs of `demo` and `calibrate vlc`. */
function record() {
  const folder = mkdtempSync(join(tmpdir(), 'nowpose-pictures-'));
  const stdio = ['ignore', 'inherit', 'inherit'];
  const run = (...words) => execFileSync('dotnet', ['run', '-c', 'Release', '--project', path('../../Cli'), '--', ...words], { stdio });
  const store = (name, page, change) => {
    const [, json] = /<script type="application\/json"[^>]*>([^]*?)<\/script>/.exec(readFileSync(join(folder, page), 'utf8'));
    writeFileSync(path(`${name}.json.gz`), gzipSync(JSON.stringify(change(JSON.parse(json))), { level: 9 }));
  };
  try {
    run('demo', '--seconds', '60', '--seed', '1', '--out', join(folder, 'demo'));
    run('calibrate', 'simulate', '--pictures', '240', '--out', join(folder, 'simulated'));
    run('calibrate', 'vlc', join(folder, 'simulated/pictures'), '--sweep', join(folder, 'simulated/sweep.csv'), '--out', join(folder, 'calibration'));
    store('demo', 'demo/report.html', thinned);
    // Removes the date, which the picture must not show.
    store('calibration', 'calibration/calibration.html', data => ({ ...data, facts: data.facts.filter(([label]) => label !== 'Evaluated') }));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** Reduces the report's data: keeps every tenth instant of the playback and its objects, and every fifth instant of the clock. */
function thinned({ playback, clock, ...rest }) {
  const every = (step, length, object) => Object.fromEntries(Object.entries(object).map(([key, value]) => {
    if (Array.isArray(value)) return [key, value.length === length ? value.filter((_, i) => i % step === 0) : value];
    return [key, typeof value === 'object' && value !== null ? every(step, length, value) : value];
  }));
  return { ...rest, clock: every(5, clock.t.length, clock), playback: every(10, playback.t.length, playback) };
}

/** Returns the instant with fast motion in the playback whose compensated error is closest to the RMS error of the run. */
function typicalInstant({ error: { t, hold, compensated }, playback, summary: [rms] }) {
  const nearest = at => t.reduce((best, time, i) => (Math.abs(time - at) < Math.abs(t[best] - at) ? i : best), 0);
  const distance = i => Math.abs(compensated[i] - rms.compensated), max = Math.max(...hold);
  const fast = playback.t.map(at => ({ at, i: nearest(at) })).filter(({ i }) => hold[i] > 0.6 * max);
  return fast.reduce((best, one) => (distance(one.i) < distance(best.i) ? one : best)).at;
}

/** Takes a picture of a page from the upper edge of one element to the lower edge of another. */
async function shoot(page, [first, last], file) {
  const margin = 12, { width } = page.viewportSize();
  const [{ y }, end] = [await page.locator(first).boundingBox(), await page.locator(last).boundingBox()];
  const top = Math.max(0, y - margin);
  await page.screenshot({ path: path(file), fullPage: true, clip: { x: 0, y: top, width, height: end.y + end.height + margin - top } });
}

async function draw(graphics, write) {
  const gateway = await FakeGateway.start();
  setState(gateway);
  const browser = await Browser.start(graphics);
  try {
    await write(browser, gateway);
  } finally {
    await browser.stop();
    await gateway.stop();
  }
}

async function drawPictures(browser, gateway) {
  const data = stored('demo'), report = await browser.open('report', data, { viewport: { width: 1160, height: 640 } });
  await shoot(report, ['header', '#error'], PICTURES.report.file);

  const slider = report.locator('#playback input[type=range]');
  await slider.fill(String(typicalInstant(data)));
  await slider.blur();
  await settled(report);
  await report.locator('#playback').screenshot({ path: path(PICTURES['virtual-cell'].file) });

  const calibration = await browser.open('calibration', stored('calibration'), { viewport: { width: 1160, height: 800 } });
  await shoot(calibration, ['header', 'section:has(#section-1)'], PICTURES.calibration.file);

  const operations = await openOperations(browser.browser, gateway, { width: 1280, height: 2560 });
  await shoot(operations, ['h1', 'section:has(#clock)'], PICTURES.operations.file);
  const seen = await picture(operations, operations.locator('#robot .stage'), ({ grey, orange }) => grey > 500 && orange > 200);
  if (seen.orange <= 200) throw new Error('operations: the page draws no robot; Chromium needs WebGL');
  // Waits until the robot moves fast, so that the poses differ visibly.
  await operations.waitForFunction(() => /about 2\d/.test(document.querySelector('.apart').textContent));
  await shoot(operations, ['section:has(> #headsets)', 'section:has(> #robot)'], PICTURES['operations-headsets'].file);
}

async function writeTexts(browser, gateway) {
  const texts = {
    report: await textsOf(await browser.open('report', stored('demo'))),
    calibration: await textsOf(await browser.open('calibration', stored('calibration'))),
    operations: await textsOf(await openOperations(browser.browser, gateway)),
  };
  writeFileSync(path('texts.json'), JSON.stringify(texts, null, 2) + '\n');
}

if (process.argv.includes('--record')) record();
await draw(WEBGL, drawPictures);
// Opens the pages without WebGL, like the test.
await draw(NO_WEBGL, writeTexts);

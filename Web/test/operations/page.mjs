// Shared by the tests of the operations page: Chromium and a fake gateway.
import { after, afterEach, before, beforeEach } from 'node:test';
import { NO_WEBGL, recordErrors, WEBGL } from '../browser.mjs';
import { FakeGateway } from '../fakeGateway.mjs';
import { messages } from '../messages.mjs';
import { browserWith, closeLater } from '../pages.mjs';

/** The gateway of the current test. */
export let gateway;
let hasFakeWebGl = false;

beforeEach(async () => { gateway = Object.assign(await FakeGateway.start(), { isPublishing: hasFakeWebGl }); });
afterEach(() => gateway.stop());

/** Runs the tests of the enclosing block with joint positions and a WebGL that draws nothing. The other tests run without both. */
export function withGraphics() {
  before(() => { hasFakeWebGl = true; });
  after(() => { hasFakeWebGl = false; });
}

/** Options for tests that look at pixels of the 3D view. A smaller window is drawn in less time. */
export const PICTURES = { reducedMotion: 'reduce', graphics: WEBGL, viewport: { width: 640, height: 720 } };

/**
 * @param options See `Browser.newPage`. With `graphics: WEBGL`, the 3D view is drawn.
 * @param isReady Whether to wait for the first response.
 */
export async function open({ viewport = { width: 1280, height: 720 }, graphics = NO_WEBGL, ...options } = {}, isReady = true) {
  const browser = await browserWith(graphics);
  const isFake = hasFakeWebGl && graphics === NO_WEBGL;
  const page = closeLater(await browser.newPage(new URL('/nothing', gateway.address).href, { viewport, hasFakeWebGl: isFake, ...options }));
  await page.context().clearCookies();
  page.setDefaultTimeout(60_000);
  recordErrors(page);
  const own = new URL(gateway.address).origin;
  page.on('request', r => !r.url().startsWith(own) && !r.url().startsWith('data:') && page.complaints.push(`request: ${r.url()}`));
  page.on('websocket', w => w.url() !== own.replace('http', 'ws') + '/' && page.complaints.push(`websocket: ${w.url()}`));
  await page.goto(gateway.address);
  if (isReady) await page.waitForFunction(() => document.querySelector('#clock').textContent !== '–');
  return page;
}

/** Waits until the page has shown a state that it requested after this call. */
export async function nextState(page, count = 3) {
  // The page sends a request only after it has shown the response to the previous one. The first request may have been sent before this call.
  for (let i = 0; i < count; i++) await page.waitForRequest(/\/state$/);
}

/** Returns the time some seconds ago as the gateway writes it. */
export const ago = seconds => new Date(Date.now() - 1000 * seconds).toISOString();

export const cells = (page, row) => page.locator(`tr:has(th:has-text("${row}"))`).first().locator('td').allInnerTexts();

export const becomes = (page, selector, part) => page.waitForFunction(
  ([selector, part]) => document.querySelector(selector)?.textContent.includes(part), [selector, part]);

/** Waits until the text below the robot contains a distance between the displayed and the true tool within the given range, in mm. */
export const showsToolError = (page, min = 0, max = Infinity) => {
  const [before, after] = messages.robotMessages.toolError('', 5, null).split(/5\.?0*.mm/);
  return page.waitForFunction(([before, after, min, max]) => {
    const mm = document.querySelector('.apart').textContent.split(before)[1]?.split(after.slice(0, -1))[0].match(/[\d.]+/)?.[0];
    return mm !== undefined && Number(mm) >= min && Number(mm) <= max;
  }, [before, after, min, max]);
};

/** Number of bodies drawn in the next picture of the 3D view: the draw calls of one frame. A frame begins with a clear and is drawn at once. */
export const bodiesDrawn = async page => {
  await page.locator('.stage').scrollIntoViewIfNeeded();
  return page.evaluate(() => new Promise(done => {
    // Tables that are filled later move the view out of the window, where it is not drawn. The key 0 requests a picture, because nothing else does
    // while no data change.
    const stage = document.querySelector('.stage');
    const keepsInView = setInterval(() => {
      stage.scrollIntoView({ block: 'nearest' });
      stage.dispatchEvent(new KeyboardEvent('keydown', { key: '0' }));
    }, 100);
    const gl = WebGL2RenderingContext.prototype, { clear, drawElements, drawArrays } = gl;
    let count = null;
    const counted = draw => function (...all) { if (count !== null) count++; return draw.apply(this, all); };
    gl.drawElements = counted(drawElements);
    gl.drawArrays = counted(drawArrays);
    gl.clear = function (...all) {
      if (count === null) queueMicrotask(end);
      count ??= 0;
      return clear.apply(this, all);
    };
    function end() {
      if (count === 0) return count = null;
      Object.assign(gl, { clear, drawElements, drawArrays });
      clearInterval(keepsInView);
      done(count);
    }
  }));
};

/** Opens a page that draws the robot only at its true pose, and counts the bodies. */
export async function openWithOneBody() {
  gateway.turned = null;
  delete gateway.state.headsets[0].l_app_ms;
  const page = await open({ reducedMotion: 'reduce' });
  await becomes(page, '.apart', messages.robotMessages.toolError('left door', null, null));
  return { page, alone: await bodiesDrawn(page) };
}

// Tests how users and screen readers use the pairing page, with a fake gateway.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, describe, it } from 'node:test';
import { drawn } from './drawn.mjs';
import { FakeGateway } from './fakeGateway.mjs';
import { messages } from './messages.mjs';
import { browserWith, closeLater } from './pages.mjs';

const { gatewayReasons, pairingMessages, pairingReasons } = messages;

describe('the pairing page', () => {
  let gateway, page;
  beforeEach(async () => {
    gateway = await FakeGateway.start();
    page = closeLater(await (await browserWith()).newPage(new URL('/nothing', gateway.address).href, { hasVirtualTime: true }));
    await page.goto(new URL('/pair', gateway.address).href);
    await page.waitForSelector('#token svg');
  });
  afterEach(() => gateway.stop());

  it('does not announce the countdown, but announces that the gateway does not respond', async () => {
    const changes = () => page.evaluate(() => window.changes.splice(0));
    await page.evaluate(() => {
      window.changes = [];
      for (const region of document.querySelectorAll('[role="status"], [role="alert"]'))
        new MutationObserver(() => window.changes.push(region.textContent)).observe(region, { childList: true, characterData: true, subtree: true });
    });
    const left = await page.textContent('#left');

    await page.waitForFunction(old => document.querySelector('#left').textContent !== old, left);
    assert.deepEqual(await changes(), []);

    gateway.isSilent = true;
    await page.waitForFunction(() => document.querySelector('#left').textContent === '');
    assert.deepEqual(await changes(), [gatewayReasons.noAnswer]);
  });

  it('fits a window of 320 px', async () => {
    await page.setViewportSize({ width: 320, height: 640 });

    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 320);
  });

  it('accepts numbers as phones write them, and names the fields that are not numbers', async () => {
    const offsets = page.locator('[data-offset]');
    for (const [i, value] of ['0,25', '\u22120.1', '0', '0', '0', '90'].entries()) await offsets.nth(i).fill(value);
    await page.fill('#size', '80,5');
    const newest = () => gateway.posts.findLast(([path]) => path === '/pair/cell')[1];
    const { offset, size_mm: size } = await drawn(newest, post => post.size_mm === '80.5');
    assert.deepEqual([offset, size], ['0.25,-0.1,0,0,0,90', '80.5']);
    assert.deepEqual(await offsets.evaluateAll(all => all.map(field => field.inputMode)), Array(6).fill(''), 'a keyboard with a minus sign');

    await offsets.nth(1).fill('0.1.2');

    await page.waitForFunction(fault => document.querySelector('#fault').textContent === fault, pairingReasons.poseInvalid('y'));
  });

  it('states that a marker is too wide for A4 paper, up to which edge it fits, and still prints it', async () => {
    const fault = text => page.waitForFunction(text => document.querySelector('#fault').textContent === text, text);
    // The code of the fake gateway has 21 modules, and 29 with its margin.
    await page.fill('#size', '200');
    await fault(pairingMessages.wide((200 * 29) / 21, 133));
    assert.ok(await page.locator('#print').isVisible());

    await page.fill('#size', '133');
    await fault('');
  });
});

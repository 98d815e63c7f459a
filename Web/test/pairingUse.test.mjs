// Tests how users and screen readers use the pairing page, with a fake gateway.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, describe, it } from 'node:test';
import { FakeGateway } from './fakeGateway.mjs';
import { messages } from './messages.mjs';
import { browserWith, closeLater } from './pages.mjs';

const { gatewayReasons } = messages;

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
});

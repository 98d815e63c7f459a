// Tests the log-in on the operations page.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { ago, becomes, gateway, open } from './page.mjs';

const { gatewayReasons, operationsMessages, robotMessages } = messages;

describe('the log-in', () => {
  it('is needed if the gateway requires a token, and then all data are shown', async () => {
    gateway.isPublishing = true;
    gateway.token = 'open-sesame';
    const page = await open({}, false);
    await page.waitForSelector('#login', { state: 'visible' });

    assert.equal(gateway.connects, 0, 'no connection without a token');
    await page.fill('#token-text', 'guess');
    await page.keyboard.press('Enter');
    await becomes(page, '#login-fault', 'not a token');
    await page.fill('#token-text', 'open-sesame');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#login', { state: 'hidden' });
    assert.equal(await page.evaluate(() => document.activeElement.id), 'content');
    await becomes(page, '.apart', 'left door');
    gateway.state.cell = 'Press 4';
    await page.waitForFunction(() => document.querySelector('h1').textContent === 'Press 4');

    assert.ok(await page.locator('#login').isHidden());
    assert.equal(await page.inputValue('#token-text'), '');
    assert.ok(!(await page.content()).includes('open-sesame'));
    await page.click('#show-code');
    await page.waitForSelector('#token svg');
    await page.click('#logout');
    await page.waitForSelector('#login', { state: 'visible' });
    assert.equal(await page.evaluate(() => document.activeElement.id), 'token-text', 'the focus is not lost');
    assert.equal(await page.locator('#token svg').count(), 0, 'the code is secret');
    assert.equal(await page.textContent('#trouble'), operationsMessages.loggedOut);
    assert.ok(await page.locator('#content').isHidden(), 'the next person must not see the data');
  });

  it('leaves no data on the page after a log-out, also if the gateway then does not respond', async () => {
    gateway.token = 'open-sesame';
    gateway.state.cell = 'Press 4';
    gateway.state.events = [{ id: 7, kind: 'joint', which: 'arm_joint_3', what: 'is refused', reason: '', level: 'error', since_utc: ago(95) }];
    const page = await open({}, false);
    await page.fill('#token-text', 'open-sesame');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#alarms', { state: 'visible' });

    await page.click('#logout');
    await page.waitForSelector('#login', { state: 'visible' });
    await page.route('**/operations/state', route => route.abort());
    await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
    await becomes(page, '#trouble', operationsMessages.noNewState(gatewayReasons.noAnswer, ''));

    for (const part of ['#content', '#alarms']) assert.ok(await page.locator(part).isHidden(), part);
    const header = await page.evaluate(() => [document.title, ...['cell', 'place'].map(id => document.getElementById(id).textContent)]);
    assert.deepEqual(header, ['Not known: Nowpose: operations', 'Operations', '']);
  });

  it('is not preceded by a message about the connection for joint positions', async () => {
    gateway.token = 'open-sesame';
    const page = await open({ hasVirtualTime: true }, false);
    await page.waitForSelector('#login', { state: 'visible' });

    await page.clock.runFor(2000);

    assert.equal(await page.textContent('.apart'), robotMessages.noDescription);
    assert.ok(await page.locator('#robot .level').first().isHidden());
  });

  it('can be ended in a tab that was opened later, also if the browser blocks its storage', async () => {
    gateway.token = 'open-sesame';
    const first = await open({}, false);
    await first.fill('#token-text', 'open-sesame');
    await first.keyboard.press('Enter');
    await first.waitForSelector('#logout', { state: 'visible' });

    const second = await first.context().newPage();
    await second.addInitScript(() => Object.defineProperty(window, 'sessionStorage', { get: () => { throw new Error('blocked'); } }));
    await second.goto(gateway.address);
    await second.click('#logout');

    await second.waitForSelector('#login', { state: 'visible' });
    await first.waitForSelector('#login', { state: 'visible' });
    await second.close();
  });

  it('can be ended while the gateway does not respond', async () => {
    gateway.token = 'open-sesame';
    const page = await open({}, false);
    await page.fill('#token-text', 'open-sesame');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#logout', { state: 'visible' });

    gateway.isSilent = true;
    await page.waitForSelector('#trouble', { state: 'visible' });

    assert.ok(await page.locator('#logout').isVisible());
    gateway.isSilent = false;
  });
});

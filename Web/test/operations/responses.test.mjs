// Tests what the operations page shows while it has no current response of the gateway.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../drawn.mjs';
import { messages } from '../messages.mjs';
import { ago, becomes, gateway, nextState, open } from './page.mjs';

const { gatewayReasons, levelLabels, operationsLabels, operationsMessages } = messages;

describe('the operations page without a current response', () => {
  it('marks the alarms as old while the gateway does not respond', async () => {
    gateway.state.events = [{ id: 7, kind: 'joint', which: 'arm_joint_3', what: 'is refused', reason: '', level: 'error', since_utc: ago(95) }];
    const page = await open({ hasVirtualTime: true });

    gateway.isSilent = true;
    // The page waits 4 s for a response.
    await Promise.all([page.waitForEvent('requestfailed'), page.clock.runFor(5000)]);

    await page.waitForSelector('#alarms.stale');
    assert.match(await page.locator('#alarms li').first().evaluate(alarm => getComputedStyle(alarm).filter), /grayscale/);
    gateway.isSilent = false;
    await page.waitForSelector('#alarms:not(.stale)');
  });

  it('does not show OK after a sleep until the gateway responds', async () => {
    const page = await open({ hasVirtualTime: true });
    await page.route('**/operations/state', () => {});
    await nextState(page, 1);

    // Less than the 4 s that the page waits for a response.
    await page.clock.fastForward(3500);

    assert.equal(await page.textContent('#status'), operationsMessages.noState);
  });

  it('requests the state at once when it becomes visible', async () => {
    const page = await open({ hasVirtualTime: true });
    // The timers wait from now on.
    await page.clock.pauseAt(Date.now() + 60_000);
    let count = 0;
    page.on('request', () => count++);

    const show = () => page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));

    assert.ok(await drawn(async () => (await show(), count), requests => requests > 2));
  });

  it('shows a fault of the gateway itself in place of OK', async () => {
    const page = await open();

    gateway.isSilent = true;

    await becomes(page, '#status', levelLabels.unknown);
    assert.ok((await page.title()).startsWith(`${levelLabels.unknown}: Press 3`));
    assert.equal(await page.getAttribute('#status', 'class'), 'level unknown');
  });

  it('does not show a response of a proxy as a message', async () => {
    const page = await open();

    await page.route('**/operations/state', route => route.fulfill({ status: 404, contentType: 'text/html', body: '<html>nginx</html>' }));

    await becomes(page, '#trouble', operationsMessages.noNewState(gatewayReasons.notFromGateway(404), ''));
  });

  it('does not show a response of a proxy as a state', async () => {
    const page = await open();

    await page.route('**/operations/state', route => route.fulfill({ status: 200, contentType: 'text/html', body: '<html>Log in</html>' }));

    await becomes(page, '#trouble', operationsMessages.noNewState(gatewayReasons.notFromGateway(200), ''));
  });

  it('states that the certificate may have changed if it was loaded over TLS', async () => {
    const page = await open();
    const body = await (await fetch(gateway.address)).text();
    await page.route('https://cell-pc/**', route => route.abort());
    await page.route('https://cell-pc/operations', route => route.fulfill({ contentType: 'text/html', body }));

    await page.goto('https://cell-pc/operations');

    await becomes(page, '#trouble', operationsMessages.noNewState(gatewayReasons.noAnswerOrCertificate, ''));
  });

  it('states that it cannot show a response, and shows the next one that it can show', async () => {
    const page = await open();
    const { joints } = gateway.state;

    gateway.state.joints = [{ ...joints[0], name: null }];

    await becomes(page, '#trouble', operationsMessages.noNewState(gatewayReasons.notUnderstood, ''));
    await becomes(page, '#status', levelLabels.unknown);
    gateway.state.joints = joints;
    await becomes(page, '#status', levelLabels.ok);
  });

  it('is loaded again if the version of the gateway changes', async () => {
    const page = await open();
    const loaded = page.waitForEvent('load');

    gateway.state.version = '0.3.0';

    await loaded;
    await becomes(page, '#place', operationsLabels.gateway('0.3.0'));
  });
});

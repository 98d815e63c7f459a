// Tests the view of the robot while the connection for joint positions is lost, and after it was opened again.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../../drawn.mjs';
import { JOINTS } from '../../fakeGateway.mjs';
import { messages } from '../../messages.mjs';
import { becomes, bodiesDrawn, gateway, nextState, open, showsToolError, withGraphics } from '../page.mjs';

const { operationsMessages, robotMessages } = messages;

describe('the connection for joint positions', () => {
  withGraphics();

  it('is stated when it is lost, and no robot is drawn', async () => {
    const page = await open({ reducedMotion: 'reduce' });
    await showsToolError(page);

    gateway.isFull = true;
    gateway.hangUp();
    await becomes(page, '#robot .level', robotMessages.noConnection('').split('since')[0]);
    assert.match(await page.textContent('#robot .level'), /since \d\d:\d\d:\d\d,/);
    assert.equal(await drawn(() => bodiesDrawn(page), bodies => bodies === 1), 1, 'only the floor');
    assert.equal(await page.textContent('.apart'), '');

    gateway.isFull = false;
    await showsToolError(page);
    assert.doesNotMatch(await page.locator('#robot .level').first().textContent(), /connection/);
  });

  it('is stated to be lost if it is silent, although the browser reports no loss, and is opened again', async () => {
    gateway.pace = 0;
    for (const joint of gateway.state.joints) joint.state = 'rest';
    const page = await open({ hasVirtualTime: true });
    await showsToolError(page);

    gateway.isFull = true;
    gateway.loseSockets();
    for (let i = 0; i < 3; i++) {
      await nextState(page);
      await page.clock.fastForward(3000);
    }
    await becomes(page, '#robot .level', robotMessages.noConnection('').split('since')[0]);
    assert.equal(await page.textContent('.apart'), '');

    gateway.isFull = false;
    await showsToolError(page);
  });

  it('is stated to be lost if the browser gets no response to its request, and is requested again', async () => {
    gateway.pace = 0;
    for (const joint of gateway.state.joints) joint.state = 'rest';
    gateway.isDeaf = true;
    const page = await open({ hasVirtualTime: true });

    for (let i = 0; i < 3; i++) {
      await nextState(page);
      await page.clock.fastForward(3000);
    }
    await becomes(page, '#robot .level', robotMessages.noConnection('').split('since')[0]);

    gateway.isDeaf = false;
    await showsToolError(page);
  });

  it('stays open while it only receives responses', async () => {
    gateway.turned = null;
    gateway.sets = [null];
    const page = await open({ hasVirtualTime: true });

    for (let i = 0; i < 4; i++) {
      await nextState(page);
      await page.clock.fastForward(3000);
    }

    assert.equal(gateway.connects, 1);
  });

  it('is not attempted while the gateway does not respond', async () => {
    const page = await open({ hasVirtualTime: true });
    await showsToolError(page);

    gateway.isFull = gateway.isSilent = true;
    gateway.hangUp();
    const isState = request => request.url().endsWith('/state');
    let request = page.waitForRequest(isState);
    for (let i = 0; i < 5; i++) {
      await request;
      request = page.waitForRequest(isState);
      // The page waits 4 s for a response.
      await Promise.all([page.waitForEvent('requestfailed', isState), page.clock.fastForward(5000)]);
      await becomes(page, '#status', operationsMessages.noState);
    }
    assert.equal(gateway.connects, 1);

    gateway.isFull = gateway.isSilent = false;
    await showsToolError(page);
    assert.equal(gateway.connects, 2);
  });

  it('is opened again without the robot if the gateway restarts without it', async () => {
    gateway.robots = ['arm2'];
    gateway.state.joints.push(...JOINTS.map(joint => ({ ...gateway.state.joints[0], name: `arm2/${joint}` })));
    const page = await open();
    await showsToolError(page);

    gateway.urdf = null;
    gateway.robots = [];
    gateway.turned = null;
    gateway.state.joints = [];
    gateway.hangUp();

    await becomes(page, '.apart', robotMessages.noDescription);
    assert.ok(await page.locator('#robot .level').first().isHidden());
  });

  it('is opened again, and the robot moves again, after a restart of the gateway', async () => {
    const page = await open();
    await showsToolError(page);

    gateway.hangUp();
    gateway.began -= 100_000;

    const deadline = Date.now() + 60_000;
    while (gateway.connects < 2) {
      assert.ok(Date.now() < deadline, 'the page did not reconnect');
      await new Promise(done => setTimeout(done, 50));
    }
    await showsToolError(page);
  });
});

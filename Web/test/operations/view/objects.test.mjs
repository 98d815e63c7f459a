// Tests what the 3D view of the operations page draws of a cell whose robots or joint positions are missing.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../../drawn.mjs';
import { JOINTS } from '../../fakeGateway.mjs';
import { messages } from '../../messages.mjs';
import { becomes, bodiesDrawn, gateway, open, openWithOneBody, withGraphics } from '../page.mjs';

const { jointReasons, robotMessages } = messages;

describe('the 3D view', () => {
  withGraphics();

  it('does not draw a robot at its last pose when no source publishes its joints any more', async () => {
    const { page, alone } = await openWithOneBody();
    gateway.robots = ['arm2'];
    const own = [...gateway.state.joints];
    for (const joint of JOINTS) gateway.state.joints.push({ ...own[0], name: `arm2/${joint}` });
    const both = await drawn(() => bodiesDrawn(page), bodies => bodies > alone);

    gateway.robots = [];
    gateway.state.joints = own;
    const after = await drawn(() => bodiesDrawn(page), bodies => bodies < both);
    assert.ok(after >= alone && after < both, `${after} bodies, from ${alone} to ${both}: at most the base of the second robot remains`);

    gateway.sets = [];
    gateway.state.joints = own.slice(1);
    await becomes(page, '#robot .level', jointReasons.notPublished('arm_joint_1'));
  });

  it('draws neither robot nor objects when the gateway that published them has restarted without them', async () => {
    const { page, alone } = await openWithOneBody();
    gateway.stationary = ['fixture'];
    gateway.hangUp();
    const withFixture = await drawn(() => bodiesDrawn(page), bodies => bodies === alone + 1);
    assert.equal(withFixture, alone + 1);

    gateway.stationary = [];
    gateway.sets = [];
    gateway.hangUp();

    const floor = await drawn(() => bodiesDrawn(page), bodies => bodies === 1);
    assert.equal(floor, 1, 'only the floor');
    await becomes(page, '#robot .level', jointReasons.notReceived('arm_joint_1'));
  });

  it('draws the objects of a cell without joint positions', async () => {
    gateway.sets = [];
    gateway.turned = null;
    gateway.stationary = ['fixture'];
    const page = await open({ reducedMotion: 'reduce' });
    await becomes(page, '.apart', robotMessages.toolUnknown);
    const stationary = await drawn(() => bodiesDrawn(page), bodies => bodies === 2);
    assert.equal(stationary, 2, 'the floor and the fixture');

    gateway.base = [0.5, 0, 0];
    const moving = await drawn(() => bodiesDrawn(page), bodies => bodies === 3);
    assert.equal(moving, 3, 'also the moving frame');

    gateway.urdf = null;
    await page.reload();
    await becomes(page, '.apart', robotMessages.noDescription);
    const undescribed = await drawn(() => bodiesDrawn(page), bodies => bodies === 3);
    assert.equal(undescribed, 3, 'the same without a robot description');
    assert.deepEqual(page.complaints, []);
  });
});

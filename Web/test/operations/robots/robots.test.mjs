// Tests the view of several robots on the operations page.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../../drawn.mjs';
import { JOINTS } from '../../fakeGateway.mjs';
import { messages } from '../../messages.mjs';
import { becomes, bodiesDrawn, gateway, nextState, open, openWithOneBody, showsToolError, withGraphics } from '../page.mjs';

const { jointReasons, robotMessages } = messages;

describe('a robot', () => {
  withGraphics();

  it('is drawn together with robots in namespaces whose joints have the same names', async () => {
    const { page, alone } = await openWithOneBody();

    gateway.robots = ['arm2'];
    for (const joint of JOINTS) gateway.state.joints.push({ ...gateway.state.joints[0], name: `arm2/${joint}` });
    const both = await drawn(() => bodiesDrawn(page), bodies => bodies > alone);
    assert.ok(both > alone, `${both} bodies instead of ${alone}`);

    // Only the robot whose joint is not live loses the links below this joint.
    gateway.state.joints.at(-JOINTS.length).state = 'stale';
    const part = await drawn(() => bodiesDrawn(page), bodies => bodies > alone && bodies < both);
    assert.ok(part > alone && part < both, `${part} bodies, between ${alone} and ${both}`);
    assert.deepEqual(page.complaints, []);
  });

  it('in a namespace is drawn on a link of the robot without a namespace', async () => {
    gateway.stationary = ['arm2/arm_link_0'];
    gateway.parents = { 'arm2/arm_link_0': 'arm_link_5' };
    const { page, alone } = await openWithOneBody();

    gateway.robots = ['arm2'];
    for (const joint of JOINTS) gateway.state.joints.push({ ...gateway.state.joints[0], name: `arm2/${joint}` });
    const both = await drawn(() => bodiesDrawn(page), bodies => bodies > alone + 2);
    assert.ok(both > alone + 2, `${both} bodies instead of ${alone}`);

    // Without the link on which it stands, its pose is not known.
    gateway.state.joints[0].state = 'stale';
    const part = await drawn(() => bodiesDrawn(page), bodies => bodies < alone);
    assert.ok(part < alone, `${part} bodies instead of ${alone}`);
    assert.deepEqual(page.complaints, []);
  });

  it('without a namespace may have joints with a slash in their names', async () => {
    const { page } = await openWithOneBody();
    const topics = [...gateway.sockets.values()][0];

    gateway.state.joints.push({ ...gateway.state.joints[0], name: 'panda/joint1', robot: '' });
    gateway.state.joints.push({ ...gateway.state.joints[0], name: 'arm2/panda/joint1', robot: 'arm2' });
    await drawn(
      () => nextState(page),
      () => topics.has('/arm2/joint_states'),
    );

    assert.ok(topics.has('/arm2/joint_states'));
    assert.ok(!topics.has('/panda/joint_states'));
  });

  it('in a namespace is drawn after 16 others have come and gone', async () => {
    const { page, alone } = await openWithOneBody();
    const own = [...gateway.state.joints];
    const jointsOf = robot => JOINTS.map(joint => ({ ...own[0], name: `${robot}/${joint}` }));
    for (let i = 1; i <= 16; i++) gateway.state.joints = [...own, ...jointsOf(`arm${i}`), ...gateway.state.joints.slice(own.length)];
    const topics = () => [...gateway.sockets.values()][0];
    const used = () => [...topics()].filter(topic => topic.endsWith('/joint_states') && topic !== '/joint_states').length;
    await drawn(() => nextState(page), () => used() === 16);

    gateway.state.joints = [...own, ...jointsOf('arm17')];
    gateway.robots = ['arm17'];
    const both = await drawn(() => bodiesDrawn(page), bodies => bodies > alone);

    assert.ok(both > alone, `${both} bodies instead of ${alone}`);
    assert.equal(used(), 16);
    assert.deepEqual(page.complaints, []);
  });

  it('is not compared while it is not known which of several robots the headset displays', async () => {
    gateway.turned = null;
    const page = await open();
    await page.waitForFunction(() => /compensation/.test(document.querySelector('.apart').textContent));

    gateway.robots = ['arm2'];
    for (const joint of JOINTS) gateway.state.joints.push({ ...gateway.state.joints[0], name: `arm2/${joint}` });

    await becomes(page, '.apart', robotMessages.toolError('left door', null, null));
  });

  it('has a description while no position of its joints is known', async () => {
    const { urdf } = gateway;
    gateway.urdf = gateway.turned = null;
    gateway.state.joints = ['arm1', 'arm2'].flatMap(robot => JOINTS.map(joint => ({ ...gateway.state.joints[0], name: `${robot}/${joint}` })));
    const page = await open();
    const topics = ['/arm1/robot_description', '/arm2/robot_description'];
    await drawn(() => nextState(page), () => topics.every(topic => [...gateway.sockets.values()][0]?.has(topic)));
    await becomes(page, '.apart', robotMessages.noDescription);

    for (const topic of topics) gateway.send(topic, JSON.stringify({ op: 'publish', topic, msg: { data: urdf } }));

    await becomes(page, '.apart', robotMessages.toolError('left door', null, null));
    await becomes(page, '#robot .level', jointReasons.notReceived('arm1/arm_joint_1'));
  });

  it('in a namespace is compared with the pose that the headset displays of it', async () => {
    gateway.robots = ['arm2'];
    for (const joint of JOINTS) gateway.state.joints.push({ ...gateway.state.joints[0], name: `arm2/${joint}` });
    gateway.displayedRobot = 'arm2';
    const page = await open();

    const far = 2 * 480.9 * Math.sin(0.05);
    await showsToolError(page, far - 1, far + 1);
    gateway.turned = 0;
    await showsToolError(page, 0, 5);
    assert.match(await page.textContent('.apart'), /mm.*mm/, 'also without compensation');

    Object.assign(gateway.state.joints.at(-JOINTS.length), { state: 'stale', reason: 'samples stopped arriving' });
    await becomes(page, '.apart', robotMessages.toolUnknown);
    await becomes(page, '#robot .level', jointReasons.inState('arm2/arm_joint_1', 'stale'));
  });

  it('in a namespace is compared although the base of another robot is not known, which is named', async () => {
    gateway.robots = ['arm2'];
    for (const joint of JOINTS) gateway.state.joints.push({ ...gateway.state.joints[0], name: `arm2/${joint}` });
    gateway.displayedRobot = 'arm2';
    gateway.state.frames.push({ name: 'arm_link_0', parent: 'world', source: 'tracker', state: 'stale', age_s: 60, reason: 'its poses stopped' });
    const page = await open();

    await becomes(page, '#robot .level', robotMessages.basesUnknown(['arm_link_0']));
    await showsToolError(page);
  });

  it('is not compared while one of the joints above its tool has no new positions', async () => {
    gateway.turned = 0;
    const page = await open();
    await showsToolError(page);

    gateway.sets = [JOINTS.slice(4)];

    await becomes(page, '.apart', robotMessages.late);
  });

  it('is not compared between two reports of the headset that are far apart', async () => {
    gateway.turned = 0;
    const page = await open();
    await showsToolError(page);

    gateway.reportEvery = 4;

    await becomes(page, '.apart', robotMessages.toolError('left door', null, 5).split(';')[0]);
  });

  it('is compared again after an exception while it was drawn', async () => {
    const page = await open();
    await showsToolError(page, 40);
    await page.evaluate(() => Object.defineProperty(document.querySelectorAll('#robot .level')[1], 'hidden', {
      configurable: true, set() { delete this.hidden; throw new Error('once'); },
    }));

    gateway.turned = 0;

    await showsToolError(page, 0, 5);
  });
});

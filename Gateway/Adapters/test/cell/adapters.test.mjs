// Tests complete adapters that read frames, signals and robots from OPC UA and ADS servers.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { configuration as adsConfiguration } from '../ads/cell.mjs';
import { AdsServer } from '../ads/server.mjs';
import { angle, opening, youBot } from '../ads/youbot.mjs';
import { OPEN, serverFor } from '../opcua/plant.mjs';
import { until } from '../program.mjs';
import { nanoseconds } from '../rosbridge.mjs';
import { messages } from '../messages.mjs';
import { adapterFor, assertPoseMatches, changes, posesOf } from './published.mjs';

const { symbolMessages } = messages;

describe('frames, signals and robots', () => {
  it('OpcUa_PosesSignalsAndRobots_HaveTheTrueValuesAtTheirTimeStamps', async t => {
    const server = await serverFor(t);
    const { bridge } = await adapterFor(t, url => `gateway: { url: "${url}" }
plant:
  kind: opcua
  name: cell
  endpoint: ${server.endpoint}
  ${OPEN}
robots: { arm1: ur5e, arm2: ur5e }
joints:
  - { joint: arm1/elbow_joint, node: ns=1;s=arm_joint_1 }
  - { joint: arm2/elbow_joint, node: ns=1;s=arm_joint_2 }
frames:
  - frame: part
    parent: arm1/tool0
    position: { unit: m, x: { node: ns=1;s=positions, index: 5 }, y: 1, z: 0 }
    angles: { order: zyx, axes: moving, unit: rad, values: [{ node: ns=1;s=positions, index: 2 }, 0, 0] }
  - frame: table
    position: { unit: mm, x: 500, y: 0, z: 0 }
signals:
  - { signal: open, node: ns=1;s=is_open }
`);

    const seen = await posesOf(bridge, 'part', 60);

    for (const pose of seen) assertPoseMatches(pose, opening, stamp => angle(2, stamp), 1e-6);
    assert.equal(seen[0].header.frame_id, 'arm1/tool0');
    assert.equal(seen[0].transform.translation.y, 1);
    assert.deepEqual(bridge.published('/tf_static').map(({ transforms }) => transforms[0].child_frame_id), ['table']);
    for (const [robot, joint] of [['arm1', 0], ['arm2', 1]]) {
      const states = bridge.published(`/${robot}/joint_states`);
      assert.ok(states.length > 10 && states.every(({ name }) => name.join() === 'elbow_joint'));
      for (const { header, position } of states) assert.ok(Math.abs(position[0] - angle(joint, nanoseconds(header.stamp))) < 1e-9);
      assert.match(bridge.published(`/${robot}/robot_description`)[0].data, /<robot/);
    }
    // The gripper opens and closes every 1.7 s.
    await until(() => new Set(changes(bridge).map(([, value]) => value)).size === 2, () => `two values: ${JSON.stringify(changes(bridge).map(String))}`);
    for (const [stamp, value] of changes(bridge)) assert.equal(value, opening(stamp) > 0.005 ? 1 : 0);
    await until(() => bridge.state?.['frame/part']?.startsWith('live') && bridge.state['signal/open']?.startsWith('live'), () => JSON.stringify(bridge.state));
  });

  it('OpcUa_NodesDeleted_FrameAndSignalAreInFault', async t => {
    const server = await serverFor(t);
    const { bridge } = await adapterFor(t, url => `gateway: { url: "${url}" }
plant:
  kind: opcua
  name: cell
  endpoint: ${server.endpoint}
  ${OPEN}
joints:
  - { joint: a, node: ns=1;s=arm_joint_1 }
frames:
  - frame: part
    position: { unit: m, x: { node: ns=1;s=arm_joint_2 }, y: 0, z: 0 }
signals:
  - { signal: open, node: ns=1;s=is_open }
`);
    await posesOf(bridge, 'part', 5);

    server.remove('arm_joint_2');
    server.remove('is_open');

    for (const key of ['frame/part', 'signal/open'])
      await until(() => bridge.state?.[key]?.startsWith('fault') && bridge.state[key].includes('the server'), () => `${key}: ${JSON.stringify(bridge.state)}`);
    await until(() => bridge.joint('a').state === 'live', () => JSON.stringify(bridge.state));
    assert.equal(bridge.status.level, 2);
  });
});

describe('frames, signals and robots of ADS', () => {
  it('Ads_PosesAndSignals_HaveTheTrueValuesAtTheirTimeStamps', async t => {
    const server = new AdsServer(youBot({ cycleMs: 5 })), port = await server.listen();
    t.after(() => server.close());
    const { bridge } = await adapterFor(t, url => `${adsConfiguration({ port, url })}frames:
  - frame: part
    position: { unit: mm, x: { symbol: MAIN.fGripper }, y: 0, z: 0 }
    angles: { order: xyz, axes: fixed, unit: deg, values: [0, 0, { symbol: MAIN.fAxis1 }] }
signals:
  - { signal: open, symbol: MAIN.bOpen }
`);

    const seen = await posesOf(bridge, 'part', 60);

    for (const pose of seen) assertPoseMatches(pose, opening, stamp => angle(0, stamp), 1e-6);
    await until(() => new Set(changes(bridge).map(([, value]) => value)).size === 2, 'two values');
    for (const [stamp, value] of changes(bridge)) assert.equal(value, opening(stamp) > 0.005 ? 1 : 0);
  });

  it('Ads_JointsOfTwoRobots_ArePublishedInTheirNamespaces', async t => {
    const server = new AdsServer(youBot({ cycleMs: 5 })), port = await server.listen();
    t.after(() => server.close());
    const joints = `  - { joint: arm1/elbow_joint, symbol: "GVL.aJoints[0]" }
  - { joint: arm2/elbow_joint, symbol: "GVL.aJoints[1]" }
robots: { arm1: ur5e, arm2: ur5e }
frames:
  - frame: part
    parent: arm2/tool0
    position: { unit: mm, x: { symbol: MAIN.fGripper }, y: 0, z: 0 }
    quaternion: { x: 0, y: 0, z: 0, w: 1 }
`;
    const { bridge } = await adapterFor(t, url => adsConfiguration({ port, url, joints }));

    for (const [robot, joint] of [['arm1', 0], ['arm2', 1]]) {
      const states = await until(() => bridge.published(`/${robot}/joint_states`).length > 10 && bridge.published(`/${robot}/joint_states`),
        () => JSON.stringify(bridge.state));
      for (const { header, name, position } of states) {
        assert.deepEqual(name, ['elbow_joint']);
        assert.ok(Math.abs(position[0] - angle(joint, nanoseconds(header.stamp))) < 1e-9);
      }
      assert.match(bridge.published(`/${robot}/robot_description`)[0].data, /<robot/);
    }
    assert.deepEqual(bridge.jointStates, []);
    for (const pose of await posesOf(bridge, 'part', 10)) {
      assert.equal(pose.header.frame_id, 'arm2/tool0');
      assertPoseMatches(pose, opening, () => 0, 1e-6);
    }
  });

  it('Ads_BoolAsPosition_IsRefusedWithItsLineInTheFile', async t => {
    const server = new AdsServer(youBot({ cycleMs: 5 })), port = await server.listen();
    t.after(() => server.close());
    const { bridge } = await adapterFor(t, url => `${adsConfiguration({ port, url })}frames:
  - frame: part
    position: { unit: m, x: { symbol: MAIN.bOpen }, y: 0, z: 0 }
`);

    await until(() => bridge.state?.['frame/part']?.includes(`MAIN.bOpen has the type BOOL; ${symbolMessages.notNumber}`), () => JSON.stringify(bridge.state));
    assert.match(bridge.state['frame/part'], /line 22: /);
  });

});

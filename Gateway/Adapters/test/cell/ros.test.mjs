// Tests complete adapters that read frames, signals and robots from a test double of a ROS system.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { start, until } from '../program.mjs';
import { Robot } from '../ros/robot.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { messages } from '../messages.mjs';
import { adapterFor, changes, isArrival, poses, posesOf } from './published.mjs';

const { refusalMessages, rosMessages } = messages;

describe('frames, signals and robots of ROS', () => {
  it('Ros_FramesSignalsAndRobot_AreForwarded', async t => {
    const robot = await Robot.start(t);
    const { bridge } = await adapterFor(t, url => `gateway: { url: "${url}" }
plant: { kind: ros, name: arm, endpoint: "${robot.url}", namespace: arm1, world: map }
frames:
  - { frame: part, source: detected }
  - { frame: table }
signals:
  - { signal: closed, topic: /gripper/closed, type: std_msgs/Bool }
  - { signal: force, topic: /wrench, type: geometry_msgs/WrenchStamped, field: wrench.force.z }
`);
    await until(() => ['/tf', '/tf_static', '/gripper/closed', '/wrench'].every(topic => robot.isHeardBy(topic)), 'the subscriptions');
    await until(async () => (await bridge.call('/nowpose/plant_time/arm')).result, 'the clock');
    const transform = (child, parent, x, stamp = robot.now()) => ({
      header: { stamp: robot.time(stamp), frame_id: parent }, child_frame_id: child, transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } },
    });
    const stamp = robot.now();

    robot.publish('/tf', { transforms: [transform('other', 'map', 9), transform('/detected', 'map', 1, stamp)] });
    robot.publish('/tf', { transforms: [transform('detected', 'tool0', 2)] });
    robot.publish('/tf_static', { transforms: [transform('table', 'map', 3)] });
    robot.publish('/gripper/closed', { data: true });
    robot.publish('/wrench', { header: { stamp: robot.time(stamp) }, wrench: { force: { z: -4.5 } } });
    robot.jointState(robot.now(), ['elbow'], [0.5]);

    const seen = await posesOf(bridge, 'part', 2);
    assert.deepEqual(seen.map(one => [one.header.frame_id, one.transform.translation.x]), [['world', 1], ['arm1/tool0', 2]]);
    assert.equal(nanoseconds(seen[0].header.stamp), stamp);
    assert.deepEqual((await until(() => bridge.published('/tf_static')[0], 'the table')).transforms.map(one => [one.header.frame_id, one.child_frame_id]), [['world', 'table']]);
    await until(() => bridge.published('/signals').length >= 2, 'the signals');
    const found = Object.fromEntries(bridge.published('/signals').map(({ header, name, value }) => [name[0], [value[0], nanoseconds(header.stamp)]]));
    assert.deepEqual([found.closed[0], found.force], [1, [-4.5, stamp]]);
    assert.ok(isArrival(found.closed[1], stamp, robot.now()));
    await until(() => bridge.published('/arm1/joint_states').length >= 1, 'the joint state');
    assert.deepEqual(bridge.published('/arm1/joint_states')[0].name, ['elbow']);
    await until(() => bridge.joint('arm1/elbow')?.state === 'live', () => JSON.stringify(bridge.state));
  });

  it('Ros_StationaryFramesOfRosAndOfTheFile_AreBothSentAgainAfterAReconnection', async t => {
    const robot = await Robot.start(t);
    const { bridge } = await adapterFor(t, url => `gateway: { url: "${url}" }
plant: { kind: ros, name: arm, endpoint: "${robot.url}", world: map }
frames:
  - { frame: table }
  - { frame: rack, topic: /rack, type: std_msgs/Float64MultiArray, position: { unit: m, x: 1, y: 0, z: 0 } }
`);
    await until(() => robot.isHeardBy('/tf_static'), 'the subscription');
    const stationary = () => new Set(bridge.published('/tf_static').flatMap(({ transforms }) => transforms.map(one => one.child_frame_id)));
    robot.publish('/tf_static', { transforms: [{ header: { stamp: robot.time(0n), frame_id: 'map' }, child_frame_id: 'table', transform: { translation: { x: 3, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } } }] });
    await until(() => stationary().size === 2, () => `both frames: ${[...stationary()]}`);

    bridge.heard.length = 0;
    for (const client of bridge.clients) client.terminate();

    await until(() => stationary().size === 2, () => `both frames again: ${[...stationary()]}`);
  });

  it('Ros_PosesAndJointsWithSeparateTopics_AreForwarded', async t => {
    const robot = await Robot.start(t);
    const { bridge } = await adapterFor(t, url => `gateway: { url: "${url}" }
plant: { kind: ros, name: arm, endpoint: "${robot.url}", world: map }
joints:
  - { joint: elbow }
  - { joint: finger, topic: /gripper/width, type: std_msgs/Float64, scale: 0.5 }
  - { joint: wheel, topic: /base/joint_states, type: sensor_msgs/JointState, field: position.1 }
frames:
  - { frame: posed, topic: /detection/pose, type: geometry_msgs/PoseStamped }
  - { frame: sure, topic: /amcl_pose, type: geometry_msgs/PoseWithCovarianceStamped }
  - { frame: transformed, topic: /tracker, type: geometry_msgs/TransformStamped }
  - { frame: part }
signals:
  - { signal: speed, topic: /gripper/width, type: std_msgs/msg/Float64 }
`);
    await until(() => ['/gripper/width', '/base/joint_states', '/detection/pose', '/amcl_pose', '/tracker', '/tf'].every(topic => robot.isHeardBy(topic)), 'the subscriptions');
    await until(async () => (await bridge.call('/nowpose/plant_time/arm')).result, 'the clock');
    const stamp = robot.now(), header = { stamp: robot.time(stamp), frame_id: 'map' };
    const pose = x => ({ position: { x, y: 0, z: 0 }, orientation: { x: 0, y: 0, z: 1, w: 0 } });

    robot.publish('/detection/pose', { header, pose: pose(1) });
    robot.publish('/amcl_pose', { header, pose: { pose: pose(2), covariance: [] } });
    robot.publish('/tracker', { header, child_frame_id: 'anything', transform: { translation: { x: 3, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 1, w: 0 } } });
    robot.publish('/gripper/width', { data: 0.08 });
    robot.publish('/base/joint_states', { header, name: ['left', 'right'], position: [0.1, 0.2] });
    robot.jointState(stamp, ['elbow', 'finger'], [0.5, 9]);

    for (const [frame, x] of [['posed', 1], ['sure', 2], ['transformed', 3]]) {
      const [seen] = await posesOf(bridge, frame, 1);
      assert.deepEqual([seen.header.frame_id, nanoseconds(seen.header.stamp), seen.transform.translation.x, seen.transform.rotation.z], ['world', stamp, x, 1]);
    }
    const joints = await until(() => {
      const found = Object.fromEntries(bridge.jointStates.flatMap(one => one.name.map((name, i) => [name, [one.position[i], nanoseconds(one.header.stamp)]])));
      return Object.keys(found).length === 3 && found;
    }, () => JSON.stringify(bridge.state));
    assert.deepEqual([joints.elbow, joints.wheel], [[0.5, stamp], [0.2, stamp]]);
    assert.equal(joints.finger[0], 0.04);
    assert.ok(isArrival(joints.finger[1], stamp, robot.now()));
    await until(() => bridge.published('/signals')[0]?.value[0] === 0.08, () => JSON.stringify(bridge.state));
  });

  it('Ros_BoolWithoutRobotClock_IsStampedWithItsArrivalTimeOnTheGatewaysClock', async t => {
    VirtualTime.ofProcess(t);
    const robot = await Robot.start(t, { now: null }), now = () => BigInt(Date.now()) * 1_000_000n + 60_000_000_000n;
    const bridge = await RosbridgeDouble.start(t, { now }), before = now();
    start(t, [temporaryFile('plant.yaml', `gateway: { url: "${bridge.url}" }
plant: { kind: ros, name: arm, endpoint: "${robot.url}", clock: false }
signals:
  - { signal: closed, topic: /closed, type: std_msgs/Bool }
`)]);
    await until(() => robot.isHeardBy('/closed'), 'the subscription');

    await until(() => {
      robot.publish('/closed', { data: true });
      return changes(bridge).length > 0;
    }, () => JSON.stringify(bridge.state));

    const [[stamp, value]] = changes(bridge);
    assert.equal(value, 1);
    assert.ok(isArrival(stamp, before, now()));
  });

  const SIGNAL = 'signals:\n  - { signal: closed, topic: /closed, type: std_msgs/Bool }\n';
  const JOINT = 'joints:\n  - { joint: finger, topic: /width, type: std_msgs/Float64 }\n';
  const ahead = (minutes = 0) => BigInt(Date.now() + 60_000 * minutes) * 1_000_000n;
  /** Starts an adapter for a robot with the latched messages /closed and /width. `now` returns the time of the gateway's clock. */
  async function latched(t, { robot: options = {}, plant = '', rest = SIGNAL, now = ahead } = {}) {
    VirtualTime.ofProcess(t);
    const robot = await Robot.start(t, options), bridge = await RosbridgeDouble.start(t, { now: () => now() });
    robot.publish('/closed', { data: true }, { isLatched: true });
    robot.publish('/width', { data: 0.04 }, { isLatched: true });
    const { err } = start(t, [temporaryFile('plant.yaml', `gateway: { url: "${bridge.url}" }\nplant: { kind: ros, name: arm, endpoint: "${robot.url}"${plant} }\n${rest}`)]);
    return { robot, bridge, last: expected => until(() => changes(bridge).some(([stamp, value]) => value === 1 && expected(stamp)), () => JSON.stringify(bridge.state) + err) };
  }

  // The robot sends latched messages before the adapter has read the clock.
  for (const [name, plant, clock] of [['RobotsClock', '', ({ robot }) => robot.now], ['GatewaysClock', ', clock: false', () => () => ahead(2)]])
    it(`Ros_LatchedMessagesWithoutHeader_HaveTheTimeOfThe${name}AlsoAfterAReconnection`, async t => {
      const cell = await latched(t, { robot: { aheadMs: -7_200_000 }, plant, rest: JOINT + SIGNAL, now: () => ahead(2) }), { robot, bridge } = cell;
      const now = clock(cell), started = now();

      await cell.last(stamp => isArrival(stamp, started, now()));
      const [{ name: joints, position, header }] = await until(() => bridge.jointStates.length > 0 && bridge.jointStates, () => JSON.stringify(bridge.state));
      assert.deepEqual([joints, position], [['finger'], [0.04]]);
      assert.ok(isArrival(nanoseconds(header.stamp), started, now()));
      await robot.stop();
      await until(() => bridge.state?.['signal/closed']?.startsWith('fault'), () => JSON.stringify(bridge.state));
      await robot.listen(robot.port);
      await until(() => bridge.state['signal/closed'].startsWith('live') && bridge.joint('finger').state === 'live', () => JSON.stringify(bridge.state));
      assert.equal(bridge.state.refused, '0');
    });

  it('Ros_AnotherClockBecomesTheControlClock_SignalsHaveItsTime', async t => {
    let minutes = 12;
    const { robot, last } = await latched(t, { robot: { now: null }, plant: ', clock: false', now: () => ahead(minutes) });
    await last(stamp => isArrival(stamp, ahead(12) - 60_000_000_000n, ahead(12)));

    minutes = 0;

    await last(stamp => isArrival(stamp, ahead(-1), ahead()));
    assert.equal(robot.heard.filter(({ op, topic }) => op === 'subscribe' && topic === '/closed').length, 1);
  });

  it('Ros_RobotsClockAvailableLater_SignalsHaveItsTime', async t => {
    const { robot, last } = await latched(t, { robot: { now: null } });
    await last(stamp => isArrival(stamp, ahead(-1), ahead()));

    robot.now = () => ahead(-30);

    await last(stamp => isArrival(stamp, ahead(-31), ahead(-30)));
  });

  for (const [name, spoil, reason, text] of [
    ['WithoutUnitQuaternion', one => { one.transform.rotation.w = 0.5; }, 'not-unit', refusalMessages.quaternion(0.5)],
    ['WithZeroQuaternion', one => { one.transform.rotation.w = 0; }, 'not-unit', refusalMessages.quaternion(0)],
    ['WithNaN', one => { one.transform.translation.x = null; }, 'malformed', rosMessages.notFinite('position x', 'part', null)],
    ['WithTextInQuaternion', one => { one.transform.rotation.w = '1'; }, 'malformed', rosMessages.notFinite('quaternion w', 'part', '1')],
    ['WithoutStamp', one => { one.header = { frame_id: 'map' }; }, 'stamp-missing', refusalMessages.noStamp],
    ['WithZeroStamp', one => { one.header.stamp = { sec: 0, nanosec: 0 }; }, 'stamp-zero', refusalMessages.zeroStamp],
    ['WithoutParent', one => { one.header.frame_id = ''; }, 'malformed', rosMessages.noParent('part')],
    ['WithoutPose', one => { delete one.transform; }, 'malformed', rosMessages.notFinite('position x', 'part', undefined)],
  ])
    it(`Ros_Transform${name}_IsRefused`, async t => {
      const robot = await Robot.start(t);
      const { bridge } = await adapterFor(t, url => `gateway: { url: "${url}" }
plant: { kind: ros, name: arm, endpoint: "${robot.url}" }
frames:
  - { frame: part }
`);
      await until(() => robot.isHeardBy('/tf'), 'the subscription');
      await until(async () => (await bridge.call('/nowpose/plant_time/arm')).result, 'the clock');
      const one = { header: { stamp: robot.time(robot.now()), frame_id: 'map' }, child_frame_id: 'part', transform: { translation: { x: 1, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } } };
      spoil(one);

      robot.publish('/tf', { transforms: [null, one] });

      await until(() => bridge.state?.[`refused/${reason}`] === '1', () => JSON.stringify(bridge.state));
      assert.deepEqual(poses(bridge, 'part'), []);
      assert.ok(bridge.state['frame/part'].startsWith('missing ') && bridge.state['frame/part'].endsWith(` ${text}`), bridge.state['frame/part']);
    });
});

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { startProcess, until } from '../program.mjs';
import { nanoseconds } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { cell, states } from './cell.mjs';
import { Robot } from './robot.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { configurationMessages, gatewayMessages, robotMessages, rosMessages, silenceMessages } = messages;

const plan = (robot, points, options) => robot.publish('/plan', { header: { stamp: robot.time(robot.now()) }, joint_names: ['a'], points }, options);

describe('ros', () => {
  for (const ros of [1, 2])
    it(`Adapter_Ros${ros}_ForwardsJointStatesWithTheirTimeStamps`, async t => {
      const { robot, bridge } = await cell(t, { ros, aheadMs: 60_000 }, { launch: startProcess });
      const stamp = robot.now();

      robot.jointState(stamp, ['shoulder', 'elbow'], [0.25, -1.5], [0.5, null]);

      const [{ header, name, position, velocity }] = await states(bridge);
      assert.equal(nanoseconds(header.stamp), stamp);
      assert.deepEqual([name, position, velocity], [['shoulder', 'elbow'], [0.25, -1.5], [0.5, null]]);
    });

  it('Robot_SendsMoreThan2MiB_ReasonNamesTheLimitAndTheEntry', async t => {
    const { robot, bridge } = await cell(t);

    robot.publish('/robot_description', { data: `<robot>${'x'.repeat(2 * 1024 ** 2)}` });

    const tooLong = like(gatewayMessages.messageTooLong('rosbridge', 2));
    await until(() => tooLong.test(bridge.state?.reason), () => JSON.stringify(bridge.state));
    assert.match(bridge.state.reason, /plant\.topics\.robot_description/);
  });

  it('Adapter_StampDelay_IsSubtractedFromTheTimeStampsOfJointsFramesAndSignals', async t => {
    const rest = 'frames: [{ frame: part }, { frame: table }]\nsignals: [{ signal: force, topic: /force, type: geometry_msgs/WrenchStamped, field: wrench.force.z }]\n';
    const { robot, bridge } = await cell(t, {}, { plant: '  stamp_delay_ms: 100\n', rest }), stamp = robot.now(), header = { stamp: robot.time(stamp), frame_id: 'world' };
    await until(() => robot.isHeardBy('/force'), 'the subscription');
    const transforms = frame => [{ header, child_frame_id: frame, transform: { translation: { x: 1, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } } }];

    robot.jointState(stamp, ['shoulder'], [0.25]);
    robot.publish('/tf', { transforms: transforms('part') });
    robot.publish('/tf_static', { transforms: transforms('table') });
    robot.publish('/force', { header, wrench: { force: { z: 4 } } });

    const all = await until(() => {
      const [[joints], [tf], [fixed], [signals]] = ['/joint_states', '/tf', '/tf_static', '/signals'].map(topic => bridge.published(topic));
      return joints && tf && fixed && signals && [joints.header, tf.transforms[0].header, signals.header, fixed.transforms[0].header];
    }, () => JSON.stringify(bridge.state));
    assert.deepEqual(all.map(({ stamp: each }) => nanoseconds(each)), [...Array(3).fill(stamp - 100_000_000n), 0n]);
  });

  it('Adapter_Description_IsForwardedAndKept', async t => {
    const urdf = '<robot name="r"/>';
    const { robot, bridge } = await cell(t, { ros: 1 });

    robot.publish('/robot_description', { data: urdf }, { isLatched: true });
    await until(() => bridge.published('/robot_description').length === 1, 'the description');
    bridge.clients[0].terminate();

    await until(() => bridge.published('/robot_description').length === 2, 'the description after a reconnection');
    assert.deepEqual(bridge.published('/robot_description'), [{ data: urdf }, { data: urdf }]);
  });

  it('Adapter_DescriptionTooLong_IsANoticeUntilAShorterOneArrives', async t => {
    const { robot, bridge } = await cell(t), urdf = '<robot name="r"/>';

    robot.publish('/robot_description', { data: urdf + ' '.repeat(1024 * 1024) });
    await until(() => like(robotMessages.tooLarge('/robot_description', ANY, ANY)).test(bridge.state?.notice), () => JSON.stringify(bridge.state));
    assert.deepEqual([bridge.status.level, bridge.published('/robot_description')], [1, []]);
    robot.publish('/robot_description', { data: urdf });

    await until(() => bridge.state.notice === undefined && bridge.published('/robot_description').length > 0, () => JSON.stringify(bridge.state));
  });

  it('Adapter_Joints_AreRenamedAndFiltered', async t => {
    const rest = 'joints:\n  - { joint: arm_joint_1, source: axis/1, scale: -1, offset: 0.5 }\n  - { joint: arm_joint_2 }\n';
    const { robot, bridge } = await cell(t, {}, { rest, plant: '  topics: { joint_trajectory: /controller/joint_trajectory }\n' });
    const names = ['other', 'arm_joint_2', 'axis/1'];
    await until(() => robot.isHeardBy('/controller/joint_trajectory'), 'the subscription');

    robot.jointState(robot.now(), names, [9, 2, 1], [9, 0.2, 0.1]);
    robot.publish('/controller/joint_trajectory', {
      header: { stamp: robot.time(robot.now()), frame_id: '' }, joint_names: names,
      points: [{ positions: [9, 2, 1], velocities: [], accelerations: [], time_from_start: { sec: 1, nanosec: 0 } }],
    });

    const [{ name, position, velocity }] = await states(bridge);
    assert.deepEqual([name, position, velocity], [['arm_joint_2', 'arm_joint_1'], [2, -0.5], [0.2, -0.1]]);
    const [trajectory] = await until(() => bridge.published('/joint_trajectory').length && bridge.published('/joint_trajectory'), 'the trajectory');
    assert.deepEqual(trajectory.joint_names, ['arm_joint_2', 'arm_joint_1']);
    assert.deepEqual(trajectory.points[0], { positions: [2, -0.5], velocities: [], accelerations: [], time_from_start: { sec: 1, nanosec: 0 } });
  });

  it('SetPoints_ArriveBeforeTheClock_AreSentAfterItAndAfterAReconnection', async t => {
    const robot = await Robot.start(t, { aheadMs: 60_000 });
    plan(robot, [{ positions: [1], time_from_start: { sec: 1, nanosec: 0 } }], { isLatched: true });
    const { bridge } = await cell(t, { robot }, { plant: '  topics: { joint_trajectory: /plan }\n' });
    const sent = () => bridge.heard.filter(({ op, topic }) => op === 'publish' && topic === '/joint_trajectory');
    await until(() => sent().length === 1, 'the set-points');

    bridge.clients[0].terminate();

    await until(() => sent().length === 2, 'the set-points after a reconnection');
    const offered = bridge.heard.findIndex(({ op }) => op === 'advertise_service');
    assert.ok(bridge.heard.indexOf(sent()[0]) > offered, JSON.stringify(bridge.heard.map(({ op, topic }) => [op, topic])));
  });

  it('SetPoints_StampZero_HaveTheTimeOfTheirArrivalOnTheRobotsClock', async t => {
    const { robot, bridge, adapter } = await cell(t, { aheadMs: 3_600_000 }, { plant: '  topics: { joint_trajectory: /plan }\n' });
    await until(() => robot.isHeardBy('/plan'), () => adapter.err);
    const started = robot.now();

    // A stamp of 0 means that the motion begins at once.
    robot.publish('/plan', { header: { stamp: robot.time(0n), frame_id: 'base' }, joint_names: ['a'], points: [{ positions: [1], time_from_start: { sec: 1, nanosec: 0 } }] });

    const [{ header }] = await until(() => bridge.published('/joint_trajectory').length > 0 && bridge.published('/joint_trajectory'), () => JSON.stringify(bridge.state));
    assert.ok(Math.abs(Number(nanoseconds(header.stamp) - started)) < 60e9, JSON.stringify(header));
    assert.equal(header.frame_id, 'base');
  });

  it('SetPoints_RobotDisconnectedSince_AreNotSentAgainAfterAReconnection', async t => {
    const { robot, bridge, adapter } = await cell(t, {}, { plant: '  topics: { joint_trajectory: /plan }\n' });
    plan(robot, [{ positions: [1], time_from_start: { sec: 1, nanosec: 0 } }]);
    await until(() => bridge.published('/joint_trajectory').length === 1, 'the set-points');
    await robot.stop();
    await adapter.said('waiting: ');
    const before = bridge.heard.length;

    bridge.clients[0].terminate();

    await until(() => bridge.heard.slice(before).some(({ op, topic }) => op === 'publish' && topic === '/nowpose/diagnostics'), 'the reconnection');
    assert.equal(bridge.published('/joint_trajectory').length, 1);
  });

  for (const [name, send, reason] of [
    ['WithoutStamp', robot => robot.publish('/joint_states', { header: {}, name: ['a'], position: [1] }), 'stamp-missing'],
    ['ZeroStamp', robot => robot.jointState(0n, ['a'], [1]), 'stamp-zero'],
    ['FutureStamp', robot => robot.jointState(robot.now() + 5_000_000_000n, ['a'], [1]), 'stamp-future'],
    ['OldStamp', robot => robot.jointState(robot.now() - 60_000_000_000n, ['a'], [1]), 'stamp-old'],
    ['NaN', robot => robot.jointState(robot.now(), ['a'], [null]), 'not-finite'],
    ['ListsOfDifferentLengths', robot => robot.jointState(robot.now(), ['a', 'b'], [1]), 'malformed'],
    ['PositionNotANumber', robot => robot.jointState(robot.now(), ['a'], [{ toString: 1 }]), 'not-finite'],
    ['PlanWithoutPoint', robot => plan(robot, [null]), 'malformed'],
    ['PlannedPositionNotANumber', robot => plan(robot, [{ positions: [{ toString: 1, valueOf: 1 }] }]), 'malformed'],
    ['NotARobotDescription', robot => robot.publish('/robot_description', { data: 'not yet' }), 'malformed'],
  ])
    it(`Adapter_${name}_RefusesTheMessageWithAReason`, async t => {
      const { robot, bridge } = await cell(t, {}, { plant: '  topics: { joint_trajectory: /plan }\n' });

      send(robot);

      await until(() => bridge.state?.[`refused/${reason}`] === '1', () => JSON.stringify(bridge.state));
      assert.deepEqual([bridge.jointStates, bridge.published('/robot_description')], [[], []]);
    });

  it('Adapter_MessageWithEffortsOnly_IgnoresItWithoutRefusal', async t => {
    const { robot, bridge } = await cell(t);

    robot.publish('/joint_states', { header: { stamp: robot.time(robot.now()) }, name: ['wheel'], position: [], effort: [3] });
    robot.jointState(robot.now(), ['a'], [1]);

    await states(bridge);
    await until(() => bridge.state?.samples === '1', () => JSON.stringify(bridge.state));
    assert.equal(bridge.state.refused, '0');
  });

  it('Joint_PublisherStopsAndContinues_IsInFaultThenLive', async t => {
    const { robot, bridge, adapter } = await cell(t), silent = new Set();
    const publishing = setInterval(() => ['a', 'b'].filter(name => !silent.has(name)).forEach(name => robot.jointState(robot.now(), [name], [1])), 50);
    t.after(() => clearInterval(publishing));
    const state = (name, expected) => until(() => bridge.joint(name)?.state === expected && bridge.joint(name), () => JSON.stringify(bridge.state));
    await Promise.all([state('a', 'live'), state('b', 'live')]);

    silent.add('a');
    const { reason } = await state('a', 'fault');

    assert.equal(reason, silenceMessages.tooLong(1000));
    await state('b', 'live');
    assert.deepEqual([bridge.status.level, bridge.status.message.startsWith('a fault: ')], [2, true]);
    silent.clear();
    await state('a', 'live');
    await until(() => bridge.status.level === 0, () => JSON.stringify(bridge.status));
    await robot.stop();
    await state('b', 'fault');
    assert.ok(adapter.err.includes('a fault: '), adapter.err);
  });

  it('Adapter_RobotDisconnectsAndReturns_ReadsAgain', async t => {
    const { robot, bridge, adapter } = await cell(t);

    await robot.stop();
    await adapter.said('waiting: ');
    await robot.listen(robot.port);
    await until(() => robot.isHeardBy('/joint_states'), 'the subscription');
    robot.jointState(robot.now(), ['a'], [1]);

    await states(bridge);
    await until(() => bridge.state?.state === 'connected' && Number(bridge.state.reconnects) > 0, () => JSON.stringify(bridge.state));
  });

  it('Topics_TypesInTheFormOfRos2_AreSubscribedWithRos1', async t => {
    const { robot, bridge, adapter } = await cell(t, { ros: 1 }, { rest: `frames: [{ frame: part, topic: /part, type: geometry_msgs/msg/PoseStamped }]
signals: [{ signal: closed, topic: /closed, type: std_msgs/msg/Bool }]
` });

    await until(() => robot.isHeardBy('/part') && robot.isHeardBy('/closed'), () => `${JSON.stringify(bridge.state)}\n${adapter.err}`);
  });

  for (const [name, data, isStamped] of [['WithoutHeader', { data: [100, -200, 300, 90, 0, 90] }, false], ['WithHeader', { pose: [100, -200, 300, 90, 0, 90] }, true]])
    it(`Frame_ThreeAngles${name}_IsForwardedAsAQuaternionInItsParent`, async t => {
      const field = isStamped ? 'pose' : 'data';
      const { robot, bridge, adapter } = await cell(t, { aheadMs: 3_600_000 }, { rest: `frames:
  - frame: rack
    topic: /rack/pose
    type: cell_msgs/Pose6
    parent: arm2/tool0
    position: { unit: mm, x: { field: ${field}.0 }, y: { field: ${field}.1 }, z: { field: ${field}.2 } }
    angles: { order: zyx, axes: moving, unit: deg, values: [{ field: ${field}.3 }, { field: ${field}.4 }, { field: ${field}.5 }] }
  - { frame: stand, position: { unit: m, x: 1, y: 0, z: 0.5 } }
` });
      await until(() => robot.isHeardBy('/rack/pose'), () => adapter.err);
      const stamp = robot.now();

      robot.publish('/rack/pose', isStamped ? { header: { stamp: robot.time(stamp) }, ...data } : data);

      await until(() => bridge.published('/tf').length > 0, () => adapter.err);
      const [{ transforms: [{ header, child_frame_id: child, transform: { translation, rotation } }] }] = bridge.published('/tf');
      assert.deepEqual([child, header.frame_id], ['rack', 'arm2/tool0']);
      for (const [axis, expected] of [['x', 0.1], ['y', -0.2], ['z', 0.3]]) assert.ok(Math.abs(translation[axis] - expected) < 1e-12, axis);
      // 90° about z, then 90° about the turned x axis: Rz(90°) Rx(90°).
      for (const axis of ['x', 'y', 'z', 'w']) assert.ok(Math.abs(rotation[axis] - 0.5) < 1e-12, axis);
      if (isStamped) assert.equal(nanoseconds(header.stamp), stamp);
      // The adapter's estimate of the robot's clock may be wrong by half of a round-trip time, which a busy machine lengthens.
      else assert.ok(Math.abs(Number(nanoseconds(header.stamp) - stamp)) < 60e9, 'the time of arrival on the clock of the robot');
      const [{ transforms: [stationary] }] = bridge.published('/tf_static');
      assert.deepEqual([stationary.child_frame_id, stationary.transform.translation], ['stand', { x: 1, y: 0, z: 0.5 }]);
    });

  it('Frame_CovarianceNotANumber_IsForwarded', async t => {
    const { robot, bridge, adapter } = await cell(t, {}, { rest: 'frames: [{ frame: part, topic: /part, type: geometry_msgs/PoseWithCovarianceStamped }]\n' });
    await until(() => robot.isHeardBy('/part'), () => adapter.err);
    const pose = { position: { x: 1, y: 2, z: 3 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };

    robot.publish('/part', {
      header: { stamp: robot.time(robot.now()), frame_id: 'say NaN, "-Infinity"' }, pose: { pose, covariance: Float64Array.of(NaN, Infinity, -Infinity, 0) },
    });

    await until(() => bridge.published('/tf').length > 0, () => JSON.stringify(bridge.state));
    const [{ transforms: [{ header, transform }] }] = bridge.published('/tf');
    assert.deepEqual([header.frame_id, transform.translation], ['say NaN, "-Infinity"', pose.position]);
  });

  it('Adapter_MessageNotJson_IsCountedAndLogged', async t => {
    const { robot, bridge, adapter } = await cell(t);

    robot.sendText('{"op":"publish","topic":"/joint_states","msg":{');

    await until(() => bridge.state?.['refused/malformed'] === '1', () => JSON.stringify(bridge.state));
    await adapter.said(gatewayMessages.notJson);
  });

  for (const [name, text, expected] of [
    ['FrameWithoutTopic', 'plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\nframes:\n  - frame: a\n    position: { unit: m, x: { field: data.0 }, y: 0, z: 0 }\n', `line 5: frames[0].topic: ${rosMessages.noTopic}`],
    ['FrameWithSource', 'plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\nframes:\n  - frame: a\n    source: b\n    position: { unit: m, x: 0, y: 0, z: 0 }\n', `line 6: frames[0].source: ${rosMessages.sourceAndPosition}`],
    ['FrameWithAnglesOnly', 'plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\nframes:\n  - frame: a\n    angles: { order: zyx, axes: moving, unit: deg, values: [0, 0, 0] }\n', 'line 5: frames[0].position: missing, but angles needs it'],
    ['InvalidFrameType', 'plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\nframes:\n  - frame: a\n    topic: /a\n    type: std_msgs/Float64MultiArray\n', 'line 7: frames[0].type: value "std_msgs/Float64MultiArray"; '],
    ['UnencryptedToAnotherMachine', 'plant:\n  kind: ros\n  endpoint: ws://192.168.0.30:9090\n', `line 1: plant.plain: ${configurationMessages.notPlain('ws')}`],
    ['InvalidEndpoint', 'plant:\n  kind: ros\n  endpoint: http://192.168.0.30\n', 'line 3: plant.endpoint: value "http://192.168.0.30"; '],
    ['PinWithoutTls', `plant:\n  kind: ros\n  endpoint: ws://127.0.0.1\n  pin: sha256/${'A'.repeat(43)}=\n`, `line 4: plant.pin: ${configurationMessages.pinWithoutTls}`],
    ['InvalidPort', 'plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:90900\n', `line 3: plant.endpoint: ${configurationMessages.address('ws://127.0.0.1:90900')}`],
    ['InvalidTopic', 'plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\n  topics: { joint_states: joint states }\n', 'line 4: plant.topics.joint_states: value '],
    ['SourceTwice', 'plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\njoints:\n  - joint: a\n  - joint: b\n    source: a\n', `line 6: joints[1]: ${rosMessages.sourceTwice('a')}`],
  ])
    it(`Check_${name}_NamesItsLine`, () => {
      const lines = wrongIn(temporaryFile('ros.yaml', text));

      assert.ok(lines[0].includes(`, ${expected}`), lines[0]);
    });
});

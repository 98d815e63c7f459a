// Runs the adapter between test doubles of a controller and of a gateway.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check, startProcess, until } from '../program.mjs';
import { temporaryFile } from '../temporary.mjs';
import { angle, LAG_S, RtdeRobot } from './robot.mjs';
import { ANY, like, messages } from '../messages.mjs';
import { ARMS, JOINTS, cell, configuration, plantLines, seconds, statesOf } from './cell.mjs';

const { configurationMessages, fieldMessages, robotMessages, rtdeMessages, rtdeSettingMessages } = messages;

describe('rtde adapter', () => {
  it('Adapter_DataPackages_ArePublishedWithTheirTimestamp', async t => {
    const { bridge, robot } = await cell(t, undefined, { launch: startProcess });

    const states = await statesOf(bridge, 100);

    for (const { header, name, position, velocity } of states) {
      const time = seconds(header.stamp);
      assert.deepEqual(name, JOINTS);
      position.forEach((value, i) => assert.ok(Math.abs(value - angle(i, time)) < 1e-9, `${name[i]} at ${time}: ${value}`));
      velocity.forEach((value, i) => assert.ok(Math.abs(value - (0.9 + 0.1 * i) * 0.4 * Math.cos((0.9 + 0.1 * i) * time)) < 1e-6));
    }
    assert.deepEqual([...new Set(robot.frequencies)], [125]);
    assert.deepEqual([...new Set(robot.requests)].sort(), ['O', 'S', 'V', 'v']);
    assert.equal(bridge.state.controller, '5.11.1.108318');
  });

  it('Adapter_JointsConfigured_PublishesTheirConfiguredNames', async t => {
    const rest = 'joints: [{ joint: wrist, index: 5 }, { joint: base, index: 0 }]\n';
    const { bridge } = await cell(t, undefined, { rest, more: ', positions: target' });

    const { header, name, position } = (await statesOf(bridge)).at(0);

    assert.deepEqual(name, ['wrist', 'base']);
    assert.ok(Math.abs(position[0] - angle(5, seconds(header.stamp) + LAG_S)) < 1e-9);
  });

  it('Adapter_ControllerSlowerThanRequested_ReportsItAndPublishesAllSamples', async t => {
    const { bridge, robot } = await cell(t, new RtdeRobot({ rateHz: 20 }));

    const states = await statesOf(bridge, 40);

    for (const { header, position } of states) assert.ok(Math.abs(position[0] - angle(0, seconds(header.stamp))) < 1e-9);
    await until(() => bridge.state?.notice === rtdeMessages.slow(125), () => JSON.stringify(bridge.state));
    const before = robot.now, { values } = await bridge.call('/nowpose/plant_time/arm');
    const time = seconds(values.sent);
    assert.ok(time >= before - 0.05 && time <= robot.now + 0.05, `${before} ${time} ${robot.now}`);
  });

  it('Signals_OfInputsAndOutputs_ArePublishedWithTheTimeOfTheirChange', async t => {
    const rest = 'signals:\n  - { signal: closed, field: actual_digital_output_bits, bit: 3 }\n  - { signal: voltage, field: tool_output_voltage }\n';
    const { bridge, robot } = await cell(t, undefined, { rest, more: ', rate_hz: 50' });
    const changes = () => bridge.published('/signals').flatMap(({ header, name, value }) => name.map((each, i) => [each, value[i], seconds(header.stamp)]));
    await until(() => changes().length >= 2, 'two signals');

    const before = robot.now;
    robot.outputBits = 0b1000;

    const [, , time] = await until(() => changes().find(([name, value]) => name === 'closed' && value === 1), 'a change');
    assert.ok(time >= before - 0.003 && time <= robot.now, `${before} ${time} ${robot.now}`);
    assert.deepEqual(new Map(changes().map(([name, value]) => [name, value])), new Map([['closed', 1], ['voltage', 24]]));
    await until(() => bridge.state?.['signal/closed']?.startsWith('live'), 'a live signal');
  });

  it('Signals_ControllerRestarted_AreSentAgainWithTheNewTime', async t => {
    const { bridge, robot } = await cell(t, undefined, { rest: 'signals: [{ signal: closed, field: actual_digital_output_bits, bit: 0 }]\n' });
    robot.outputBits = 1;
    const newest = () => bridge.published('/signals').filter(({ value }) => value[0] === 1).at(-1);
    await until(newest, 'a signal');

    robot.restart();

    await until(() => seconds(newest().header.stamp) < 50, 'the signal on the new time');
  });

  it('Signal_UnknownToTheController_IsReportedAndOthersAreRead', async t => {
    const rest = 'signals:\n  - { signal: none, field: no_such_field }\n  - { signal: wrong, field: actual_q }\n  - { signal: closed, field: actual_digital_output_bits, bit: 1 }\n';
    const { bridge, adapter } = await cell(t, undefined, { rest });
    await statesOf(bridge, 10);

    await until(() => bridge.status?.level === 2 && bridge.state['signal/closed'].startsWith('live'), 'an error and a live signal');
    await until(() => bridge.published('/signals').length > 0, 'a signal');

    assert.ok(bridge.state['signal/none'].endsWith(fieldMessages.unknown('no_such_field')), bridge.state['signal/none']);
    assert.ok(bridge.state['signal/wrong'].endsWith(fieldMessages.index('actual_q', 6)), bridge.state['signal/wrong']);
    for (const name of ['none', 'wrong']) assert.match(bridge.state[`signal/${name}`], /^missing /);
    assert.match(bridge.joint('elbow_joint').state, /live/);
    assert.equal(adapter.err.match(/none missing/g).length, 1, adapter.err);
  });

  it('Frame_ReadFromTheToolPose_IsPublishedWithItsTimestamp', async t => {
    const robot = new RtdeRobot();
    // The last three numbers are a rotation by π about the axis (0, 0.6, 0.8).
    robot.toolPose = [0.4, -0.1, 0.3, 0, 0.6 * Math.PI, 0.8 * Math.PI];
    const { bridge } = await cell(t, robot, { rest: 'frames: [{ frame: tcp, field: actual_TCP_pose }]\n' });

    const { transforms: [{ header, child_frame_id: child, transform: { translation, rotation } }] } = await until(() => bridge.published('/tf').at(-1), 'a pose');

    assert.deepEqual([header.frame_id, child, translation], ['world', 'tcp', { x: 0.4, y: -0.1, z: 0.3 }]);
    Object.values(rotation).forEach((part, i) => assert.ok(Math.abs(part - [0, 0.6, 0.8, 0][i]) < 1e-12, JSON.stringify(rotation)));
    await until(() => bridge.jointStates.some(state => seconds(state.header.stamp) === seconds(header.stamp)), 'the joints with the same stamp');
  });

  it('Adapter_MovingArm_ReportsTheLagBehindTheCommand', async t => {
    const { bridge } = await cell(t);

    await until(() => bridge.state?.following_ms !== undefined, 'a lag');

    assert.ok(Math.abs(Number(bridge.state.following_ms) - 1000 * LAG_S) <= 0.1, bridge.state.following_ms);
  });

  it('Adapter_ControllerFasterThanConfigured_ReadsAtTheConfiguredInterval', async t => {
    const { bridge, robot } = await cell(t, new RtdeRobot({ rateHz: 500 }), { more: ', rate_hz: 50' });

    const stamps = (await statesOf(bridge, 20)).map(state => seconds(state.header.stamp));

    assert.ok(stamps.slice(1).every((stamp, i) => stamp - stamps[i] > 0.0194), stamps.join());
    assert.deepEqual(robot.frequencies, [50]);
  });

  it('Adapter_Cb3_RequestsAtMost125Hz', async t => {
    const { bridge, robot } = await cell(t, new RtdeRobot({ version: [3, 15, 8, 1] }), { more: ', rate_hz: 500' });

    await statesOf(bridge);

    assert.deepEqual([...new Set(robot.frequencies)], [125]);
  });

  it('Clock_Offered_ErrorIsWithinItsBound', async t => {
    const { bridge, robot } = await cell(t);
    await statesOf(bridge, 20);

    for (let i = 0; i < 20; i++) {
      // On a busy machine, the clock may be unavailable for a moment.
      const { before, values, after } = await until(async () => {
        const before = robot.now, { result, values } = await bridge.call('/nowpose/plant_time/arm');
        return result && { before, values, after: robot.now };
      }, 'the clock');
      const bound = values.error_bound_ns / 1e9, time = seconds(values.sent);

      assert.ok(time >= before - bound && time <= after + bound, `${before} ${time} ${after} ± ${bound}`);
      assert.deepEqual([values.received, values.synchronised, values.resolution_ns], [values.sent, true, 1]);
      assert.ok(bound > 0);
    }
  });

  it('Clock_ControllerDoesNotAnswerWhileStreaming_IsStillOffered', async t => {
    const { bridge, robot } = await cell(t, new RtdeRobot({ isAnsweringWhileStreaming: false, version: null }));
    await statesOf(bridge, 400);

    const before = robot.now, { values } = await bridge.call('/nowpose/plant_time/arm'), after = robot.now, bound = values.error_bound_ns / 1e9;

    assert.ok(seconds(values.sent) >= before - bound && seconds(values.sent) <= after + bound);
    const asked = robot.requests.length;
    await statesOf(bridge, bridge.jointStates.length + 100);
    assert.equal(robot.requests.length, asked);
  });

  it('Controller_WithoutOptionalFields_IsReadWithoutThem', async t => {
    const { bridge, robot, adapter } = await cell(t, new RtdeRobot({ missing: ['actual_qd', 'safety_mode', 'robot_mode'] }));

    const [{ velocity }] = await statesOf(bridge);

    assert.deepEqual(velocity, []);
    assert.deepEqual(robot.recipes.at(-1), ['timestamp', 'actual_q', 'target_q', 'target_qd', 'runtime_state', 'safety_status_bits']);
    assert.ok(adapter.err.includes(fieldMessages.readWithout(fieldMessages.missing(['actual_qd', 'robot_mode', 'safety_mode']))), adapter.err);
  });

  it('Controller_Restarted_IsReadWithItsNewTime', async t => {
    const { bridge, robot, adapter } = await cell(t);
    await statesOf(bridge, 20);

    robot.restart();

    await adapter.said(like(rtdeMessages.restarted(ANY, ANY)));
    await until(() => seconds(bridge.jointStates.at(-1).header.stamp) < 50, 'samples on the new time');
    const { header, position } = bridge.jointStates.at(-1);
    assert.ok(Math.abs(position[2] - angle(2, seconds(header.stamp))) < 1e-9);
    assert.ok(seconds((await bridge.call('/nowpose/plant_time/arm')).values.sent) < 50);
    assert.equal(plantLines(adapter).length, 3, adapter.err);
    assert.doesNotMatch(adapter.err, /refused \(/);
  });

  it('Check_ValidFile_ListsTheDataThatTheAdapterReads', async t => {
    const { status, out } = await check(t, configuration({ url: 'ws://127.0.0.1:1', port: 30004, rest: 'robot: ur5e\n' }));

    assert.equal(status, 0);
    assert.match(out, like(rtdeSettingMessages.summary('127.0.0.1:30004', 'actual', 125, `joints shoulder_pan_joint, ${ANY}, wrist_3_joint`)));
  });

  for (const [what, yaml, text] of [
    ['NoHost', 'plant: { kind: rtde }', 'line 1: plant.host: missing; '],
    ['HostWithPort', 'plant: { kind: rtde, host: "10.0.0.1:30004" }', 'plant.host: value "10.0.0.1:30004"; '],
    ['HostWithScheme', 'plant: { kind: rtde, host: "tcp://10.0.0.1" }', 'plant.host: value "tcp://10.0.0.1"; '],
    ['TooFast', 'plant: { kind: rtde, host: ur, rate_hz: 1000 }', 'plant.rate_hz: value 1000; '],
    ['SeventhJoint', 'plant: { kind: rtde, host: ur }\njoints: [{ joint: a, index: 6 }]', 'joints[0].index: value 6; '],
    ['JointTwice', 'plant: { kind: rtde, host: ur }\njoints:\n  - { joint: a, index: 1 }\n  - { joint: b, index: 1 }', `line 4: joints[1].index: ${rtdeSettingMessages.indexTwice(1, 3)}`],
    ['SignalWithoutField', 'plant: { kind: rtde, host: ur }\nsignals: [{ signal: a }]', 'signals[0].field: missing; '],
    ['SignalTwice', 'plant: { kind: rtde, host: ur }\nsignals:\n  - { signal: a, field: b }\n  - { signal: a, field: c }', `line 4: signals[1].signal: ${configurationMessages.nameTwice('a', 3, 'signal')}`],
    ['Bit64', 'plant: { kind: rtde, host: ur }\nsignals: [{ signal: a, field: b, bit: 64 }]', 'signals[0].bit: value 64; '],
    ['TooManyFields', `plant: { kind: rtde, host: ur }\nsignals:\n${Array.from({ length: 100 }, (_, i) => `  - { signal: s${i}, field: output_double_register_${i} }\n`).join('')}`,
      `line 2: signals: ${rtdeSettingMessages.recipeTooLong(ANY, 2048)}`],
    ['CalibrationOfAnotherRobot', 'plant: { kind: rtde, host: ur, calibration: true }\nrobot: youbot\njoints: []', `line 2: robot: ${rtdeSettingMessages.notCalibrated('youbot', ARMS)}`],
    ['CalibrationWithoutRobot', 'plant: { kind: rtde, host: ur, calibration: true }', `robot: ${rtdeSettingMessages.notCalibrated('', ARMS)}`],
    ['FrameOfAnotherField', 'plant: { kind: rtde, host: ur }\nframes: [{ frame: a, field: actual_q }]', 'frames[0].field: value "actual_q"; '],
    ['AnotherRobotsJoints', 'plant: { kind: rtde, host: ur }\nrobot: youbot', `line 1: joints[0].joint: ${robotMessages.noJoint('shoulder_pan_joint', 'gripper_palm_joint')}`],
  ])
    it(`Check_${what}_NamesTheEntry`, () => {
      const lines = wrongIn(temporaryFile('rtde.yaml', yaml));

      assert.ok(lines.length > 0);
      assert.match(lines[0], like(text));
    });
});

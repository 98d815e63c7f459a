// Runs the adapter as a process that connects test doubles of a controller and of a gateway.
import assert from 'node:assert/strict';
import { createServer } from 'node:net';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check, start, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { seeded } from '../seeded.mjs';
import { temporaryFile } from '../temporary.mjs';
import { byte, packageOf } from './bytes.mjs';
import { angle, LAG_S, RtdeRobot } from './robot.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { configurationMessages, fieldMessages, robotMessages, robotStateMessages, rtdeMessages, rtdeSettingMessages, safetyStops } = messages;

const ARMS = ['ur3e', 'ur5e', 'ur10e', 'ur16e', 'ur5'];
const JOINTS = ['shoulder_pan_joint', 'shoulder_lift_joint', 'elbow_joint', 'wrist_1_joint', 'wrist_2_joint', 'wrist_3_joint'];

const configuration = ({ url, port, host = '127.0.0.1', more = '', rest = '' }) =>
  temporaryFile('rtde.yaml', `gateway: { url: "${url}" }\nplant: { kind: rtde, name: arm, host: "${host}", port: ${port}${more} }\n${rest}`);

/** Starts a controller, a gateway, and an adapter that connects them. */
async function cell(t, robot = new RtdeRobot(), { more, rest } = {}) {
  await robot.listen(t);
  const bridge = await RosbridgeDouble.start(t);
  return { robot, bridge, adapter: start(t, [configuration({ url: bridge.url, port: robot.port, more, rest })]) };
}

const statesOf = (bridge, count = 1) => until(() => bridge.jointStates.length >= count && bridge.jointStates, () => `${count} joint states; ${JSON.stringify(bridge.state)}`);

const seconds = stamp => Number(nanoseconds(stamp)) / 1e9;

/** Returns the log lines of the adapter about the state of its plant. */
const plantLines = adapter => adapter.err.split('\n').filter(line => /\[plant\/arm\] (waiting|refused|connected)/.test(line));

describe('rtde adapter', { concurrency: 4 }, () => {
  it('Adapter_DataPackages_ArePublishedWithTheirTimestamp', async t => {
    const { bridge, robot } = await cell(t);

    const states = await statesOf(bridge, 100);

    for (const { header, name, position, velocity } of states) {
      const time = seconds(header.stamp);
      assert.deepEqual(name, JOINTS);
      position.forEach((value, i) => assert.ok(Math.abs(value - angle(i, time)) < 1e-9, `${name[i]} at ${time}: ${value}`));
      velocity.forEach((value, i) => assert.ok(Math.abs(value - (0.9 + 0.1 * i) * 0.4 * Math.cos((0.9 + 0.1 * i) * time)) < 1e-6));
    }
    assert.deepEqual(robot.frequencies, [125]);
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

    await until(() => bridge.published('/signals').length > 0 && bridge.status?.level === 2, 'a signal and an error');

    assert.ok(bridge.state['signal/none'].endsWith(fieldMessages.unknown('no_such_field')), bridge.state['signal/none']);
    assert.ok(bridge.state['signal/wrong'].endsWith(fieldMessages.index('actual_q', 6)), bridge.state['signal/wrong']);
    for (const name of ['none', 'wrong']) assert.match(bridge.state[`signal/${name}`], /^missing /);
    assert.match(bridge.state['signal/closed'], /^live/);
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

    assert.deepEqual(robot.frequencies, [125]);
  });

  it('Clock_Offered_ErrorIsWithinItsBound', async t => {
    const { bridge, robot } = await cell(t);
    await statesOf(bridge, 20);

    for (let i = 0; i < 20; i++) {
      const before = robot.now, { values } = await bridge.call('/nowpose/plant_time/arm'), after = robot.now;
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

  it('Robot_InProtectiveStop_IsReportedAndPositionsContinue', async t => {
    const { bridge, robot, adapter } = await cell(t);
    await statesOf(bridge);

    robot.state = { runtime: 1, mode: 7, safety: 3, bits: 1 << 2 };

    await until(() => bridge.status?.level === 1, 'a warning');
    assert.ok(bridge.status.message.endsWith(safetyStops[3]), bridge.status.message);
    assert.equal(bridge.joint('elbow_joint').state, 'live');
    await statesOf(bridge, bridge.jointStates.length + 20);
    robot.state = { runtime: 2, mode: 7, safety: 1, bits: 1 };
    await until(() => bridge.status.level === 0, 'no warning');
    const lines = adapter.err.split('\n').filter(line => /protective|program/.test(line));
    assert.deepEqual(lines.map(line => line.slice(12)), [
      robotStateMessages.programStopped('stopped'), safetyStops[3], robotStateMessages.programRuns, `ended: ${safetyStops[3]}`,
    ]);
  });

  it('Robot_WithoutPower_SendsNoPositionsUntilPowerOn', async t => {
    const robot = new RtdeRobot({ stands: true });
    Object.assign(robot.state, { mode: 3, runtime: 1 });
    const { bridge, adapter } = await cell(t, robot);

    await adapter.said(`waiting: ${robotStateMessages.noPower('power off')}`);
    await until(() => bridge.state?.program === 'stopped', 'the state of the program');
    assert.deepEqual(bridge.jointStates, []);
    assert.doesNotMatch(adapter.err, /program/);
    robot.state.mode = 7;

    await statesOf(bridge);
    assert.equal(plantLines(adapter).length, 2, adapter.err);
    assert.equal(adapter.err.split(robotStateMessages.programStopped('stopped')).length, 2, adapter.err);
  });

  for (const [what, safety, bits] of [['SafetyMode', 4, 0], ['SafetyBit', null, 1 << 3]])
    it(`Robot_InRecovery_IsRecognisedByThe${what}`, async t => {
      const robot = new RtdeRobot({ missing: safety === null ? ['safety_mode'] : [] });
      Object.assign(robot.state, { safety: safety ?? 0, bits });
      const { bridge } = await cell(t, robot);

      await until(() => bridge.status?.level === 1, 'a warning');

      assert.ok(bridge.status.message.endsWith(safetyStops[4]), bridge.status.message);
      await statesOf(bridge);
    });

  it('Robot_MovesInAModeWithoutPower_PositionsAreRead', async t => {
    const robot = new RtdeRobot();
    robot.state.mode = 0;

    const { bridge } = await cell(t, robot);

    await statesOf(bridge);
  });

  it('Packages_Lost_AreLoggedOnce', async t => {
    const { bridge, adapter } = await cell(t, new RtdeRobot({ losesEach: 5 }));

    await until(() => Number(bridge.state?.['refused/package-lost']) > 5, 'lost packages');

    assert.equal(adapter.err.split(rtdeMessages.lostPackages).length, 2, adapter.err);
    assert.equal(bridge.status.level, 0);
  });

  for (const [what, bytes, text] of [
    ['WithBytesThatAreNoPackage', Buffer.alloc(64), rtdeMessages.damaged(ANY)],
    ['WithAPackageOfAnotherSize', packageOf('U', byte(1), 'short'), rtdeMessages.invalidData(ANY, fieldMessages.packageSize(6, ANY))],
  ])
    it(`Stream_${what}_AdapterReadsAgain`, async t => {
      const { bridge, robot, adapter } = await cell(t);
      await statesOf(bridge, 10);

      robot.send(bytes);

      await until(() => plantLines(adapter).length === 3, () => `three lines; ${adapter.err}`);
      assert.match(plantLines(adapter)[1], like(`waiting: ${text}`));
      await statesOf(bridge, bridge.jointStates.length + 10);
    });

  it('Controller_TextMessage_IsLogged', async t => {
    const { bridge, robot, adapter } = await cell(t);
    await statesOf(bridge);

    robot.send(packageOf('M', byte(4), 'tool', byte(2), 'UR', byte(1)));

    await adapter.said(rtdeMessages.message('UR: tool'));
  });

  for (const [what, robot, text, state] of [
    ['WithVersion1Only', { accepts: 1 }, rtdeMessages.oldProtocol(ANY), 'refused'],
    ['WithoutAField', { missing: ['actual_q'] }, fieldMessages.needed('actual_q'), 'refused'],
    ['WithAFieldOfAnotherType', { types: { actual_q: 'DOUBLE' } }, fieldMessages.otherType('actual_q', 'DOUBLE', 'VECTOR6D'), 'refused'],
    ['ThatNeverAnswers', { isMute: true }, rtdeMessages.noRtdeAnswer(ANY), 'refused'],
    ['WithHalfPackages', { sendsHalf: true }, rtdeMessages.halfPackage(ANY, 2), 'waiting'],
    ['ThatClosesTheConnection', { onConnection: socket => socket.destroy() }, rtdeMessages.endedBeforeAnswer(rtdeMessages.ended(ANY)), 'waiting'],
    ['ThatSendsGarbage', { isMute: true, onConnection: pour }, rtdeMessages.notRtde(ANY), 'refused'],
  ])
    it(`Controller_${what}_IsLoggedInOneLineAndRetried`, async t => {
      let connections = 0;
      const double = new RtdeRobot(robot), { bridge, adapter } = await cell(t, double);
      double.onConnection = socket => {
        connections++;
        robot.onConnection?.(socket);
      };

      await until(() => connections >= 3 && plantLines(adapter).length > 0, () => `three attempts; ${adapter.err}`);

      const lines = plantLines(adapter);
      assert.equal(lines.length, 1, adapter.err);
      assert.match(lines[0], like(`] ${state}: ${text}`));
      await until(() => bridge.status?.level === 2, 'an error in the diagnostics');
      assert.deepEqual(bridge.jointStates, []);
    });

  it('Host_DoesNotExist_IsLoggedInOneLine', async t => {
    const bridge = await RosbridgeDouble.start(t), adapter = start(t, [configuration({ url: bridge.url, host: 'no-such-robot.invalid', port: 30004 })]);

    await adapter.said(rtdeMessages.unknownHost('no-such-robot.invalid'));

    assert.equal(plantLines(adapter).length, 1);
  });

  it('Port_Closed_IsLoggedInOneLineAndConnectedWhenItOpens', async t => {
    const free = createServer();
    await new Promise(resolve => free.listen(0, '127.0.0.1', resolve));
    const { port } = free.address(), bridge = await RosbridgeDouble.start(t);
    await new Promise(resolve => free.close(resolve));
    const adapter = start(t, [configuration({ url: bridge.url, port })]);

    await adapter.said(rtdeMessages.refuses(`127.0.0.1:${port}`, 'RTDE'));
    await new RtdeRobot().listen(t, port);

    await statesOf(bridge);
    assert.equal(plantLines(adapter).length, 2, adapter.err);
  });

  it('Connection_Lost_IsReopened', async t => {
    const { bridge, robot, adapter } = await cell(t);
    await statesOf(bridge, 10);

    robot.drop();

    await adapter.said('waiting: 127.0.0.1');
    const before = bridge.jointStates.length;
    await statesOf(bridge, before + 10);
    assert.equal(plantLines(adapter).length, 3, adapter.err);
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

/** Sends random bytes until the connection is closed. */
function pour(socket) {
  const random = seeded(7), timer = setInterval(() => socket.write(Buffer.from(Array.from({ length: 1024 }, () => Math.floor(256 * random())))), 1);
  socket.on('error', () => {}).on('close', () => clearInterval(timer));
}

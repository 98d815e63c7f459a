// Runs the adapter as a process while the robot stops, the data is damaged or the connection fails.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { freePort } from '../freePort.mjs';
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { seeded } from '../seeded.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { byte, packageOf } from './bytes.mjs';
import { RtdeRobot } from './robot.mjs';
import { ANY, like, messages } from '../messages.mjs';
import { cell, configuration, plantLines, statesOf } from './cell.mjs';

const { fieldMessages, robotStateMessages, rtdeMessages, safetyStops } = messages;

/** Whether the diagnostics warn of this state. An adapter that connects has a warning too. */
const isWarned = (bridge, text) => bridge.status?.level === 1 && bridge.status.message.endsWith(text);

describe('faults of an rtde plant', () => {
  it('Robot_InProtectiveStop_IsReportedAndPositionsContinue', async t => {
    const { bridge, robot, adapter } = await cell(t);
    await statesOf(bridge);

    robot.state = { runtime: 1, mode: 7, safety: 3, bits: 1 << 2 };

    await until(() => isWarned(bridge, safetyStops[3]), () => bridge.status?.message);
    await until(() => bridge.joint('elbow_joint').state === 'live', () => JSON.stringify(bridge.state));
    await statesOf(bridge, bridge.jointStates.length + 20);
    robot.state = { runtime: 2, mode: 7, safety: 1, bits: 1 };
    await until(() => bridge.status.level === 0, 'no warning');
    const lines = adapter.err.split('\n').filter(line => /protective|program/.test(line));
    assert.deepEqual(lines.map(line => line.slice(12)), [
      robotStateMessages.programStopped('stopped'), safetyStops[3], robotStateMessages.programRuns, `ended: ${safetyStops[3]}`,
    ]);
  });

  it('Controller_SwitchedOffDuringAProtectiveStop_EndsTheNoticeOfTheStop', async t => {
    const { bridge, robot } = await cell(t);
    robot.state = { runtime: 1, mode: 7, safety: 3, bits: 1 << 2 };
    await until(() => bridge.state?.notice === safetyStops[3] && bridge.state.program !== undefined, () => JSON.stringify(bridge.state));

    robot.stop();

    await until(() => bridge.state.state === 'waiting', () => JSON.stringify(bridge.state));
    assert.deepEqual(['notice', 'program', 'following_ms'].filter(key => key in bridge.state), []);
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

      await until(() => isWarned(bridge, safetyStops[4]), () => bridge.status?.message);

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
    await until(() => bridge.status.level === 0, () => JSON.stringify(bridge.status));
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
    VirtualTime.ofProcess(t);
    const port = await freePort(), bridge = await RosbridgeDouble.start(t);
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
    await until(() => plantLines(adapter).length === 3, () => adapter.err);
    await statesOf(bridge, before + 10);
    assert.equal(plantLines(adapter).length, 3, adapter.err);
  });
});

/** Sends random bytes until the connection is closed. */
function pour(socket) {
  const random = seeded(7), timer = setInterval(() => socket.write(Buffer.from(Array.from({ length: 1024 }, () => Math.floor(256 * random())))), 1);
  socket.on('error', () => {}).on('close', () => clearInterval(timer));
}

// Tests the clock of a robot that is connected over rosbridge.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { until } from '../program.mjs';
import { nanoseconds } from '../rosbridge.mjs';
import { cell, states } from './cell.mjs';
import { messages } from '../messages.mjs';

const { rosMessages } = messages;

describe('the clock of ros', () => {
  it('Clock_Read_IsBetweenRequestAndAnswer', async t => {
    const { robot, bridge } = await cell(t, { aheadMs: -5000 });

    for (let i = 0; i < 10; i++) {
      const before = robot.now(), { values } = await bridge.call('/nowpose/plant_time/arm'), after = robot.now();
      const time = nanoseconds(values.received);

      assert.ok(time >= before && time <= after);
      assert.deepEqual(values.sent, values.received);
      assert.ok(values.resolution_ns > 0 && values.resolution_ns <= 1000, `${values.resolution_ns}`);
    }
  });

  it('Clock_OfASimulationAt50Hz_HasAResolutionOf20Ms', async t => {
    // A simulation that publishes /clock 50 times a second.
    const { bridge } = await cell(t, { now: () => BigInt(Math.floor(performance.now() / 20)) * 20_000_000n });

    const { values } = await bridge.call('/nowpose/plant_time/arm');

    assert.ok(values.resolution_ns >= 10_000_000 && values.resolution_ns <= 20_000_000, `${values.resolution_ns}`);
  });

  it('Clock_OfRos2WithSimulatedStamps_IsANoticeWithTheRemedy', async t => {
    const { robot, bridge } = await cell(t, { ros: 2 });

    robot.jointState(12_345_000_000n, ['a'], [1]);

    await until(() => bridge.state?.notice === rosMessages.simulationTime(['/joint_states']), () => JSON.stringify(bridge.state));
    assert.equal(bridge.jointStates.length, 0);
  });

  it('Clock_WithoutRosapi_IsUnavailableButJointStatesAreForwarded', async t => {
    const { robot, bridge, adapter } = await cell(t, { now: null });

    await until(() => bridge.state?.notice === rosMessages.noClock(rosMessages.callFailed('rosapi/get_time: Service /rosapi/get_time does not exist')), () => adapter.err);
    assert.deepEqual([bridge.status.level, bridge.heard.filter(m => m.op === 'advertise_service')], [1, []]);
    robot.jointState(1_700_000_000_000_000_000n, ['a'], [1]);
    await states(bridge);
    robot.now = () => BigInt(Date.now()) * 1_000_000n;
    await until(async () => (await bridge.call('/nowpose/plant_time/arm')).result, 'the clock once rosapi runs');
    await until(() => bridge.state.notice === undefined, () => JSON.stringify(bridge.state));
  });

  it('Clock_RosbridgeInANamespace_IsReadFromItsOwnRosapi', async t => {
    const { robot, bridge } = await cell(t, { namespace: 'robot1', aheadMs: -5000 });

    const before = robot.now(), { values } = await bridge.call('/nowpose/plant_time/arm'), after = robot.now();

    const time = nanoseconds(values.received);
    assert.ok(time >= before && time <= after);
  });

  it('Clock_RosbridgeLosesItsCapsule_NamesTheRestartAsTheRemedy', async t => {
    const { robot, bridge } = await cell(t);

    robot.isCapsuleLost = true;
    const failure = await until(async () => {
      const { result, values } = await bridge.call('/nowpose/plant_time/arm');
      return !result && values;
    }, 'the failure');

    assert.match(failure, /restart rosbridge/);
    assert.doesNotMatch(failure, /rosapi, or/);
  });

  it('Clock_RosapiEndsDuringCallsOfTwoConnections_IsReadAgainOnTheNextOne', async t => {
    const { robot, bridge, adapter } = await cell(t, { ros: 2 });
    const asked = setInterval(() => void bridge.call('/nowpose/plant_time/arm').catch(() => {}), 200);
    t.after(() => clearInterval(asked));

    // The service stays known after a crash of rosapi, so the first call of the next connection also remains without a response.
    robot.endsDuringCalls = true;
    await until(() => Number(bridge.state?.reconnects) > 1, () => `${JSON.stringify(bridge.state)}\n${adapter.err}`);
    robot.endsDuringCalls = false;

    await until(async () => (await bridge.call('/nowpose/plant_time/arm')).result, 'the clock');
  });
});

// Tests the clock that an adapter for OPC UA offers to the gateway.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { nanoseconds } from '../rosbridge.mjs';
import { adapterFor, OPEN, serverFor } from './plant.mjs';
import { ControlClock } from './server.mjs';
import { like, messages } from '../messages.mjs';

const { nodeMessages, opcuaMessages } = messages;

const HOUR_MS = 3_600_000;
const MS = 1_000_000n;
const JOINT = { joint: 'a', node: 'ns=1;s=arm_joint_2' };

describe('clock of a plant without joints', () => {
  for (const plant of [[], ['time: {node: "ns=1;s=time_ns"}']])
    it(`Clock_PlantWithoutJoints${plant.length > 0 ? 'WithTimeVariable' : ''}_IsOffered`, async t => {
      const server = await serverFor(t, { clock: new ControlClock({ offsetMs: HOUR_MS }) });
      const { bridge, state } = await adapterFor(t, server, [...OPEN, ...plant], []);
      await state(s => s.state === 'connected');

      // A virtual-time test checks that the connection lasts without values.
      const { result, values } = await bridge.call('/nowpose/plant_time/cell');

      assert.equal(result, true, JSON.stringify(values));
      assert.ok(Math.abs(Number(nanoseconds(values.sent) - server.clock.now)) < 60e9);
      assert.deepEqual([bridge.jointStates, bridge.state.refused], [[], '0']);
    });
});

describe('clock with a resolution of milliseconds', () => {
  it('Resolution_Milliseconds_IsMeasured', async t => {
    const server = await serverFor(t, { clockStepUs: 1000 });
    const { bridge, states } = await adapterFor(t, server, OPEN, [JOINT]);
    await states(1);

    const { values } = await bridge.call('/nowpose/plant_time/cell');

    assert.equal(values.resolution_ns, 1_000_000);
  });
});

describe('time variable of another type', () => {
  it('Time_NumberOf32Bits_IsWaitedForWithTheAllowedTypes', async t => {
    const server = await serverFor(t, {});
    const { state } = await adapterFor(t, server, [...OPEN, 'time: { node: ns=1;s=time_real, unit: s }'], [JOINT]);

    const { reason } = await state(({ state: each }) => each === 'waiting');

    assert.equal(reason, nodeMessages.noTime('ns=1;s=time_real'));
    for (const type of ['DateTime', 'Int64', 'UInt64', 'Double']) assert.match(reason, new RegExp(`\\b${type}\\b`));
  });
});

describe('clock that the server updates once a second', () => {
  it('Time_CurrentTimeRarelyUpdated_IsReadFromTheAnswers', async t => {
    const server = await serverFor(t, { clockStepUs: 1_000_000 });
    const { run, bridge, states } = await adapterFor(t, server, OPEN, [JOINT]);
    await states(1);

    const asked = server.clock.now;
    const { values } = await bridge.call('/nowpose/plant_time/cell');

    const sent = nanoseconds(values.sent);
    assert.ok(asked - 2n * MS <= sent && sent <= server.clock.now + 2n * MS, 'truncated to seconds it would be before the call');
    assert.equal(values.resolution_ns, 1_000_000);
    assert.match(run.err, like(opcuaMessages.rareTime));
  });

  it('Time_AnswersHaveAnotherClock_IsReadFromCurrentTime', async t => {
    const server = await serverFor(t, { clockStepUs: 1_000_000, clock: new ControlClock({ offsetMs: HOUR_MS }) });
    const { run, bridge, states } = await adapterFor(t, server, OPEN, [JOINT]);
    await states(1);

    const { values } = await bridge.call('/nowpose/plant_time/cell');

    assert.equal(nanoseconds(values.sent) % 1_000_000_000n, 0n);
    assert.doesNotMatch(run.err, like(opcuaMessages.rareTime));
  });
});

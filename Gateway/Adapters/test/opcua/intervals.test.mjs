// Tests a server whose minimum intervals are longer than those that the adapter requests.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { adapterFor, configuration, OPEN, serverFor } from './plant.mjs';
import { ANY, like, messages } from '../messages.mjs';
import { ClientSubscription } from './library.mjs';

const { opcuaMessages } = messages;

const JOINTS = ['arm_joint_1', 'arm_joint_2'].map(joint => ({ joint, node: `ns=1;s=${joint}` }));

describe('minimum intervals of an OPC UA server', () => {
  for (const [minimumMs, plant, notice] of [
    [50, [], undefined],
    // The default of Codesys.
    [100, [], opcuaMessages.slow(100, 100)],
    [100, ['sampling_ms: 100'], undefined],
    [500, [], opcuaMessages.slow(500, 500)],
    [500, ['sampling_ms: 500'], undefined],
  ])
    it(`Intervals_Minimum${minimumMs}MsAnd${plant.length}Entries_DoNotCauseReadsWhileTheJointsMove`, async t => {
      const server = await serverFor(t, { minimumMs });
      const { bridge, states } = await adapterFor(t, server, [...OPEN, ...plant], JOINTS);
      const count = (await states(4)).length, before = server.valueReads;

      await states(count + 8);

      // On a busy machine, a notification may be late, so that its node is read.
      const reads = server.valueReads - before;
      assert.ok(reads <= 2, `${reads} reads during ${bridge.jointStates.length - count} samples`);
      await until(() => bridge.state?.publishing_ms === String(minimumMs), () => JSON.stringify(bridge.state));
      assert.equal(bridge.state.notice, notice);
    });

  for (const [minimumMs, keepAliveMs, lifetimeMs] of [[1, 1000, 15_000], [100, 1000, 15_000], [1000, 2000, 15_000], [4000, 8000, 24_000], [11_000, 22_000, 66_000]])
    // This server sends at most every second interval without changes, and waits for three times as long.
    it(`Intervals_Minimum${minimumMs}Ms_SubscriptionEndsSoonAfterALostConnection`, async t => {
      const server = await serverFor(t, { minimumMs }), { state } = await adapterFor(t, server, OPEN, JOINTS);

      await state(({ state: now }) => now === 'connected');

      assert.deepEqual(server.subscription, { keepAliveMs, lifetimeMs });
      assert.equal(server.asked.get('ModifySubscriptionRequest') ?? 0, minimumMs > 20 ? 1 : 0);
    });

  it('Intervals_ServerDoesNotModifySubscriptions_IsReadAndTheLogStatesTheTimes', async t => {
    const server = await serverFor(t, { minimumMs: 1000, canModify: false }), { run, states } = await adapterFor(t, server, OPEN, JOINTS);

    await states(1);

    assert.deepEqual(server.subscription, { keepAliveMs: 50_000, lifetimeMs: 750_000 });
    assert.match(run.err, like(opcuaMessages.unmodified(ANY, 750, 150)));
  });

  it('Intervals_Minimum500MsForSignals_AreNoNotice', async t => {
    const server = await serverFor(t, { minimumMs: 500 }), bridge = await RosbridgeDouble.start(t);
    const text = configuration(bridge.url, server.endpoint, OPEN, []).replace('joints: []', 'signals: [{ signal: open, node: ns=1;s=is_open }]');

    await adapterFor(t, server, [], [], { bridge, path: temporaryFile('signals.yaml', text) });

    await until(() => bridge.state?.publishing_ms === '500', () => JSON.stringify(bridge.state));
    assert.equal(bridge.state.notice, undefined);
  });

  it('Intervals_Minimum500Ms_JointAtRestIsReadBetweenTheNotificationsOfAnother', async t => {
    const server = await serverFor(t, { minimumMs: 500 }), samplesOf = joint => bridge.jointStates.filter(({ name }) => name.includes(joint)).length;
    let last = null;
    server.spoil = (name, sent) => name === 'arm_joint_2' ? last ??= sent : sent;
    const { bridge } = await adapterFor(t, server, [...OPEN, 'max_deceleration: 1000'], JOINTS);
    await until(() => bridge.joint('arm_joint_2')?.state === 'rest', () => JSON.stringify(bridge.state));
    const before = server.valueReads, count = samplesOf('arm_joint_1');

    await until(() => samplesOf('arm_joint_1') >= count + 8, () => JSON.stringify(bridge.state));

    // In each interval, about seven reads are possible.
    const reads = server.valueReads - before;
    assert.ok(reads >= 16, `${reads} reads during 8 samples`);
    assert.equal(bridge.joint('arm_joint_2').state, 'rest');
  });
});

// After the tests above, because it changes a static field of the library.
describe('an OPC UA library that does not create a subscription', () => {
  // The library never finishes this request, unless it ignores its own warning.
  it('Intervals_LibraryDoesNotCreateTheSubscription_EndOfTheConnectionEndsTheAttempt', async t => {
    const server = await serverFor(t, { minimumMs: 11_000 });
    Object.defineProperty(ClientSubscription, 'ignoreNextWarning', { get: () => false, set: () => {} });
    t.after(() => Object.defineProperty(ClientSubscription, 'ignoreNextWarning', { value: false, writable: true }));
    const { state } = await adapterFor(t, server, OPEN, JOINTS);
    await until(() => server.subscription, 'the subscription');

    await server.stop();

    await state(({ state: now }) => now === 'waiting');
  });
});

// Tests that a gateway that reads slowly receives the newest values of all signals.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { newLink, runLink } from './links.mjs';
import { parts } from './parts.mjs';
import { until } from './program.mjs';
import { nanoseconds, RosbridgeDouble } from './rosbridge.mjs';

const { SendQueue, SignalSender } = await parts('gateway/sendQueue', 'cell/signalSender');

const S = 1_000_000_000n;
/** A message that is much larger than the buffers of the kernel, together with a few thousand others. */
const LARGE = { data: 'x'.repeat(16 * 1024) };

describe('link to a slow gateway', () => {
  it('Call_AnsweredAfterAReconnection_GetsNoResponseOnTheNewConnection', async t => {
    const bridge = await RosbridgeDouble.start(t);
    const link = newLink(bridge.url), answers = [];
    link.offer('/time', 'nowpose/PlantTime', () => new Promise(resolve => answers.push(resolve)));
    runLink(t, link);
    const call = async count => {
      await until(() => bridge.heard.filter(({ op }) => op === 'advertise_service').length === count, 'the offer');
      bridge.send({ op: 'call_service', id: 'time:1', service: '/time', args: {} });
      await until(() => answers.length === count, 'the call');
    };
    await call(1);
    bridge.clients[0].terminate();
    await call(2);

    answers[0]({ of: 'the first connection' });
    await new Promise(setImmediate);
    answers[1]({ of: 'the second connection' });

    await until(() => bridge.heard.some(({ op }) => op === 'service_response'), 'the response');
    assert.deepEqual(bridge.heard.filter(({ op }) => op === 'service_response').map(({ values }) => values.of), ['the second connection']);
  });

  it('Signals_ChangeWhileTheQueueOverflows_AllReachTheGatewayWithTheirNewestValues', async t => {
    const bridge = await RosbridgeDouble.start(t);
    const link = newLink(bridge.url);
    const sender = new SignalSender({ isSettled: true }, link, () => {}, () => 0);
    runLink(t, link);
    await until(() => link.isOpen && bridge.clients.length > 0, 'the link');
    const [client] = bridge.clients;
    client.pause();
    const overflow = () => {
      const { dropped } = link;
      while (link.dropped < dropped + 100) link.publish('/joint_states', LARGE);
    };

    overflow();
    sender.add('closed', 1, S);
    sender.add('speed', 0.5, S);
    overflow();
    sender.add('closed', 0, 2n * S);
    overflow();
    client.resume();

    await until(() => bridge.published('/signals').length >= 2, 'the signals');
    assert.deepEqual(bridge.published('/signals').map(({ header, name, value }) => [name, value, nanoseconds(header.stamp)]), [[['closed'], [0], 2n * S], [['speed'], [0.5], S]]);
  });

  it('SetPoints_ManyForASlowGateway_OnlyTheNewestWait', async t => {
    const bridge = await RosbridgeDouble.start(t);
    const link = newLink(bridge.url);
    runLink(t, link);
    await until(() => link.isOpen && bridge.clients.length > 0, 'the link');
    const [client] = bridge.clients;
    client.pause();

    const { dropped } = link;
    while (link.dropped < dropped + 100) link.publish('/joint_states', LARGE);
    for (let i = 1; i <= 1000; i++) link.publishKept('/joint_trajectory', { ...LARGE, i });
    client.resume();
    link.publish('/last', {});

    await until(() => bridge.published('/last').length > 0, 'the last message');
    assert.deepEqual(bridge.published('/joint_trajectory').map(({ i }) => i), [1000]);
  });

  it('KeptMessages_SetWithoutAConnection_AreSentOnceAfterIt', async t => {
    const bridge = await RosbridgeDouble.start(t);
    const link = newLink(bridge.url);

    for (const i of [1, 2]) link.publishKept('/joint_trajectory', { i });
    link.publishKept('/tf_static', {}, 'part');
    link.forgetKept('part');
    runLink(t, link);
    link.publish('/last', {});

    await until(() => bridge.published('/last').length > 0, 'the last message');
    assert.deepEqual([bridge.published('/joint_trajectory'), bridge.published('/tf_static')], [[{ i: 2 }], []]);
  });

  it('Signals_ChangeWithoutAConnection_AreSentOnceAfterIt', async t => {
    const bridge = await RosbridgeDouble.start(t);
    const link = newLink(bridge.url);
    const sender = new SignalSender({ isSettled: true }, link, () => {}, () => 0);

    for (let i = 1; i <= 100; i++) sender.add('count', i, BigInt(i) * S);
    runLink(t, link);
    link.publish('/joint_states', LARGE);

    await until(() => bridge.published('/joint_states').length > 0, 'the message after the signals');
    assert.deepEqual(bridge.published('/signals').map(({ value }) => value), [[100]]);
  });
});

describe('queue with pulled messages', () => {
  it('Pull_SocketHasRoom_SendsThemBeforeTheOthersUntilThereAreNone', () => {
    const queue = new SendQueue(), sent = [], socket = { bufferedAmount: 1 << 20, send: data => sent.push(data) }, values = ['a', 'b'];
    queue.add('x');
    queue.pull('values', () => values.shift() ?? null);
    queue.pump(socket, () => {});
    values[0] = 'newer';

    socket.bufferedAmount = 0;
    queue.pump(socket, () => {});
    values.push('later');
    queue.pump(socket, () => {});

    assert.deepEqual(sent, ['newer', 'b', 'x']);
  });
});

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { connectAsync } from 'mqtt';
import { startProcess, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { bridge, clockOf, halls, jointStatus, publish, secondsAgo, served, state, TOPIC } from './halls.mjs';
import { missing, Mosquitto } from './mosquitto.mjs';
import { SyncServer } from './syncServer.mjs';
import { messages } from '../messages.mjs';

const { brokerMessages, malformedMessages, silenceMessages } = messages;

/** For tests of another fault, because a busy machine may be late with the next sample. */
const MAY_BE_SILENT = '  silence: { fault_after_s: 60 }\n';

describe('faults behind a broker', { skip: missing, concurrency: 3 }, () => {
  it('Subscriber_PublisherKilled_ReportsIt', async t => {
    const { near, far, sync, publisher, subscriber } = await halls(t, { launch: startProcess, more: MAY_BE_SILENT });
    await until(() => {
      publish(near, '/joint_states', state(sync.now()));
      return far.joint('a')?.state === 'live';
    }, 'a joint');

    publisher.child.kill('SIGKILL');

    await subscriber.said(`waiting: ${brokerMessages.bridgeAway}`);
    await until(() => far.state?.state === 'waiting', () => JSON.stringify(far.state));
    assert.deepEqual([far.joint('a').state, far.joint('a').reason], ['fault', brokerMessages.bridgeAway]);
  });

  // The broker ends a connection whose network failed after 4.5 s. The bridge may have reconnected before, and the broker then publishes the old will.
  // The other bridge then waits for the values that the plant's gateway still has.
  it('Publisher_LateWillOfItsFormerConnection_SendsItsRetainedMessagesAndIsAnnouncedAgain', async t => {
    const { near, far, broker, sync, subscriber } = await halls(t), topic = `${TOPIC}/alive`;
    publish(near, '/signals', { header: state(sync.now()).header, name: ['closed'], value: [1] });
    publish(near, '/nowpose/joint_status', jointStatus(sync.now(), {}));
    await until(() => far.state?.['signal/closed']?.startsWith('live'), () => JSON.stringify(far.state));
    const reader = await connectAsync(broker.url, { protocolVersion: 5 }), heard = [];
    t.after(() => reader.endAsync(true));
    reader.on('message', (from, payload) => heard.push(from === topic ? payload.toString() : from.slice(TOPIC.length + 1)));
    await reader.subscribeAsync(`${TOPIC}/#`, { qos: 1 });
    await until(() => new Set(heard).size === 3, 'the retained messages');
    heard.length = 0;
    const former = await connectAsync(broker.url, { protocolVersion: 5, reconnectPeriod: 0, will: { topic, payload: 'false', qos: 1, retain: true } });

    former.stream.destroy();

    await subscriber.said(`waiting: ${brokerMessages.bridgeAway}`);
    const values = ['joint_status', 'signals/closed'];
    await until(() => values.every(value => heard.includes(value)) && heard.at(-1) === 'true', () => heard.join());
    assert.ok(values.every(value => heard.indexOf(value) > heard.indexOf('false')), heard.join());
    // The bridge also repeats its presence by itself. The gateway has no set-points, so the bridge removes those on the broker.
    assert.deepEqual(heard.filter(one => one !== 'true').sort(), ['false', ...values, 'joint_trajectory'].sort());
  });

  it('Joint_NoLongerPublished_IsInFaultWhileOthersStayLive', async t => {
    const { near, far, sync } = await halls(t), names = new Set(['a', 'b']);
    const publishing = setInterval(() => names.forEach(name => publish(near, '/joint_states', state(sync.now(), [name], [1]))), 50);
    t.after(() => clearInterval(publishing));
    const joint = (name, expected) => until(() => far.joint(name)?.state === expected && far.joint(name), () => JSON.stringify(far.state));
    await Promise.all([joint('a', 'live'), joint('b', 'live')]);

    names.delete('a');
    const { reason } = await joint('a', 'fault');

    assert.equal(reason, silenceMessages.tooLong(3000));
    await joint('b', 'live');
    names.add('a');
    await joint('a', 'live');
  });

  it('JointsNotLive_AtThePlantsGateway_HaveTheSameStateAtTheOtherGateway', async t => {
    const { near, far, sync } = await halls(t), stamp = sync.now(), began = Date.now() / 1000;

    publish(near, '/nowpose/joint_status', jointStatus(stamp, {
      gone: `missing ${secondsAgo(stamp, 20)} the server has no node ns=2;s=Axis1`,
      bad: `refused ${secondsAgo(stamp, 30)} value NaN is not a position`,
      still: `rest ${secondsAgo(stamp, 40)} no change is reported`,
      doubtful: `rest ${secondsAgo(stamp, 50)} may not be at rest: the stop itself was not observed`,
      silent: `stale ${secondsAgo(stamp, 60)} samples stopped arriving`,
    }));

    await until(() => far.joint('silent'), () => JSON.stringify(far.state));
    for (const [name, expected, ago, reason] of [
      ['gone', 'missing', 20, 'the server has no node ns=2;s=Axis1'],
      ['bad', 'refused', 30, 'value NaN is not a position'],
      ['still', 'rest', 40, 'no change is reported'],
      ['doubtful', 'rest', 50, 'may not be at rest: the stop itself was not observed'],
      ['silent', 'fault', 60, brokerMessages.atOtherGateway('samples stopped arriving')],
    ]) {
      const joint = far.joint(name), since = joint.since - (began - ago);
      assert.deepEqual([name, joint.state, joint.reason], [name, expected, reason]);
      assert.ok(since >= -0.01 && since < 30, `${name} ${since} s later than ${ago} s ago`);
    }
    assert.equal(far.state['uncertain/doubtful'], 'the stop itself was not observed');
    assert.equal(far.state['uncertain/still'], undefined);
    assert.equal(far.status.level, 2);
  });

  it('JointAtRest_OldSampleSentAgain_IsForwardedOnceAndStaysAtRest', async t => {
    const { near, far, sync } = await halls(t), stamp = sync.now(), old = stamp - 3_600_000_000_000n;
    const samples = () => far.heard.filter(m => m.op === 'publish' && m.topic === '/joint_states').map(m => m.msg.name[0]);
    // After a reconnection, the sample can arrive before the state of the joint.
    publish(near, '/joint_states', state(old));
    publish(near, '/nowpose/joint_status', jointStatus(stamp, { a: `rest ${secondsAgo(stamp, 3600)} no change is reported` }));
    await until(() => far.joint('a')?.state === 'rest', () => JSON.stringify(far.state));

    publish(near, '/joint_states', state(old));
    // The messages of a topic keep their order, so this sample arrives after the others.
    publish(near, '/joint_states', state(sync.now(), ['b']));
    await until(() => samples().includes('b'), () => JSON.stringify(far.state));

    assert.deepEqual(samples(), ['a', 'b']);
    assert.notEqual(far.joint('a').state, 'refused');
  });

  it('JointsNotLive_AtThePlantsGateway_AreRetainedForALaterBridge', async t => {
    const { near, far, broker, sync } = await halls(t), stamp = sync.now();
    publish(near, '/nowpose/joint_status', jointStatus(stamp, { gone: `missing ${secondsAgo(stamp, 1)} no such node` }));
    await until(() => far.joint('gone'), () => JSON.stringify(far.state));

    const later = await RosbridgeDouble.start(t);
    bridge(t, 'subscribe', later, broker, clockOf(sync));

    await until(() => later.joint('gone')?.state === 'missing', () => JSON.stringify(later.state));
  });

  it('Subscriber_GatewayOfThePublisherDisconnectsAndReturns_ReportsIt', async t => {
    const { near, far, sync, publisher, subscriber } = await halls(t, { more: MAY_BE_SILENT });
    await until(() => {
      publish(near, '/joint_states', state(sync.now()));
      return far.joint('a')?.state === 'live';
    }, 'a joint');
    const stamp = sync.now();
    publish(near, '/nowpose/joint_status', jointStatus(stamp, { b: `rest ${secondsAgo(stamp, 1)} no change is reported` }));
    await until(() => far.joint('b')?.state === 'rest', () => JSON.stringify(far.state));

    near.stop();

    await subscriber.said(`waiting: ${brokerMessages.gatewayAway}`);
    await until(() => far.state?.state === 'waiting', () => JSON.stringify(far.state));
    for (const name of ['a', 'b'])
      assert.deepEqual([name, far.joint(name).state, far.joint(name).reason], [name, 'fault', brokerMessages.gatewayAway]);
    const again = await RosbridgeDouble.start(t, { port: near.port });
    await until(() => again.heard.some(m => m.topic === '/nowpose/joint_status'), () => publisher.err);
    publish(again, '/nowpose/joint_status', jointStatus(stamp, { b: `rest ${secondsAgo(stamp, 1)} no change is reported` }));
    await until(() => far.state?.state === 'connected' && far.joint('b')?.state === 'rest', () => JSON.stringify(far.state));
  });

  it('Subscriber_MalformedMessagesOnManyTopics_AreLoggedOnce', async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t)]);
    const subscriber = bridge(t, 'subscribe', far, broker, clockOf(sync));
    await subscriber.said(brokerMessages.noPublisher('nowpose/cell'));
    const client = await connectAsync(broker.url, { protocolVersion: 5 });
    t.after(() => client.endAsync(true));

    for (let i = 0; i < 20; i++) await client.publishAsync(`${TOPIC}/signals/${i}`, ['{', '{}'][i % 2], { retain: true });

    await until(() => far.state?.['refused/malformed'] === '20', () => JSON.stringify(far.state));
    const lines = subscriber.err.split('\n').filter(line => line.includes('malformed'));
    assert.equal(lines.length, 1, lines.join('\n'));
    assert.ok(lines[0].includes(`signals/0: ${malformedMessages.notObject}`), lines[0]);
  });

  for (const [name, topic, payload, reason] of [
    ['StatusWithoutStamp', 'joint_status', '{"status":[{"values":[]}]}', 'malformed'],
    ['StatusInAnotherFormat', 'joint_status', JSON.stringify(jointStatus(10n, { a: 'broken 1.0 why' })), 'malformed'],
    ['StatusOfNull', 'joint_status', '{"header":{"stamp":{"sec":1,"nanosec":0}},"status":[null]}', 'malformed'],
    ['NotJson', 'joint_states', '{"name": [', 'malformed'],
    ['List', 'joint_states', '[]', 'malformed'],
    ['TooLong', 'joint_states', JSON.stringify({ name: ['x'.repeat(70_000)] }), 'malformed'],
    ['ZeroStamp', 'joint_states', JSON.stringify(state(0n)), 'stamp-zero'],
    ['NaN', 'joint_states', JSON.stringify(state(10n, ['a'], [null])), 'not-finite'],
    ['NotARobotDescription', 'robot_description', '{"data":"no"}', 'malformed'],
    ['PlanWithoutPoint', 'joint_trajectory', '{"header":{},"joint_names":["a"],"points":[null]}', 'malformed'],
    ['InvalidPlan', 'joint_trajectory', '{"joint_names":["a"]}', 'malformed'],
  ])
    it(`Subscriber_${name}_RefusesTheMessageWithAReason`, async t => {
      const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t)]);
      const subscriber = bridge(t, 'subscribe', far, broker, clockOf(sync));
      await subscriber.said(brokerMessages.noPublisher('nowpose/cell'));
      await served(far);
      const client = await connectAsync(broker.url, { protocolVersion: 5 });
      t.after(() => client.endAsync(true));

      await client.publishAsync(`${TOPIC}/${topic}`, payload, { retain: true });

      await until(() => far.state?.[`refused/${reason}`] === '1', () => JSON.stringify(far.state));
      assert.deepEqual(far.jointStates, []);
    });
});

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { promisify } from 'node:util';
import { connectAsync } from 'mqtt';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile, temporaryFolder } from '../temporary.mjs';
import { bridge, clockOf, halls, publish, state, TOPIC } from './halls.mjs';
import { missing, Mosquitto } from './mosquitto.mjs';
import { ANY, like, messages } from '../messages.mjs';

// Does not block this process, in which the adapters run.
const run = promisify(execFile);

const { brokerMessages } = messages;

const { BrokerLink } = await parts('broker/brokerLink');

describe('broker', { skip: missing, concurrency: 3 }, () => {
  it('Bridges_JointStates_KeepTheirTimeStamps', async t => {
    const { near, far, sync } = await halls(t);
    const stamp = sync.now();

    for (let i = 0n; i < 50n; i++)
      publish(near, '/joint_states', { ...state(stamp + i * 1000n, ['a', 'b'], [Number(i), -1]), velocity: [0.5, null], acceleration: [null, 2] });

    const states = await until(() => far.jointStates.length === 50 && far.jointStates, () => `${far.jointStates.length} of 50`);
    assert.deepEqual(states.map(s => nanoseconds(s.header.stamp)), [...Array(50).keys()].map(i => stamp + BigInt(i) * 1000n));
    const { name, position, velocity, acceleration } = states[9];
    assert.deepEqual([name, position, velocity, acceleration], [['a', 'b'], [9, -1], [0.5, null], [null, 2]]);
  });

  it('Bridges_DescriptionAndSetPoints_AreRetainedForLaterSubscribers', async t => {
    const { near, far, broker, sync } = await halls(t);
    const points = [{ positions: [1], velocities: [], accelerations: [], time_from_start: { sec: 1, nanosec: 0 } }];
    const plan = { header: state(sync.now()).header, joint_names: ['a'], points };
    publish(near, '/robot_description', { data: '<robot name="r"/>' });
    publish(near, '/joint_trajectory', plan);
    await until(() => far.published('/robot_description').length > 0 && far.published('/joint_trajectory').length > 0, 'both');

    const later = await RosbridgeDouble.start(t);
    bridge(t, 'subscribe', later, broker, clockOf(sync));

    await until(() => later.published('/robot_description').length > 0 && later.published('/joint_trajectory').length > 0, 'both, later');
    assert.deepEqual(later.published('/robot_description')[0], { data: '<robot name="r"/>' });
    assert.deepEqual(later.published('/joint_trajectory')[0], plan);
  });

  it('SetPoints_OfAnEarlierRunOrAnEarlierRunOfTheGateway_AreRemovedFromTheBroker', async t => {
    const [near, broker] = await Promise.all([RosbridgeDouble.start(t), Mosquitto.start(t)]);
    const topic = `${TOPIC}/joint_trajectory`, retained = new Map();
    const client = await connectAsync(broker.url, { protocolVersion: 5 });
    t.after(() => client.endAsync(true));
    await client.publishAsync(topic, '{"joint_names":["old"]}', { retain: true, qos: 1 });
    client.on('message', (name, payload) => retained.set(name, payload.toString()));
    await client.subscribeAsync(topic, { rap: true });
    await until(() => retained.get(topic)?.includes('old'), 'the set-points of an earlier run');

    bridge(t, 'publish', near, broker);
    await until(() => retained.get(topic) === '', 'the removal');
    publish(near, '/joint_trajectory', { joint_names: ['new'] });
    await until(() => retained.get(topic).includes('new'), 'the new set-points');
    for (const connection of near.clients) connection.terminate();

    await until(() => retained.get(topic) === '', 'the removal after the connection to the gateway');
  });

  it('SetPoints_RemovedFromTheBroker_AreNotMalformed', async t => {
    const { near, far, broker, subscriber, sync } = await halls(t), client = await connectAsync(broker.url, { protocolVersion: 5 });
    t.after(() => client.endAsync(true));
    await client.publishAsync(`${TOPIC}/joint_trajectory`, '', { retain: true, qos: 1 });

    publish(near, '/robot_description', { data: '<robot name="r"/>' });

    await until(() => far.published('/robot_description').length > 0, 'the next message');
    assert.doesNotMatch(subscriber.err, /malformed/);
  });

  it('Bridge_BrokerStalls_DropsTheOldestAndStillAnswersItsGateway', async t => {
    const { near, far, broker, sync, publisher } = await halls(t);
    broker.stall();
    // Sends more than all buffers on the path can hold.
    const names = [...Array(250).keys()].map(i => `a_joint_with_a_rather_long_name_${i}`), start = sync.now();
    for (let i = 0n; i < 1000n; i++) {
      publish(near, '/joint_states', state(start + i, names, names.map(() => Number(i))));
      if (i % 50n === 0n) await new Promise(resolve => setImmediate(resolve));
    }
    await until(() => Number(near.state?.lost) > 0, () => `lost messages: ${JSON.stringify(near.state)}`);
    // The bridge still responds to its gateway while the broker is stalled.
    const count = near.published('/nowpose/diagnostics').length;
    await until(() => near.published('/nowpose/diagnostics').length > count, 'diagnostics');

    broker.resume();
    await until(() => {
      publish(near, '/joint_states', state(sync.now(), names, names.map(() => 7777)));
      return far.jointStates.at(-1)?.position[0] === 7777;
    }, () => `the newest; ${publisher.err}`);
    const received = far.jointStates.filter(({ position }) => position[0] !== 7777);
    assert.ok(received.length < 1000, `${received.length} of the messages during the stall`);
  });

  it('Bridges_BrokerRestarted_Reconnect', async t => {
    const { near, far, broker, sync, publisher, subscriber } = await halls(t);
    publish(near, '/robot_description', { data: '<robot name="kept"/>' });
    await until(() => far.published('/robot_description').length > 0, () => `the description; ${publisher.err}${subscriber.err}`);

    await broker.stop();
    await until(() => near.state?.state === 'waiting' && far.state?.state === 'waiting', 'the diagnostics');
    await broker.run();

    await until(() => far.state?.state === 'connected', () => subscriber.err);
    // The broker has lost its retained messages, so the bridge must send them again.
    const client = await connectAsync(broker.url, { protocolVersion: 5 });
    t.after(() => client.endAsync(true));
    let passed = 0;
    const kept = new Promise(resolve => client.on('message', (topic, payload) => {
      if (topic.endsWith('/robot_description')) resolve(JSON.parse(payload));
      else passed++;
    }));
    await client.subscribeAsync([`${TOPIC}/robot_description`, `${TOPIC}/joint_states`]);
    assert.deepEqual(await kept, { data: '<robot name="kept"/>' });
    const count = far.jointStates.length;
    // Joint states may be lost until both bridges have reconnected.
    await until(() => {
      publish(near, '/joint_states', state(sync.now()));
      return far.jointStates.length > count;
    }, () => `joint states, ${passed} at the broker; ${JSON.stringify([near.state, far.state])}; ${subscriber.err}${publisher.err}`);
  });

  it('Message_ListenerThrows_IsCountedAndTheNextMessageIsProcessed', async t => {
    const broker = await Mosquitto.start(t), heard = [], problems = [], ending = new AbortController();
    const settings = { broker: { endpoint: broker.url, user: null, authority: null, userCertificate: null }, topic: TOPIC, direction: 'subscribe' };
    const link = new BrokerLink(settings, 'hall', ['joint_states'], {
      opened: () => {}, away: () => {},
      heard: (topic, payload) => heard.push(JSON.parse(payload)),
      malformed: topic => problems.push(topic),
    });
    const running = link.run(ending.signal), client = await connectAsync(broker.url, { protocolVersion: 5 });
    t.after(() => client.endAsync(true));

    await client.publishAsync(`${TOPIC}/joint_states`, '{', { qos: 1, retain: true });
    await until(async () => {
      await client.publishAsync(`${TOPIC}/joint_states`, '8', { qos: 1 });
      return heard.includes(8);
    }, () => `the good one; ${problems}`);

    assert.deepEqual(problems, ['joint_states']);
    ending.abort();
    await running;
  });

  it('Bridge_BrokerWithPassword_LogsInAndNeverLogsThePassword', async t => {
    const passwords = join(temporaryFolder(), 'passwords'), password = 'of-the-hall-4711';
    await run('mosquitto_passwd', ['-b', '-c', passwords, 'hall', password]);
    const broker = await Mosquitto.start(t, ['allow_anonymous false', `password_file ${passwords}`]), near = await RosbridgeDouble.start(t);

    const right = bridge(t, 'publish', near, broker, `  user: { name: hall, password_file: "${temporaryFile('password', password)}" }\n`);
    await right.said('[plant/hall] connected');
    const wrong = bridge(t, 'publish', near, broker, '  user: { name: hall }\n', { env: { NOWPOSE_PLANT_PASSWORD_HALL: 'not-that-one' } });
    await wrong.said(like(brokerMessages.loginRefused(ANY)));

    assert.doesNotMatch(right.err + wrong.err, /4711|not-that-one/);
  });

  it('Bridge_BrokerWithTls_ConnectsOnlyWithTheAuthorityOfItsCertificate', async t => {
    const folder = temporaryFolder(), key = join(folder, 'key.pem'), certificate = join(folder, 'certificate.pem');
    await run('openssl', ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:prime256v1', '-nodes', '-days', '2',
      '-subj', '/CN=127.0.0.1', '-addext', 'subjectAltName=IP:127.0.0.1', '-keyout', key, '-out', certificate]);
    const broker = await Mosquitto.start(t, ['allow_anonymous true', `certfile ${certificate}`, `keyfile ${key}`]);
    const near = await RosbridgeDouble.start(t);
    broker.url = broker.url.replace('mqtt:', 'mqtts:');

    await bridge(t, 'publish', near, broker, `  authority_file: ${certificate}\n`).said('[plant/hall] connected');
    await bridge(t, 'publish', near, broker).said(like(brokerMessages.notTrusted(ANY)));
  });
});

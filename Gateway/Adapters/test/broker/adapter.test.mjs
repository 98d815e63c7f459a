import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { connectAsync } from 'mqtt';
import { wrongIn } from '../checking.mjs';
import { check, start, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { parts } from '../parts.mjs';
import { temporaryFile, temporaryFolder } from '../temporary.mjs';
import { missing, Mosquitto } from './mosquitto.mjs';
import { SyncServer } from './syncServer.mjs';

const { BrokerLink } = await parts('broker/brokerLink');

const TOPIC = 'nowpose/cell';

function bridge(t, direction, gateway, broker, more = '', env) {
  const path = temporaryFile(`${direction}.yaml`, `gateway: { url: "${gateway.url}" }
plant:
  kind: broker
  name: hall
  direction: ${direction}
  endpoint: ${broker.url ?? broker}
  topic: ${TOPIC}
${more}`);
  return start(t, [path], { env });
}

const clockOf = ({ port }, more = '') => `  clock: { host: 127.0.0.1, port: ${port}${more} }\n`;

/** Two gateways, one with the plant and one without, connected by a broker and two bridges. */
async function halls(t, { more = '' } = {}) {
  const [near, far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t)]);
  const publisher = bridge(t, 'publish', near, broker), subscriber = bridge(t, 'subscribe', far, broker, clockOf(sync) + more);
  await until(() => near.heard.filter(m => m.op === 'subscribe').length === 4, () => publisher.err);
  await until(() => far.state?.state === 'connected', () => subscriber.err);
  // No message passes until the clock of its stamps is known.
  await served(far);
  return { near, far, broker, sync, publisher, subscriber };
}

const state = (stamp, name = ['a'], position = [1]) => ({
  header: { stamp: { sec: Number(stamp / 1_000_000_000n), nanosec: Number(stamp % 1_000_000_000n) }, frame_id: '' },
  name, position, velocity: [], effort: [],
});
const publish = (double, topic, msg) => double.send({ op: 'publish', topic, msg });
/** The list of joints that are not live, as a gateway publishes it on its own topic. */
const jointStatus = (stamp, values) => ({
  header: state(stamp).header,
  status: [{ level: 2, name: 'joints', message: '', hardware_id: 'gateway', values: Object.entries(values).map(([key, value]) => ({ key, value })) }],
});
const secondsAgo = (stamp, seconds) => (Number(stamp) / 1e9 - seconds).toFixed(3);
const served = (double, service = '/nowpose/plant_time/hall') =>
  until(async () => (await double.call(service)).result, 'the clock');

describe('broker', { skip: missing, concurrency: 3 }, () => {
  it('Bridges_JointStates_ArriveWithTheirStamps', async t => {
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

  it('Clock_Upstream_IsForwardedWithItsBound', async t => {
    const { far, sync } = await halls(t);
    Object.assign(sync, { aheadNs: -3_600_000_000_000n, boundUs: 250, resolutionNs: 1_000_000 });

    for (let i = 0; i < 5; i++) {
      await served(far);
      const before = sync.now(), { values } = await far.call('/nowpose/plant_time/hall'), after = sync.now();
      assert.ok(nanoseconds(values.received) >= before && nanoseconds(values.sent) >= nanoseconds(values.received) && nanoseconds(values.sent) <= after);
      assert.deepEqual([values.error_bound_ns, values.resolution_ns, values.synchronised], [250_000, 1_000_000, true]);
    }
    sync.isSynchronised = false;
    assert.equal((await far.call('/nowpose/plant_time/hall')).values.synchronised, false);
  });

  it('Clock_UpstreamRestarted_IsRequestedAgain', async t => {
    const { far, sync, subscriber } = await halls(t);
    await served(far);

    await sync.stop();
    await subscriber.said('is unknown');
    assert.equal((await far.call('/nowpose/plant_time/hall')).result, false);
    await sync.listen(sync.port);

    await served(far);
  });

  it('Clock_WithToken_IsRequestedWithIt', async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t, { token: 'secret-of-a' })]);
    const right = temporaryFile('token', 'secret-of-a\n'), wrong = temporaryFile('token', 'another-one\n');
    bridge(t, 'subscribe', far, broker, clockOf(sync, `, token_file: "${right}"`));
    await served(far);

    const refused = bridge(t, 'subscribe', await RosbridgeDouble.start(t), broker, clockOf(sync, `, token_file: "${wrong}"`));

    await refused.said('refuses the token');
    assert.doesNotMatch(refused.err, /another-one/);
  });

  it('Broker_StallsAndContinues_DoesNotBlockTheGatewayAndDropsTheOldest', async t => {
    const { near, far, broker, sync, publisher } = await halls(t);
    broker.stall();
    // More than the combined capacity of all buffers on the path.
    const names = [...Array(250).keys()].map(i => `a_joint_with_a_rather_long_name_${i}`), start = sync.now();
    for (let i = 0n; i < 1000n; i++) {
      publish(near, '/joint_states', state(start + i, names, names.map(() => Number(i))));
      if (i % 50n === 0n) await new Promise(resolve => setImmediate(resolve));
    }
    const asked = performance.now();
    await until(() => Number(near.state?.lost) > 0, () => `lost messages: ${JSON.stringify(near.state)}`);
    // The bridge still answers its gateway while the broker is stalled.
    const count = near.published('/nowpose/diagnostics').length;
    await until(() => near.published('/nowpose/diagnostics').length > count, 'diagnostics');

    broker.resume();
    await until(() => {
      publish(near, '/joint_states', state(sync.now(), names, names.map(() => 7777)));
      return far.jointStates.at(-1)?.position[0] === 7777;
    }, () => `the newest; ${publisher.err}`);
    assert.ok(far.jointStates.length < 1000, `${far.jointStates.length} after ${performance.now() - asked} ms`);
  });

  it('Broker_Restarted_BothBridgesReconnect', async t => {
    const { near, far, broker, sync, publisher, subscriber } = await halls(t);
    publish(near, '/robot_description', { data: '<robot name="kept"/>' });
    await until(() => far.published('/robot_description').length > 0, 'the description');

    await broker.stop();
    await Promise.all([publisher.said('waiting: '), subscriber.said('waiting: ')]);
    await broker.run();

    await until(() => far.state?.state === 'connected', () => subscriber.err);
    // The broker has lost its retained messages; the bridge still has them.
    const client = await connectAsync(broker.url, { protocolVersion: 5 });
    t.after(() => client.endAsync(true));
    const kept = new Promise(resolve => client.on('message', (topic, payload) => resolve(JSON.parse(payload))));
    await client.subscribeAsync(`${TOPIC}/robot_description`);
    assert.deepEqual(await kept, { data: '<robot name="kept"/>' });
    const count = far.jointStates.length;
    // Joint states sent before both bridges have reconnected are lost, which is allowed.
    await until(() => {
      publish(near, '/joint_states', state(sync.now()));
      return far.jointStates.length > count;
    }, () => `joint states; ${publisher.err}${subscriber.err}`);
  });

  it('Publisher_Killed_SubscriberReportsIt', async t => {
    const { near, far, sync, publisher, subscriber } = await halls(t);
    await until(() => {
      publish(near, '/joint_states', state(sync.now()));
      return far.joint('a')?.state === 'live';
    }, 'a joint');

    publisher.child.kill('SIGKILL');

    await subscriber.said('waiting: the bridge of the gateway that has the plant is disconnected');
    await until(() => far.state?.state === 'waiting', () => JSON.stringify(far.state));
    assert.deepEqual([far.joint('a').state, far.joint('a').reason], ['fault', 'the bridge of the gateway that has the plant is disconnected']);
  });

  it('Joint_NoLongerPublished_IsFaultWhileOthersStayLive', async t => {
    const { near, far, sync } = await halls(t), names = new Set(['a', 'b']);
    const publishing = setInterval(() => names.forEach(name => publish(near, '/joint_states', state(sync.now(), [name], [1]))), 50);
    t.after(() => clearInterval(publishing));
    const joint = (name, expected) => until(() => far.joint(name)?.state === expected && far.joint(name), () => JSON.stringify(far.state));
    await Promise.all([joint('a', 'live'), joint('b', 'live')]);

    names.delete('a');
    const { reason } = await joint('a', 'fault');

    assert.match(reason, /no new value for more than 3 s/);
    assert.equal(far.joint('b').state, 'live');
    names.add('a');
    await joint('a', 'live');
  });

  it('Joints_NotLiveAtThePlantsGateway_HaveTheSameStateAtTheOtherGateway', async t => {
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
      ['silent', 'fault', 60, 'at the gateway that has the plant: samples stopped arriving'],
    ]) {
      const joint = far.joint(name), since = joint.since - (began - ago);
      assert.deepEqual([name, joint.state, joint.reason], [name, expected, reason]);
      assert.ok(since >= -0.01 && since < 30, `${name} ${since} s later than ${ago} s ago`);
    }
    assert.equal(far.state['uncertain/doubtful'], 'the stop itself was not observed');
    assert.equal(far.state['uncertain/still'], undefined);
    assert.equal(far.status.level, 2);
  });

  it('Joints_NotLiveAtThePlantsGateway_AreRetainedForALaterBridge', async t => {
    const { near, far, broker, sync } = await halls(t), stamp = sync.now();
    publish(near, '/nowpose/joint_status', jointStatus(stamp, { gone: `missing ${secondsAgo(stamp, 1)} no such node` }));
    await until(() => far.joint('gone'), () => JSON.stringify(far.state));

    const later = await RosbridgeDouble.start(t);
    bridge(t, 'subscribe', later, broker, clockOf(sync));

    await until(() => later.joint('gone')?.state === 'missing', () => JSON.stringify(later.state));
  });

  it('PublishersGateway_DisconnectsAndReturns_SubscriberReportsIt', async t => {
    const { near, far, sync, publisher, subscriber } = await halls(t);
    await until(() => {
      publish(near, '/joint_states', state(sync.now()));
      return far.joint('a')?.state === 'live';
    }, 'a joint');
    const stamp = sync.now();
    publish(near, '/nowpose/joint_status', jointStatus(stamp, { b: `rest ${secondsAgo(stamp, 1)} no change is reported` }));
    await until(() => far.joint('b')?.state === 'rest', () => JSON.stringify(far.state));

    near.stop();

    await subscriber.said('waiting: the bridge has lost the gateway that has the plant');
    await until(() => far.state?.state === 'waiting', () => JSON.stringify(far.state));
    for (const name of ['a', 'b'])
      assert.deepEqual([name, far.joint(name).state, far.joint(name).reason], [name, 'fault', 'the bridge has lost the gateway that has the plant']);
    const again = await RosbridgeDouble.start(t, { port: near.port });
    await until(() => again.heard.some(m => m.topic === '/nowpose/joint_status'), () => publisher.err);
    publish(again, '/nowpose/joint_status', jointStatus(stamp, { b: `rest ${secondsAgo(stamp, 1)} no change is reported` }));
    await until(() => far.state?.state === 'connected' && far.joint('b')?.state === 'rest', () => JSON.stringify(far.state));
  });

  for (const [name, topic, payload, reason] of [
    ['StatusWithoutStamp', 'joint_status', '{"status":[{"values":[]}]}', 'malformed'],
    ['StatusOfAnotherForm', 'joint_status', JSON.stringify(jointStatus(10n, { a: 'broken 1.0 why' })), 'malformed'],
    ['StatusOfNull', 'joint_status', '{"header":{"stamp":{"sec":1,"nanosec":0}},"status":[null]}', 'malformed'],
    ['NoJson', 'joint_states', '{"name": [', 'malformed'],
    ['AList', 'joint_states', '[]', 'malformed'],
    ['TooLong', 'joint_states', JSON.stringify({ name: ['x'.repeat(70_000)] }), 'malformed'],
    ['ZeroStamp', 'joint_states', JSON.stringify(state(0n)), 'stamp-zero'],
    ['NaN', 'joint_states', JSON.stringify(state(10n, ['a'], [null])), 'not-finite'],
    ['NoDescription', 'robot_description', '{"data":"no"}', 'malformed'],
    ['PlanWithoutPoint', 'joint_trajectory', '{"header":{},"joint_names":["a"],"points":[null]}', 'malformed'],
    ['BadPlan', 'joint_trajectory', '{"joint_names":["a"]}', 'malformed'],
  ])
    it(`Subscriber_${name}_IsRefusedWithAReason`, async t => {
      const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t)]);
      const subscriber = bridge(t, 'subscribe', far, broker, clockOf(sync));
      await subscriber.said('no client publishes nowpose/cell at the broker yet');
      await served(far);
      const client = await connectAsync(broker.url, { protocolVersion: 5 });
      t.after(() => client.endAsync(true));

      await client.publishAsync(`${TOPIC}/${topic}`, payload, { retain: true });

      await until(() => far.state?.[`refused/${reason}`] === '1', () => JSON.stringify(far.state));
      assert.deepEqual(far.jointStates, []);
    });

  it('Message_ListenerThrows_IsCountedAndTheNextIsProcessed', async t => {
    const broker = await Mosquitto.start(t), heard = [], problems = [], ending = new AbortController();
    const settings = { endpoint: broker.url, topic: TOPIC, user: null, authority: null, direction: 'subscribe' };
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

  it('Bridge_PasswordOfTheBroker_LogsInAndIsNeverLogged', async t => {
    const passwords = join(temporaryFolder(), 'passwords'), password = 'of-the-hall-4711';
    assert.equal(spawnSync('mosquitto_passwd', ['-b', '-c', passwords, 'hall', password]).status, 0);
    const broker = await Mosquitto.start(t, ['allow_anonymous false', `password_file ${passwords}`]), near = await RosbridgeDouble.start(t);

    const right = bridge(t, 'publish', near, broker, `  user: { name: hall, password_file: "${temporaryFile('password', password)}" }\n`);
    await right.said('[plant/hall] connected');
    const wrong = bridge(t, 'publish', near, broker, '  user: { name: hall }\n', { NOWPOSE_PLANT_PASSWORD: 'not-that-one' });
    await wrong.said('refuses the login; check user and password_file');

    assert.doesNotMatch(right.err + wrong.err, /4711|not-that-one/);
  });

  it('Bridge_BrokerWithTls_IsTrustedOnlyWithItsAuthority', async t => {
    const folder = temporaryFolder(), key = join(folder, 'key.pem'), certificate = join(folder, 'certificate.pem');
    const made = spawnSync('openssl', ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:prime256v1', '-nodes', '-days', '2',
      '-subj', '/CN=127.0.0.1', '-addext', 'subjectAltName=IP:127.0.0.1', '-keyout', key, '-out', certificate]);
    assert.equal(made.status, 0, String(made.stderr));
    const broker = await Mosquitto.start(t, ['allow_anonymous true', `certfile ${certificate}`, `keyfile ${key}`]), near = await RosbridgeDouble.start(t);
    broker.url = broker.url.replace('mqtt:', 'mqtts:');

    await bridge(t, 'publish', near, broker, `  authority_file: ${certificate}\n`).said('[plant/hall] connected');
    await bridge(t, 'publish', near, broker).said('certificate is not trusted');
  });
});

describe('broker configuration', () => {
  const plant = more => `plant:\n  kind: broker\n  direction: subscribe\n  endpoint: mqtt://127.0.0.1\n  topic: nowpose/cell\n${more}`;
  for (const [name, text, expected] of [
    ['NoClock', plant(''), /line 1: plant\.clock: missing; add host and sync port of the gateway/],
    ['ClockOfAPublisher', plant('  clock: { host: a }\n').replace('subscribe', 'publish'), /line 6: plant\.clock: not used with direction: publish/],
    ['PlainToAnother', plant('  clock: { host: a }\n').replace('127.0.0.1', '10.0.0.5'), /line 1: plant\.plain: missing; mqtt:\/\/ to another machine/],
    ['Port', plant('  clock: { host: a }\n').replace('127.0.0.1', '127.0.0.1:x'), /line 4: plant\.endpoint: .* a port from 1 to 65535/],
    ['Topic', plant('  clock: { host: a }\n').replace('nowpose/cell', 'nowpose/#'), /line 5: plant\.topic: value "nowpose\/#"; allowed is what the plant's topics begin with/],
    ['Direction', plant('').replace('subscribe', 'subscrib'), /line 3: plant\.direction: .*did you mean subscribe\?/],
    ['PasswordInEndpoint', plant('').replace('mqtt://', 'mqtt://me:word@'), /line 4: plant\.endpoint: .*without user name or password/],
    ['PasswordInTheOpen', plant('  clock: { host: a }\n  plain: true\n  user: { name: me, password_file: none }\n').replace('127.0.0.1', '10.0.0.5'), /line 8: plant\.user: the password would be sent unencrypted/],
  ])
    it(`Check_Invalid${name}_NamesItsLine`, () => {
      const lines = wrongIn(temporaryFile('broker.yaml', text));

      assert.ok(lines.some(line => expected.test(line)), lines.join('\n'));
      assert.doesNotMatch(lines.join('\n'), /me:word/);
    });

  it('Check_StartedByAGateway_DoesNotShowTheFilesAddress', async t => {
    const path = temporaryFile('broker.yaml', plant('  clock: { host: a }\n'));

    const alone = await check(t, path), supervised = await check(t, path, { NOWPOSE_SUPERVISED: '1' });

    assert.match(alone.out, /to gateway ws:\/\/127\.0\.0\.1:47011, time of a:47010/);
    assert.match(supervised.out, /to this gateway, time of a:47010/);
  });

  it('Check_TokenOverPlainConnection_IsRefused', async t => {
    const path = temporaryFile('broker.yaml', plant('  clock: { host: 10.0.0.5, token_file: token }\n'));
    writeFileSync(join(dirname(path), 'token'), 'word\n', { mode: 0o600 });

    const { status, lines } = await check(t, path);

    assert.equal(status, 2);
    assert.match(lines[0], /line 6: plant\.clock\.token_file: a token is sent only over TLS or within this machine/);
  });
});

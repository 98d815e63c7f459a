import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { promisify } from 'node:util';
import { connectAsync } from 'mqtt';
import { missing, Mosquitto } from '../broker/mosquitto.mjs';
import { start, startProcess, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile, temporaryFolder } from '../temporary.mjs';
import { cell, changes, clockAhead, configuration, poses } from './cell.mjs';
import { ANY, like, messages } from '../messages.mjs';

// Does not block this process, in which the adapters run.
const run = promisify(execFile);

const { brokerMessages, mqttMessages, silenceMessages, stateMessages } = messages;

const MS = 1_000_000n;
const TIME = '  time: { field: t, unit: ms }\n';
const REST = `robots: { arm1: ur5e }
joints:
  - { joint: axis, topic: cell/arm, field: position.1, unit: deg }
  - { joint: arm1/elbow_joint, topic: cell/elbow }
frames:
  - frame: part
    parent: { of: [world, arm1/tool0], topic: cell/part, field: parent }
    position: { unit: mm, x: { topic: cell/part, field: pose.x }, y: { topic: cell/part, field: pose.y }, z: 0 }
    angles: { order: zyx, axes: moving, unit: deg, values: [{ topic: cell/part, field: pose.a }, 0, 0] }
  - frame: table
    position: { unit: mm, x: 500, y: 0, z: 0 }
signals:
  - { signal: closed, topic: cell/closed }
  - { signal: speed, topic: cell/belt, field: speed }
`;

const part = (more = {}) => ({ parent: 0, pose: { x: 100, y: 200, a: 90 }, ...more });

describe('mqtt', { skip: missing, concurrency: 3 }, () => {
  it('Fields_WithTime_ArePublishedAsJointsFramesAndSignals', async t => {
    const { bridge, send, now } = await cell(t, { plant: TIME, rest: REST });
    const ms = now() / MS, stamp = ms * MS;

    await send('cell/arm', { t: Number(ms), position: [1, 90] });
    await send('cell/part', part({ t: Number(ms) }));
    await send('cell/part', part({ t: Number(ms) + 50, parent: 1 }));
    await send('cell/belt', { t: Number(ms), speed: 0.25 });
    await send('cell/belt', { t: Number(ms) + 20, speed: 0.25 });
    await send('cell/belt', { t: Number(ms) + 40, speed: 0.5 });

    const [{ header, name, position }] = await until(() => bridge.jointStates.length > 0 && bridge.jointStates, () => JSON.stringify(bridge.state));
    assert.deepEqual([nanoseconds(header.stamp), name], [stamp, ['axis']]);
    assert.ok(Math.abs(position[0] - Math.PI / 2) < 1e-12);
    const seen = await until(() => poses(bridge, 'part').length >= 2 && poses(bridge, 'part').slice(0, 2), () => JSON.stringify(bridge.state));
    assert.deepEqual(seen.map(({ stamp: at, parent, position: place }) => [at, parent, place]),
      [[stamp, 'world', [0.1, 0.2, 0]], [stamp + 50n * MS, 'arm1/tool0', [0.1, 0.2, 0]]]);
    assert.ok(Math.hypot(seen[0].rotation[2] - Math.SQRT1_2, seen[0].rotation[3] - Math.SQRT1_2) < 1e-12);
    // The adapter repeats the newest value once a second.
    const speeds = () => [...new Map(changes(bridge, 'speed').map(change => [change[1], change])).values()];
    await until(() => speeds().length >= 2, () => JSON.stringify(bridge.state));
    assert.deepEqual(speeds(), [[0.25, stamp], [0.5, stamp + 40n * MS]]);
    assert.deepEqual(bridge.published('/tf_static').map(({ transforms }) => transforms[0].child_frame_id), ['table']);
    assert.match(bridge.published('/arm1/robot_description')[0].data, /<robot/);
    assert.deepEqual(bridge.heard.filter(({ op }) => op === 'advertise_service'), []);
  });

  it('Fields_OfTwoRobots_ArePublishedInTheirNamespaces', async t => {
    const rest = `robots: { arm1: ur5e, arm2: ur5e }
joints:
  - { joint: arm1/elbow_joint, topic: cell/arm1, field: position.2, unit: deg }
  - { joint: arm2/elbow_joint, topic: cell/arm2, field: position.2, unit: deg }
frames:
  - frame: part
    parent: arm2/tool0
    position: { unit: mm, x: { topic: cell/part, field: x }, y: 0, z: 0 }
    quaternion: { x: 0, y: 0, z: { topic: cell/part, field: qz }, w: { topic: cell/part, field: qw } }
`;
    const { bridge, send, now } = await cell(t, { plant: TIME, rest }), ms = now() / MS;

    await send('cell/arm1', { t: Number(ms), position: [0, 0, 90] });
    await send('cell/arm2', { t: Number(ms) + 10, position: [0, 0, -90] });
    await send('cell/part', { t: Number(ms), x: 100, qz: 0.6, qw: 0.8 });

    for (const [robot, later, angle] of [['arm1', 0n, Math.PI / 2], ['arm2', 10n, -Math.PI / 2]]) {
      const [{ header, name, position }] = await until(() => bridge.published(`/${robot}/joint_states`).length > 0 && bridge.published(`/${robot}/joint_states`),
        () => JSON.stringify(bridge.state));
      assert.deepEqual([nanoseconds(header.stamp), name], [(ms + later) * MS, ['elbow_joint']]);
      assert.ok(Math.abs(position[0] - angle) < 1e-12);
      assert.match(bridge.published(`/${robot}/robot_description`)[0].data, /<robot/);
      await until(() => bridge.joint(`${robot}/elbow_joint`)?.state === 'live', () => JSON.stringify(bridge.state));
    }
    const [seen] = await until(() => poses(bridge, 'part').length > 0 && poses(bridge, 'part'), () => JSON.stringify(bridge.state));
    assert.deepEqual([seen.parent, seen.position], ['arm2/tool0', [0.1, 0, 0]]);
    assert.ok(Math.hypot(seen.rotation[2] - 0.6, seen.rotation[3] - 0.8) < 1e-12);
    assert.deepEqual(bridge.jointStates, []);
  });

  it('Numbers_WithoutTime_AreStampedWithTheirArrivalTimeOnTheGatewaysClock', async t => {
    const { bridge, send, now } = await cell(t, { plant: TIME, rest: REST });
    const before = now();

    await send('cell/elbow', '0.5');
    await send('cell/closed', 'true');

    const [{ header, name, position }] = await until(() => bridge.published('/arm1/joint_states').length > 0 && bridge.published('/arm1/joint_states'),
      () => JSON.stringify(bridge.state));
    await until(() => changes(bridge, 'closed').length >= 1, () => JSON.stringify(bridge.state));
    // The error of the clock is at most half of the round-trip time of a reading. The gateway's clock is 60 s ahead of the system clock.
    const [[value, changed]] = changes(bridge, 'closed'), slack = 10_000n * MS, stamp = nanoseconds(header.stamp);
    assert.deepEqual([name, position, value], [['elbow_joint'], [0.5], 1]);
    for (const arrived of [stamp, changed]) assert.ok(arrived > before - slack && arrived < now() + slack, `${arrived - before} ns after the message`);
  });

  it('RetainedMessage_WithoutTime_IsUsedForSignalsButNotForJointsAndFrames', async t => {
    const { bridge, send } = await cell(t, {
      rest: REST,
      prepare: async ({ send }) => {
        for (const [topic, message] of [['cell/closed', 'true'], ['cell/elbow', '0.5'], ['cell/part', part()]]) await send(topic, message, { retain: true });
      },
    });

    await until(() => changes(bridge, 'closed')[0]?.[0] === 1, () => JSON.stringify(bridge.state));
    const waits = key => bridge.state?.[key]?.startsWith('missing') && bridge.state[key].endsWith(mqttMessages.retained);
    await until(() => waits('joint/arm1/elbow_joint') && waits('frame/part'), () => JSON.stringify(bridge.state));
    assert.deepEqual([bridge.published('/arm1/joint_states'), poses(bridge, 'part')], [[], []]);
    await send('cell/elbow', '0.6');
    await until(() => bridge.published('/arm1/joint_states')[0]?.position[0] === 0.6, () => JSON.stringify(bridge.state));
  });

  it('RetainedMessages_AnotherClockBecomesTheControlClock_AreUsedWithItsTime', async t => {
    const twoHours = 7_200_000;
    let control = clockAhead(0);
    const plc = clockAhead(twoHours), ms = plc() / MS;
    const { bridge } = await cell(t, {
      plant: TIME, rest: REST, now: () => control(),
      prepare: async ({ send }) => {
        await send('cell/belt', { t: Number(ms), speed: 0.5 }, { retain: true });
        await send('cell/closed', 'true', { retain: true });
      },
    });
    await until(() => bridge.state?.['signal/speed']?.includes('ahead') && changes(bridge, 'closed').length > 0, () => JSON.stringify(bridge.state));

    control = plc;

    await until(() => changes(bridge, 'speed').length > 0, () => JSON.stringify(bridge.state));
    assert.deepEqual(changes(bridge, 'speed')[0], [0.5, ms * MS]);
    await until(() => changes(bridge, 'closed').some(([value, stamp]) => value === 1 && stamp >= ms * MS), () => JSON.stringify(bridge.state));
    assert.equal(bridge.state.reconnects, '0');
  });

  it('RetainedMessage_WithRecentTime_IsUsedAsASample', async t => {
    const { bridge } = await cell(t, {
      plant: TIME, rest: REST,
      prepare: ({ send, now }) => send('cell/part', part({ t: Number(now() / MS) }), { retain: true }),
    });

    await until(() => poses(bridge, 'part').length >= 1, () => JSON.stringify(bridge.state));
  });

  it('Adapter_FromStartToEnd_PublishesNothingToTheBroker', async t => {
    const { bridge, client, send, adapter } = await cell(t, { rest: REST, launch: startProcess }), seen = [];
    client.on('message', topic => seen.push(topic));
    await client.subscribeAsync('#');

    await send('cell/elbow', '0.5');
    await until(() => bridge.published('/arm1/joint_states').length >= 1, () => JSON.stringify(bridge.state));
    assert.equal(await adapter.stop(), 0);
    await send('cell/end', '1');

    await until(() => seen.includes('cell/end'), 'the last message');
    assert.deepEqual(seen, ['cell/elbow', 'cell/end']);
  });

  it('Adapter_BrokerRestarted_ReconnectsAndSubscribes', async t => {
    const { bridge, broker, adapter } = await cell(t, { rest: REST });

    await broker.stop();
    await adapter.said('waiting: ');
    await broker.run();
    await until(() => bridge.state?.state === 'connected', () => adapter.err);
    const client = await connectAsync(broker.url, { protocolVersion: 5 });
    t.after(() => client.endAsync(true));
    await until(async () => {
      await client.publishAsync('cell/elbow', '0.5');
      return bridge.published('/arm1/joint_states').length > 0;
    }, () => JSON.stringify(bridge.state));
    assert.equal(bridge.state.reconnects, '1');
  });

  it('Gateway_RestartedWhileAJointIsAtRest_ReceivesItsSampleAgainAndOnlyTheNewestDiagnostics', async t => {
    const { bridge, send, adapter, now } = await cell(t, { rest: REST });
    await send('cell/elbow', '0.5');
    await until(() => bridge.joint('arm1/elbow_joint')?.state === 'rest', () => JSON.stringify(bridge.state));
    const [sample] = bridge.published('/arm1/joint_states');

    bridge.stop();
    await adapter.said('disconnected');
    await send('cell/closed', '"open"');
    await adapter.said('closed refused');
    await send('cell/closed', 'true');
    await adapter.said(stateMessages.validAgain('closed'));
    const again = await RosbridgeDouble.start(t, { port: bridge.port, now });

    const [{ status: [{ values }] }] = await until(() => again.status && again.published('/nowpose/diagnostics'), () => adapter.err);
    assert.match(values.find(({ key }) => key === 'signal/closed').value, /^live /);
    assert.deepEqual(await until(() => again.published('/arm1/joint_states')[0], () => JSON.stringify(again.state)), sample);
  });

  it('Adapter_BrokerFrozen_StatesWhatDoesNotRespond', async t => {
    const { broker, adapter } = await cell(t, { rest: REST });

    broker.stall();
    t.after(() => broker.resume());

    await adapter.said(`waiting: ${brokerMessages.silent(broker.url)}`);
    assert.doesNotMatch(adapter.err, /timeout/i);
  });

  for (const [name, plant, state, reasons] of [
    ['Rest', '', 'rest', [silenceMessages.unconfirmed, silenceMessages.allUnconfirmed]],
    ['Fault', '  silence: { fault_after_s: 0.5 }\n', 'fault', [silenceMessages.tooLong(500)]],
  ])
    it(`Silence_${name}_IsReportedForTheJoint`, async t => {
      const { bridge, send } = await cell(t, { plant, rest: 'joints:\n  - { joint: a, topic: a }\n' });

      await send('a', '1');

      const { reason: found } = await until(() => bridge.joint('a')?.state === state && bridge.joint('a'), () => JSON.stringify(bridge.state));
      assert.ok(reasons.some(reason => found.endsWith(reason)), found);
      assert.equal(bridge.status.level, state === 'rest' ? 1 : 2);
    });

  it('Subscription_RefusedByTheBroker_ItsValuesAreInFault', async t => {
    // This broker accepts the connection and responds to each subscription with "not authorised".
    const server = createServer(socket => socket.on('data', ([kind, , high, low]) => {
      if (kind === 0x10) socket.write(Buffer.from([0x20, 3, 0, 0, 0]));
      if (kind === 0x82) socket.write(Buffer.from([0x90, 4, high, low, 0, 0x87]));
    }).on('error', () => {})).listen(0, '127.0.0.1');
    await once(server, 'listening');
    t.after(() => server.close());
    const bridge = await RosbridgeDouble.start(t, { now: clockAhead(0) });
    const rest = 'joints:\n  - { joint: a, topic: secret }\n';

    start(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, `mqtt://127.0.0.1:${server.address().port}`, { rest }))]);

    await until(() => bridge.joint('a')?.reason.startsWith('the broker refuses the subscription to secret'), () => JSON.stringify(bridge.state));
    assert.deepEqual([bridge.joint('a').state, bridge.state.state], ['missing', 'connected']);
  });

  it('Adapter_PasswordAndTlsConfigured_UsesThemWithoutLoggingThePassword', async t => {
    const folder = temporaryFolder(), key = join(folder, 'key.pem'), certificate = join(folder, 'certificate.pem'), passwords = join(folder, 'passwords');
    await run('openssl', ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:prime256v1', '-nodes', '-days', '2',
      '-subj', '/CN=127.0.0.1', '-addext', 'subjectAltName=IP:127.0.0.1', '-keyout', key, '-out', certificate]);
    await run('mosquitto_passwd', ['-b', '-c', passwords, 'hall', 'of-the-hall-4711']);
    const broker = await Mosquitto.start(t, ['allow_anonymous false', `password_file ${passwords}`, `certfile ${certificate}`, `keyfile ${key}`]);
    const bridge = await RosbridgeDouble.start(t, { now: clockAhead(0) }), endpoint = broker.url.replace('mqtt:', 'mqtts:');
    const adapter = (plant, env) => start(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, endpoint, { plant, rest: REST }))], { env });
    const user = `  user: { name: hall, password_file: "${temporaryFile('password', 'of-the-hall-4711')}" }\n`;

    const right = adapter(`  authority_file: ${certificate}\n${user}`);
    await right.said('[plant/twin] connected');
    const wrong = adapter(`  authority_file: ${certificate}\n  user: { name: hall, shared_password: true }\n`, { NOWPOSE_PLANT_PASSWORD: 'not-that-one' });
    await wrong.said(brokerMessages.loginRefused(endpoint));
    await adapter(user).said(like(brokerMessages.notTrusted(ANY)));

    assert.doesNotMatch(right.err + wrong.err, /4711|not-that-one/);
  });

  it('Adapter_BrokerRequiresACertificate_UsesTheConfiguredOneOrNamesTheEntry', async t => {
    const folder = temporaryFolder(), file = name => join(folder, `${name}.pem`);
    const create = name => run('openssl', ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:prime256v1', '-nodes', '-days', '2',
      '-subj', `/CN=${name}`, '-addext', 'subjectAltName=IP:127.0.0.1', '-keyout', file(`${name}-key`), '-out', file(name)]);
    // The right certificate is that of the broker, that of the authority and that of the adapter.
    await Promise.all([create('right'), create('wrong')]);
    const broker = await Mosquitto.start(t, ['allow_anonymous true', 'require_certificate true',
      `cafile ${file('right')}`, `certfile ${file('right')}`, `keyfile ${file('right-key')}`]);
    const bridge = await RosbridgeDouble.start(t, { now: clockAhead(0) }), endpoint = broker.url.replace('mqtt:', 'mqtts:');
    const adapter = user => start(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, endpoint, { plant: `  authority_file: ${file('right')}\n${user}`, rest: REST }))]);
    const having = name => adapter(`  user: { certificate: "${file(name)}", key: "${file(`${name}-key`)}" }\n`);

    await having('right').said('[plant/twin] connected');
    await having('wrong').said(brokerMessages.certificateRefused('unknown ca'));
    await adapter('').said(brokerMessages.certificateRefused('certificate required'));
  });
});

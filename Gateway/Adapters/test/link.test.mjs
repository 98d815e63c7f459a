// Tests the connection of an adapter to its gateway, without a plant.
import assert from 'node:assert/strict';
import { createHash, X509Certificate } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { checkServerIdentity } from 'node:tls';
import { before, describe, it } from 'node:test';
import { identity } from './opcua/identity.mjs';
import { configuration } from './rtde/cell.mjs';
import { freePort } from './freePort.mjs';
import { newLink, runLink } from './links.mjs';
import { parts } from './parts.mjs';
import { adapters, start, startProcess, until } from './program.mjs';
import { RosbridgeDouble } from './rosbridge.mjs';
import { VirtualTime } from './virtualTime.mjs';
import { ANY, like, messages } from './messages.mjs';

const { gatewayMessages, logMessages } = messages;

const { SendQueue, Log, inWords } = await parts('gateway/sendQueue', 'log', 'gateway/reasons');
const TOKEN = 'a-token-of-a-source';

/** Starts an adapter whose plant does not respond. */
async function adapter(test, url, { launch = start, ...options } = {}) {
  if (launch === start) VirtualTime.ofProcess(test);
  return launch(test, [configuration({ url, port: await freePort() })], options);
}

/** Starts a link to a test double of a gateway. `prepare` receives the link before it connects. */
async function linkWith(test, prepare, events) {
  VirtualTime.ofProcess(test);
  const bridge = await RosbridgeDouble.start(test), link = newLink(bridge.url, events);
  prepare(link);
  runLink(test, link);
  return bridge;
}

describe('link to the gateway', () => {
  let own, pin;
  before(async () => {
    own = await identity('urn:gateway');
    pin = `sha256/${createHash('sha256').update(new X509Certificate(own.der).publicKey.export({ type: 'spki', format: 'der' })).digest('base64')}`;
  });
  const tls = () => ({ key: own.pem, cert: own.cert });

  it('Version_GatewayHasAnother_IsLoggedOnceAndTheAdapterReportsItsOwn', async t => {
    const bridge = await RosbridgeDouble.start(t);
    const run = await adapter(t, bridge.url);
    const isSubscription = ({ op, topic }) => op === 'subscribe' && topic === '/nowpose/version';
    await until(() => bridge.heard.some(isSubscription), 'the subscription');
    const { version } = JSON.parse(readFileSync(join(adapters, 'package.json'), 'utf8'));

    for (const data of [version, `${version}-rc.1`, '9.9.9', '9.9.9', '10.0.0-rc.1+5ed38b99']) bridge.send({ op: 'publish', topic: '/nowpose/version', msg: { data } });

    await run.said('10.0.0-rc.1+5ed38b99');
    assert.doesNotMatch(run.err, like(gatewayMessages.otherVersion(version, ANY)));
    assert.equal(run.err.split('9.9.9').length, 2);
    assert.match(run.err, new RegExp(`9\\.9\\.9.*${version.replaceAll('.', '\\.')}`));
    await until(() => bridge.state, 'diagnostics');
    assert.equal(bridge.state.version, version);
  });

  it('Version_Option_PrintsTheVersion', async t => {
    const run = startProcess(t, ['--version']);

    assert.equal(await run.ended, 0);
    assert.match(run.out, /^\d+\.\d+\.\d+(\+[0-9a-f]{40})?\n$/);
  });

  it('Token_FromTheEnvironment_IsSentAndNeverLogged', async t => {
    const bridge = await RosbridgeDouble.start(t, { tls: tls(), token: TOKEN });
    const run = await adapter(t, 'ws://127.0.0.1:1', { env: { NOWPOSE_GATEWAY: bridge.url, NOWPOSE_TOKEN: TOKEN, NOWPOSE_PIN: pin } });

    await until(() => bridge.state, 'diagnostics');

    assert.equal(bridge.headers[0].authorization, `Bearer ${TOKEN}`);
    assert.doesNotMatch(run.err, new RegExp(TOKEN));
  });

  it('Pin_OfAnotherKey_ConnectionEndsAfterTheTlsHandshake', async t => {
    const bridge = await RosbridgeDouble.start(t, { tls: tls() }), other = `sha256/${'A'.repeat(43)}=`;
    const run = await adapter(t, bridge.url, { env: { NOWPOSE_TOKEN: TOKEN, NOWPOSE_PIN: other } });

    await run.said(gatewayMessages.otherPin('gateway', pin));

    assert.equal(bridge.headers.length, 0);
  });

  it('Certificate_UntrustedWithoutPin_IsRefused', async t => {
    const bridge = await RosbridgeDouble.start(t, { tls: tls() });
    const run = await adapter(t, bridge.url, { env: { NOWPOSE_TOKEN: TOKEN } });

    await run.said(like(gatewayMessages.notTrusted('gateway', ANY)));

    assert.equal(bridge.headers.length, 0);
  });

  it('Certificate_WithoutTheHost_IsReportedWithItsNamesAndTheRemedies', () => {
    const error = checkServerIdentity('10.0.0.9', { subject: { CN: 'Nowpose gateway' }, subjectaltname: 'DNS:cell, IP Address:10.0.0.7' });

    assert.equal(inWords(error, 'gateway', false), gatewayMessages.otherName('gateway', '10.0.0.9', 'DNS:cell, IP Address:10.0.0.7'));
  });

  it('Connection_RefusedBecauseTheGatewayIsFull_NamesTheOption', async t => {
    const bridge = await RosbridgeDouble.start(t, { token: 'another', refusal: 503 });

    await (await adapter(t, bridge.url, { env: { NOWPOSE_TOKEN: TOKEN } })).said(gatewayMessages.full);
  });

  for (const refusal of [401, 429])
    it(`Token_RefusedByTheGatewayWith${refusal}_IsLoggedOnce`, async t => {
      const bridge = await RosbridgeDouble.start(t, { token: 'another', refusal });
      const run = await adapter(t, bridge.url, { env: { NOWPOSE_TOKEN: TOKEN } });
      await run.said(gatewayMessages.noToken(refusal));

      await until(() => bridge.headers.length > 2, 'more attempts');

      assert.equal(run.err.split(gatewayMessages.noToken(refusal)).length, 2);
    });

  it('Connection_First_BeginsWithTheDiagnosticsThatNameTheAdapter', async t => {
    VirtualTime.ofProcess(t);
    const bridge = await RosbridgeDouble.start(t);
    start(t, [configuration({ url: bridge.url, port: await freePort(), rest: 'robot: ur5e\n' })]);

    await until(() => bridge.published('/robot_description').length > 0, 'the description');

    assert.equal(bridge.heard.find(({ op }) => op === 'publish').topic, '/nowpose/diagnostics');
  });

  it('Robot_Configured_IsPublishedAfterEachConnection', async t => {
    VirtualTime.ofProcess(t);
    const first = await RosbridgeDouble.start(t), { port } = first;
    const path = configuration({ url: first.url, port: await freePort(), rest: 'joints: [{ joint: a, index: 0 }]\nrobot: arm.urdf\n' });
    writeFileSync(join(dirname(path), 'arm.urdf'), '<robot name="arm"><joint name="a"/></robot>');
    const run = start(t, [path]);
    await until(() => first.published('/robot_description').length > 0, () => run.err);

    first.stop();
    const second = await RosbridgeDouble.start(t, { port });
    await until(() => second.published('/robot_description').length > 0, 'the description again');

    assert.equal(second.published('/robot_description')[0].data, '<robot name="arm"><joint name="a"/></robot>');
  });

  it('Adapter_ParentProcessEnded_Ends', async t => {
    const bridge = await RosbridgeDouble.start(t);
    const run = await adapter(t, bridge.url, { launch: startProcess, env: { NOWPOSE_SUPERVISED: '1' }, stdin: 'pipe' });
    await until(() => bridge.heard.length > 0, 'a message');

    run.child.stdin.end();

    assert.equal(await run.ended, 0);
  });

  for (const [signal, status] of [['SIGTERM', 0], ['SIGINT', 130]]) {
    it(`Signal_${signal}_EndsTheAdapterWithStatus${status}`, { skip: process.platform === 'win32' }, async t => {
      const bridge = await RosbridgeDouble.start(t), run = await adapter(t, bridge.url, { launch: startProcess });
      await until(() => bridge.heard.length > 0, 'a message');

      run.child.kill(signal);

      assert.equal(await run.ended, status);
    });
  }

  it('ClockOffer_RefusedByTheGateway_IsRepeated', async t => {
    const bridge = await linkWith(t, link => link.offer('/nowpose/plant_time/cell', 'nowpose/PlantTime', async () => ({ synchronised: true })));
    const offers = () => bridge.heard.filter(m => m.op === 'advertise_service').length;
    await until(() => offers() === 1, 'the offer');

    // The gateway refuses the offer, for example because an earlier connection still serves this clock.
    bridge.send({ op: 'status', level: 'error', msg: 'advertise_service: taken' });

    await until(() => offers() === 2, 'the second offer');
    assert.deepEqual((await bridge.call('/nowpose/plant_time/cell')).values, { synchronised: true });
  });

  it('GatewayStatus_RepeatedOnANewConnection_IsLoggedAgain', async t => {
    const bridge = await RosbridgeDouble.start(t), run = await adapter(t, bridge.url);
    const refuse = async count => {
      await until(() => bridge.clients.length > 0, 'the link');
      bridge.send({ op: 'status', level: 'error', msg: 'the joint is taken' });
      await until(() => run.err.split('says: the joint is taken').length === count + 1, () => run.err);
    };

    await refuse(1);
    bridge.clients[0].terminate();
    await run.said('disconnected');

    await refuse(2);
  });

  it('GatewayStatus_ClockStillBeingMeasured_IsLoggedAsMeasurement', async t => {
    const bridge = await RosbridgeDouble.start(t), run = await adapter(t, bridge.url);
    await until(() => bridge.clients.length > 0, 'the link');

    const status = 'publish /joint_states dropped: the clock of its time stamp is not synchronised yet (Unsynchronised)';
    for (let i = 0; i < 3; i++) bridge.send({ op: 'status', level: 'error', msg: status });
    bridge.send({ op: 'status', level: 'error', msg: 'another' });

    await run.said('says: another');
    assert.equal(run.err.split(gatewayMessages.measuring('gateway')).length, 2, run.err);
    assert.doesNotMatch(run.err, /Unsynchronised/);
  });

  it('GatewayStatus_RepeatedOnOneConnection_IsLoggedOnce', async t => {
    const bridge = await RosbridgeDouble.start(t), run = await adapter(t, bridge.url);
    await until(() => bridge.heard.length > 0, 'a message');

    for (let i = 0; i < 100; i++) bridge.send({ op: 'status', level: 'error', msg: i % 2 === 0 ? 'this' : 'that' });
    bridge.send({ op: 'status', level: 'error', msg: { toString: 1 } });

    await run.said('gateway says: {"toString":1}');
    assert.deepEqual(run.err.match(/says: .*/g), ['says: this', 'says: that', 'says: {"toString":1}']);
  });

  it('GatewayStatus_Error_IsPassedToTheListeners', async t => {
    const refusals = [], bridge = await linkWith(t, () => {}, { refused: reason => refusals.push(reason) });
    await until(() => bridge.clients.length > 0, 'the link');

    for (const level of ['warning', 'error', 'error']) bridge.send({ op: 'status', level, msg: `${level}: the joint is taken` });

    await until(() => refusals.length === 2, 'both errors');
    assert.deepEqual(refusals, ['error: the joint is taken', 'error: the joint is taken']);
  });

  it('Message_ListenerThrows_IsCountedAndTheNextMessageIsProcessed', async t => {
    const heard = [], problems = [], events = { malformed: (topic, problem) => problems.push([topic, problem]) };
    const bridge = await linkWith(t, link => link.subscribe('/plan', ({ data }) => heard.push(data.length), 'std_msgs/String'), events);
    await until(() => bridge.heard.some(m => m.op === 'subscribe'), 'the subscription');

    for (const msg of [null, {}, { data: 'four' }]) bridge.send({ op: 'publish', topic: '/plan', msg });

    await until(() => heard.length > 0, 'the valid message');
    assert.deepEqual(heard, [4]);
    assert.deepEqual(problems.map(([topic]) => topic), ['/plan', '/plan']);
  });

  it('Arguments_Invalid_ShowTheUsage', async t => {
    const run = start(t, ['--chek', 'plant.yaml']);

    assert.equal(await run.ended, 2);
    assert.match(run.err, /usage: node plant\.mjs CONFIG\.yaml \[--check\]/);
  });
});

describe('queue', () => {
  it('Queue_Full_DropsTheOldestMessage', () => {
    const queue = new SendQueue(), sent = [];
    for (let i = 0; i < 100; i++) queue.add(String(i));

    queue.pump({ bufferedAmount: 0, send: data => sent.push(Number(data)) }, () => {});

    assert.deepEqual([queue.dropped, sent[0], sent.at(-1), sent.length], [36, 36, 99, 64]);
  });

  it('Queue_SocketBufferFull_SendsNoMessages', () => {
    const queue = new SendQueue(), sent = [];
    queue.add('x');

    queue.pump({ bufferedAmount: 1 << 20, send: data => sent.push(data) }, () => {});

    assert.deepEqual(sent, []);
  });
});

describe('log', () => {
  it('Line_WithSecretsAndControlCharacters_IsWrittenWithoutThem', () => {
    const lines = [], log = new Log('plant/x', [TOKEN], line => lines.push(line));

    log.line(`to opc.tcp://me:word@plc with ${TOKEN}\r\n\u001b[31mfaked line`);

    assert.deepEqual(lines, ['[plant/x] to opc.tcp://***@plc with *** [31mfaked line\n']);
  });

  it('Subject_ChangesContinuously_WritesTenLinesAndTheCountOfTheOthers', () => {
    const lines = [], waits = [], log = new Log('x', [], line => lines.push(line), (ms, then) => waits.push({ ms, then }));
    const flood = () => {
      for (let i = 0; i < 500; i++) {
        log.change('value of a', 'bad', 'a is bad');
        log.resume('value of a', 'a is good');
      }
    };

    flood();
    log.change('value of b', 'bad', 'b is bad');

    assert.deepEqual(lines, [...Array(5).fill(['[x] a is bad\n', '[x] a is good\n']).flat(), '[x] b is bad\n']);
    assert.deepEqual(waits.map(w => w.ms), [60_000, 60_000]);
    waits.forEach(w => w.then());
    assert.deepEqual(lines.slice(11), [`[x] ${logMessages.moreLines('a is good', 990, 60)}\n`]);
    flood();
    assert.equal(lines.length, 22);
  });
});

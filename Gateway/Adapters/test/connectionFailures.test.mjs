// Tests what the adapters report when another program responds at the address of the plant.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { createServer as createSecureServer } from 'node:tls';
import { before, describe, it } from 'node:test';
import { identity } from './opcua/identity.mjs';
import { freePort } from './freePort.mjs';
import { parts } from './parts.mjs';
import { start, until } from './program.mjs';
import { RosbridgeDouble } from './rosbridge.mjs';
import { OPEN } from './opcua/plant.mjs';
import { temporaryFile } from './temporary.mjs';
import { ANY, like, messages } from './messages.mjs';

const { brokerMessages, gatewayMessages, opcuaMessages } = messages;
const { alertIn } = await parts('connectionErrors');

const closes = socket => socket.destroy();
const responds = bytes => socket => socket.on('data', () => socket.end(Buffer.from(bytes)));
const HTTP = responds('HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\n\r\n');

/** Responds to the first bytes of a TLS connection with a fatal alert, as a broker with TLS 1.2 does. */
const alerts = code => responds([0x15, 3, 3, 0, 2, 2, code]);

const KINDS = {
  opcua: port => `opc.tcp://127.0.0.1:${port}\n  ${OPEN}\njoints: [{ joint: a, node: "ns=1;s=a" }]`,
  mqtt: port => `mqtt://127.0.0.1:${port}\njoints: [{ joint: a, topic: a }]`,
  broker: port => `mqtt://127.0.0.1:${port}\n  direction: publish\n  topic: cell`,
  mqtts: port => `mqtts://localhost:${port}\njoints: [{ joint: a, topic: a }]`,
  otherHost: (port, { certificateFile }) => `mqtts://127.0.0.1:${port}\n  authority_file: "${certificateFile}"\njoints: [{ joint: a, topic: a }]`,
  trusted: (port, { certificateFile }) => `mqtts://localhost:${port}\n  authority_file: "${certificateFile}"\njoints: [{ joint: a, topic: a }]`,
  ros: port => `ws://127.0.0.1:${port}`,
  wss: port => `wss://127.0.0.1:${port}`,
  pinned: port => `wss://127.0.0.1:${port}\n  pin: sha256/${'A'.repeat(43)}=`,
};
const KIND_OF = { mqtts: 'mqtt', otherHost: 'mqtt', trusted: 'mqtt', wss: 'ros', pinned: 'ros' };

// Before version 3.2, OpenSSL names ten alerts with sslv3. Some alerts have no word alert.
for (const [text, alert] of [
  ['sslv3 alert handshake failure', 'handshake failure'],
  ['ssl/tls alert handshake failure', 'handshake failure'],
  ['ssl/tls alert bad certificate', 'bad certificate'],
  ['tlsv1 alert unknown ca', 'unknown ca'],
  ['tlsv1 unrecognized name', 'unrecognized name'],
  ['tlsv13 alert certificate required', 'certificate required'],
  ['wrong version number', undefined],
])
  it(`AlertIn_${text.replace(/\W/g, '')}_IsTheNameOfTheAlert`, () => {
    assert.equal(alertIn(`40F7:error:0A000410:SSL routines:ssl3_read_bytes:${text}:../deps/openssl/openssl/ssl/record/rec_layer_s3.c:916:`), alert);
  });

describe('connections to another program', { concurrency: 4 }, () => {
  let own;
  before(async () => { own = await identity('urn:another'); });

  /** Starts an adapter and a server at its address. `serve` receives each connection. Returns the reason in the diagnostics and the server's port. */
  async function reasonOf(t, kind, serve, tls = null) {
    const take = socket => {
      socket.on('error', () => {});
      serve?.(socket);
    };
    const server = tls ? createSecureServer({ key: own.pem, cert: own.cert, ...tls }, take) : createServer(take);
    server.on('tlsClientError', () => {});
    await once(server.listen(0, '127.0.0.1'), 'listening');
    t.after(() => server.close());
    const bridge = await RosbridgeDouble.start(t, { now: () => 1_700_000_000_000_000_000n }), { port } = server.address();
    const text = `gateway: { url: "${bridge.url}" }\nplant:\n  kind: ${KIND_OF[kind] ?? kind}\n  endpoint: ${KINDS[kind](port, own)}\n`;
    start(t, [temporaryFile('plant.yaml', text)]);
    return { reason: await until(() => bridge.state?.reason, 'a reason'), port };
  }

  for (const [name, kind, serve, expected, entry = /plant\.endpoint|mqtt:/] of [
    ['OpcUaIsClosed', 'opcua', closes, port => opcuaMessages.noServer(`opc.tcp://127.0.0.1:${port}`)],
    ['OpcUaIsAnotherProtocol', 'opcua', HTTP, port => opcuaMessages.noServer(`opc.tcp://127.0.0.1:${port}`)],
    ['MqttIsClosed', 'mqtt', closes, port => brokerMessages.noBroker(`mqtt://127.0.0.1:${port}`, ANY)],
    ['MqttIsAnotherProtocol', 'mqtt', HTTP, port => brokerMessages.noBroker(`mqtt://127.0.0.1:${port}`, ANY)],
    ['MqttHasNoTls', 'mqtts', closes, port => brokerMessages.noBroker(`mqtts://localhost:${port}`, ANY)],
    ['MqttRefusesTheCertificate', 'mqtts', alerts(48), () => brokerMessages.certificateRefused('unknown ca'), /plant\.user/],
    ['MqttRefusesTheTlsVersion', 'mqtts', alerts(70), () => brokerMessages.handshakeRefused('protocol version')],
    ['MqttRefusesTheHostName', 'mqtts', alerts(112), () => brokerMessages.handshakeRefused('unrecognized name')],
    ['MqttIsUnavailable', 'mqtt', responds([0x20, 3, 0, 0x88, 0]), port => brokerMessages.refusesWith(`mqtt://127.0.0.1:${port}`, 'Connection refused: Server unavailable')],
    ['MqttRefusesAllVersions', 'mqtt', responds([0x20, 2, 0, 1]), port => brokerMessages.refusesWith(`mqtt://127.0.0.1:${port}`, 'Connection refused: Unacceptable protocol version')],
    ['BrokerHasVersion3', 'broker', responds([0x20, 2, 0, 1]), port => brokerMessages.noMqtt5(`mqtt://127.0.0.1:${port}`)],
    ['BrokerHasNoVersion5', 'broker', responds([0x20, 3, 0, 0x84, 0]), port => brokerMessages.noMqtt5(`mqtt://127.0.0.1:${port}`)],
    ['RosbridgeIsClosed', 'ros', closes, () => gatewayMessages.noServer('rosbridge', 'ECONNRESET')],
    ['RosbridgeIsAWebServer', 'ros', HTTP, () => gatewayMessages.noServer('rosbridge', 'HTTP status 400')],
    ['RosbridgeHasNoTls', 'wss', HTTP, () => gatewayMessages.noServer('rosbridge', 'EPROTO')],
  ])
    it(`Connection_${name}_ReasonNamesTheEntry`, async t => {
      const { reason, port } = await reasonOf(t, kind, serve);

      assert.match(reason, like(expected(port)));
      assert.match(reason, entry);
    });

  for (const [name, kind, expected] of [
    ['WithoutPin', 'wss', () => gatewayMessages.notTrusted('rosbridge', ANY)],
    ['WithAnotherPin', 'pinned', () => gatewayMessages.otherPin('rosbridge', ANY)],
  ])
    it(`Connection_RosbridgeNotTrusted${name}_ReasonNamesTheRosbridge`, async t => {
      const { reason } = await reasonOf(t, kind, null, {});

      assert.match(reason, like(expected()));
      assert.doesNotMatch(reason, /gateway/);
    });

  it('Connection_MqttWithTls1.2RequiresACertificate_ReasonNamesTheEntry', async t => {
    const { reason } = await reasonOf(t, 'trusted', null, { maxVersion: 'TLSv1.2', requestCert: true });

    assert.equal(reason, brokerMessages.handshakeRefused('handshake failure'));
    assert.match(reason, /plant\.user\.certificate/);
  });

  it('Connection_MqttHasACertificateOfAnotherHost_ReasonNamesTheEntry', async t => {
    const { reason, port } = await reasonOf(t, 'otherHost', null, {});

    assert.equal(reason, brokerMessages.otherHost(`mqtts://127.0.0.1:${port}`));
  });

  for (const kind of ['mqtt', 'ros'])
    it(`Connection_UnknownHostOf${kind}_ReasonNamesTheEntry`, async t => {
      const bridge = await RosbridgeDouble.start(t, { now: () => 1_700_000_000_000_000_000n });
      const endpoint = KINDS[kind](await freePort()).replace('127.0.0.1', 'no-such-host.invalid');
      start(t, [temporaryFile('plant.yaml', `gateway: { url: "${bridge.url}" }\nplant:\n  kind: ${kind}\n  plain: true\n  endpoint: ${endpoint}\n`)]);

      const reason = await until(() => bridge.state?.reason, 'a reason');

      assert.match(reason, /host name.* is unknown; correct plant\.endpoint/);
    });
});

// Tests that a pause of the process does not let a timeout end before the data that have arrived are read, and does not count as silence of the
// gateway.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { connect, createServer } from 'node:net';
import { describe, it } from 'node:test';
import { freePort } from './freePort.mjs';
import { newLink, runLink } from './links.mjs';
import { messages } from './messages.mjs';
import { parts } from './parts.mjs';
import { until } from './program.mjs';
import { RosbridgeDouble } from './rosbridge.mjs';
import { VirtualTime } from './virtualTime.mjs';

const { afterArrivals, pause } = await parts('sockets', 'backoff');

const WAIT_MS = 5;

/** Starts a wait, lets data arrive, and pauses the process until the wait is over. Returns what has happened, in order. */
async function eventsOf(t, wait) {
  const server = createServer().listen(0, '127.0.0.1'), events = [];
  await once(server, 'listening');
  const client = connect(server.address().port, '127.0.0.1'), [peer] = await once(server, 'connection');
  t.after(() => [client, server].forEach(each => (each.destroy ?? each.close).call(each)));
  const arrived = new Promise(resolve => client.on('data', () => resolve(events.push('data'))));

  const over = wait().then(() => events.push('timeout'));
  peer.write('x');
  for (const began = performance.now(); performance.now() - began <= 2 * WAIT_MS;);

  await Promise.all([over, arrived]);
  return events;
}

describe('a pause of the process', () => {
  it('AfterArrivals_DataArrivedDuringThePause_AreReadFirst', async t =>
    assert.deepEqual(await eventsOf(t, () => new Promise(resolve => void afterArrivals(WAIT_MS, resolve))), ['data', 'timeout']));

  it('Pause_DataArrivedDuringThePause_AreReadFirst', async t =>
    assert.deepEqual(await eventsOf(t, () => pause(WAIT_MS, new AbortController().signal)), ['data', 'timeout']));

  it('AfterArrivals_CancelledWhileDataAreRead_DoesNotCall', async t => {
    let isCalled = false;
    const cancel = afterArrivals(WAIT_MS, () => { isCalled = true; });
    t.mock.method(globalThis, 'setImmediate', () => {});
    await new Promise(resolve => setTimeout(resolve, 2 * WAIT_MS));

    cancel();
    t.mock.restoreAll();
    await new Promise(setImmediate);

    assert.equal(isCalled, false);
  });

  /** Runs a link to a gateway in virtual time. `reasons` receives the reasons of disconnections. */
  function linkTo(t, url) {
    const reasons = [], link = newLink(url, { away: reason => reasons.push(reason) });
    return { link, reasons, ...runLink(t, link) };
  }

  async function linked(t) {
    const time = VirtualTime.ofProcess(t), gateway = await RosbridgeDouble.start(t), link = linkTo(t, gateway.url);
    await until(() => link.link.isOpen && gateway.clients.length > 0, 'the link');
    return { time, gateway, ...link };
  }

  const second = 1_000_000_000n, isIn6To8s = time => time > 6n * second && time <= 8n * second + second / 10n;

  it('Link_PausedFor20s_StaysConnected', async t => {
    const { time, link, reasons } = await linked(t);

    time.now += 20n * second;
    await time.until(time.now + 10n * second);

    assert.deepEqual([link.isOpen, reasons], [true, []]);
  });

  it('Link_GatewayStopsReading_DisconnectsAfter6To8s', async t => {
    const { time, gateway, reasons } = await linked(t), begin = time.now;

    gateway.clients[0].pause();
    await until(() => reasons.length > 0, 'the disconnection');

    assert.equal(reasons[0], messages.gatewayMessages.silent(6));
    assert.ok(isIn6To8s(time.now - begin));
  });

  it('Link_EndsWhileTheGatewayDoesNotRead_EndsWithin8s', async t => {
    const { time, gateway, ending, running } = await linked(t), begin = time.now;

    gateway.clients[0].pause();
    ending.abort();
    await running;

    assert.ok(time.now - begin <= 8n * second + second / 10n);
  });

  it('Link_HandshakeDoesNotEnd_DisconnectsAfter6To8s', async t => {
    const time = VirtualTime.ofProcess(t), begin = time.now, port = await freePort();
    const server = createServer(socket => {
      const drip = setInterval(() => socket.write(' '), 2000);
      socket.on('error', () => {}).on('close', () => clearInterval(drip));
      socket.write('HTTP/1.1 101 ');
    }).listen(port, '127.0.0.1');
    t.after(() => server.close());
    await once(server, 'listening');

    const { reasons } = linkTo(t, `ws://127.0.0.1:${port}`);
    await until(() => reasons.length > 0, 'the disconnection');

    assert.ok(isIn6To8s(time.now - begin));
  });
});

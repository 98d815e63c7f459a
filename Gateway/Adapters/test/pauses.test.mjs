// Tests that a pause of the process does not let a timeout end before the data that have arrived are read.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { connect, createServer } from 'node:net';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';

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
});

// Tests how a bridge treats invalid exchanges with the sync port of the plant's gateway.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { messages } from '../messages.mjs';
import { SyncServer } from './syncServer.mjs';

const { syncMessages } = messages;
const { SyncClient } = await parts('broker/syncClient');

async function connect(t) {
  const server = await SyncServer.start(t), reasons = [];
  const client = await SyncClient.open({ host: '127.0.0.1', port: server.port, token: null, isTls: false, pin: null }, reason => reasons.push(reason));
  t.after(() => client.close());
  return { server, client, reasons };
}

const DISTORTIONS = {
  'sync-other-request': reply => reply.writeUInt32LE(reply.readUInt32LE(8) + 1, 8),
  'sync-time-reversed': reply => reply.writeBigInt64LE(reply.readBigInt64LE(24) - 1n, 32),
  'sync-too-long': reply => reply.writeBigInt64LE(reply.readBigInt64LE(24) + 60_000_000_000n, 32),
};

describe('sync client', () => {
  for (const [reason, distort] of Object.entries(DISTORTIONS))
    it(`Exchange_${reason}_IsDroppedAndCounted`, async t => {
      const { server, client, reasons } = await connect(t);
      server.distort = reply => server.exchanges < 10 && distort(reply);

      const { received, sent } = await client.read();

      assert.ok(sent >= received);
      assert.deepEqual(reasons, Array(9).fill(reason));
    });

  it('Exchange_OtherTimeOfTheRequest_IsDropped', async t => {
    const { server, client, reasons } = await connect(t);
    server.distort = reply => server.exchanges === 1 && reply.writeBigInt64LE(reply.readBigInt64LE(16) + 1n, 16);

    await client.read();

    assert.deepEqual(reasons, ['sync-other-request']);
  });

  for (const [name, distort, count] of [
    ['TenInvalid', DISTORTIONS['sync-time-reversed'], 10], ['OneOfAnotherVersion', reply => reply.writeUInt8(2, 4), 1],
  ])
    it(`Exchange_${name}_ClosesTheConnection`, async t => {
      const { server, client, reasons } = await connect(t);
      server.distort = distort;

      await assert.rejects(client.read(), { message: syncMessages.invalidReply });

      await client.closed;
      assert.deepEqual([reasons.length, server.exchanges], [count, count]);
    });
});

// Tests which notifications of other connections and of other clients a client deletes, and that it uses no frames for other clients.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { NET_ID } from './cell.mjs';
import { answer, command, notificationFrame, readResult, words } from './frames.mjs';
import { AdsServer } from './server.mjs';
import { youBot } from './youbot.mjs';

const { ReadOnlyClient } = await parts('ads/readOnlyClient');

const LOCAL = { netId: '192.168.0.10.1.1', port: 32905 }, PLC = { netId: NET_ID, port: 851 };

/**
 * Connects a client. `receive` lets a notification arrive, with this handle for this address. `heard` and `deleted` have the handles whose samples
 * the client has used, and those that it has deleted.
 */
async function connected(t) {
  const server = new AdsServer(youBot()), port = await server.listen();
  t.after(() => server.close());
  const client = new ReadOnlyClient({ host: '127.0.0.1', tcpPort: port, ...PLC }, LOCAL), heard = [];
  await client.connect();
  t.after(() => client.disconnect(true));
  client.onSamples = stamps => heard.push(...stamps.flatMap(({ samples }) => samples.map(({ handle }) => handle)));
  return {
    client, heard, server,
    receive: (handle, target = LOCAL) =>
      client.parseAmsTcpPacket(notificationFrame(target, PLC, [{ stamp: 1n, samples: [{ handle, data: words(0) }] }])),
    get deleted() {
      return server.seen.filter(sent => sent.command === command.deleteNotification).map(sent => sent.group);
    },
  };
}

describe('unknown notifications', () => {
  it('Notification_OfAnotherClientOfTheMachine_IsNeitherUsedNorDeleted', async t => {
    const cell = await connected(t);

    cell.receive(76, { ...LOCAL, port: 40000 });
    // All adapters without a router have the same AMS port.
    cell.receive(77, { ...LOCAL, netId: '192.168.0.11.1.1' });
    cell.receive(78);

    await until(() => cell.deleted.includes(78), () => cell.deleted.join());
    assert.deepEqual([cell.deleted, [76, 77, 78].filter(handle => cell.heard.includes(handle))], [[78], [78]]);
  });

  it('Notification_ForTheLoopbackNetId_IsUsed', async t => {
    const cell = await connected(t);

    cell.receive(78, { ...LOCAL, netId: '127.0.0.1.1.1' });

    assert.ok(cell.heard.includes(78), cell.heard.join());
  });

  // The clients of a machine number their requests independently.
  it('Response_ForAnotherClientOfTheMachine_IsNotUsed', async t => {
    const { client } = await connected(t), { indexGroup, indexOffset } = await client.getSymbol('GVL.aJoints[0]'), others = words(0x7fffffff);
    const read = client.readRaw(indexGroup, indexOffset, 4);

    for (let invokeId = 0; invokeId < 100; invokeId++)
      client.parseAmsTcpPacket(answer({ source: { ...LOCAL, port: 40000 }, target: PLC, command: command.read, invokeId }, readResult(others)));

    assert.notDeepEqual(await read, others);
  });

  it('Notification_DeletionRefused_IsNotDeletedAgain', async t => {
    const cell = await connected(t), refused = once(cell.client, 'client-error');
    cell.receive(78);
    await refused;

    cell.receive(78);
    cell.receive(79);

    await until(() => cell.deleted.includes(79), () => cell.deleted.join());
    assert.deepEqual(cell.deleted, [78, 79]);
  });

  it('Notification_DeletionTimedOut_IsDeletedAgain', async t => {
    const cell = await connected(t), failed = once(cell.client, 'client-error');
    cell.client.settings.timeoutDelay = 10;
    cell.server.respond = () => {};
    cell.receive(78);
    await failed;

    cell.receive(78);

    await until(() => cell.deleted.length === 2, () => cell.deleted.join());
    assert.deepEqual(cell.deleted, [78, 78]);
  });

  // The PLC may use the handle again, for a notification of this client.
  it('Subscription_WithAHandleWhoseDeletionWasRefused_CanBeDeleted', async t => {
    const cell = await connected(t), refused = once(cell.client, 'client-error');
    const { indexGroup, indexOffset, size } = await cell.client.getSymbol('GVL.aJoints[0]');
    const subscribe = () => cell.client.subscribe({ target: { indexGroup, indexOffset, size }, callback: () => {} });
    const { notificationHandle } = await subscribe(), next = notificationHandle + 1;
    cell.receive(next);
    await refused;
    const before = cell.server.notifications, subscription = await subscribe();

    await subscription.unsubscribe();

    assert.deepEqual([subscription.notificationHandle, cell.server.notifications], [next, before]);
  });
});

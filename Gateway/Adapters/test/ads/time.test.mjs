import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';
import { NET_ID } from './cell.mjs';
import { notificationFrame, words } from './frames.mjs';

const { adsMessages } = messages;
const { bitIn, Cycles, NotificationTime, numberOf, ofFileTime, ReadOnlyClient } = await parts(
  'samples/number', 'ads/cycles', 'ads/plcTime', 'ads/decoding', 'times', 'ads/readOnlyClient');

describe('cycles of a PLC', () => {
  const met = (cycles, perDelay) => {
    const taken = [], dropped = [];
    const all = new Cycles(perDelay, (time, values) => taken.push([time, values[0].value]), values => dropped.push(...values.map(v => v.value)));
    for (let i = 0; i < cycles; i++) all.add(BigInt(i), [{ joint: 0, value: i }], undefined);
    for (let i = 0; i < cycles; i++) all.add(BigInt(i), [], BigInt(1000 + i));
    return { taken, dropped };
  };

  it('Values_TimesArriveOneMaximumDelayLater_AllGetTheirTime', () => {
    const { taken, dropped } = met(50, 50);

    assert.deepEqual([taken.length, dropped], [50, []]);
    assert.ok(taken.every(([time, value]) => time === BigInt(1000 + value)));
  });

  it('Values_TimesNeverArrive_AreDroppedBeyondTheLimit', () => assert.equal(met(1000, 50).dropped.length, 1000 - 116));
});

describe('words of a PLC', () => {
  for (const [type, write] of [[20, 'writeBigInt64LE'], [21, 'writeBigUInt64LE']])
    it(`Word_Of64Bits_HasAllItsBits (type ${type})`, () => {
      const data = Buffer.alloc(8);
      data[write]((1n << 60n) | 5n);

      const number = numberOf({ adsDataType: type }, data);

      assert.deepEqual([0, 1, 2, 60].map(bit => bitIn(number, bit)), [1, 0, 1, 1]);
    });
});

describe('time by notifications', () => {
  const STAMP = 133_000_000_000_000_000n, PLACE = { indexGroup: 1, indexOffset: 2, size: 4 };
  const LOCAL = { netId: '192.168.0.10.1.1', port: 32905 }, PLC = { netId: NET_ID, port: 851 };

  /** Simulates a PLC whose first notification arrives before (`early`) or after the response to the subscription. */
  function plc({ early, handles = [1, 2, 3] }) {
    const time = new NotificationTime({
      subscribe: async () => {
        const notificationHandle = handles.shift(), stamp = STAMP + BigInt(handles.length);
        if (early) time.saw(notificationHandle, stamp);
        else setImmediate(() => setImmediate(() => time.saw(notificationHandle, stamp)));
        return { notificationHandle, unsubscribe: async () => {} };
      },
    }, PLACE);
    return time;
  }

  for (const early of [true, false])
    it(`NotificationTime_${early ? 'NotifiedBeforeTheAnswer' : 'NotifiedAfterTheAnswer'}_IsTheTimeStampOfTheNotification`, async () => {
      const time = plc({ early });

      assert.deepEqual([(await time.read()).sent, (await time.read()).sent], [ofFileTime(STAMP + 2n), ofFileTime(STAMP + 1n)]);
    });

  /** Starts a reading and ends its timeout, then lets these bytes arrive, as after a pause of the process. */
  async function readAfterAPause(t, bytes) {
    const wait = new Promise(resolve => t.mock.method(globalThis, 'setTimeout', resolve));
    const client = new ReadOnlyClient({ host: '127.0.0.1', tcpPort: 1, ...PLC }, LOCAL), time = new NotificationTime(client, PLACE);
    t.mock.method(client, 'subscribe', async () => ({ notificationHandle: 1, unsubscribe: async () => {} }));
    client.connection = { connected: true, localAmsNetId: LOCAL.netId, localAdsPort: LOCAL.port };
    client.settings.deleteUnknownSubscriptions = false;
    client.onSamples = stamps => stamps.forEach(({ stamp, samples }) => time.saw(samples[0].handle, stamp));
    const read = time.read(), end = await wait;
    end();
    client.receiveBuffer = bytes;
    client.handleReceivedData();
    return (await read).sent;
  }

  const frameOf = handle => notificationFrame(LOCAL, PLC, [{ stamp: STAMP, samples: [{ handle, data: words(0) }] }]);

  // ads-client parses each frame that has arrived in a step of its own.
  for (const others of [0, 1, 2, 50])
    it(`NotificationTime_NotificationArrivedDuringAPause_IsUsed (after ${others} other frames)`, async t => {
      const bytes = Buffer.concat([...Array(others).fill(frameOf(2)), frameOf(1)]);

      assert.equal(await readAfterAPause(t, bytes), ofFileTime(STAMP));
    });

  it('NotificationTime_OnlyAPartOfTheNotificationArrived_TimesOut', async t => {
    await assert.rejects(readAfterAPause(t, frameOf(1).subarray(0, -1)), { message: adsMessages.noNotification(1500) });
  });

  it('NotificationTime_HandleOfAnEarlierRequest_IsIgnored', async () => {
    const time = plc({ early: false, handles: [1, 1] });
    await time.read();

    const next = time.read();
    time.saw(1, STAMP - 1n);

    assert.equal((await next).sent, ofFileTime(STAMP));
  });
});

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';

const { bitIn, Cycles, NotificationTime, numberOf, ofFileTime } = await parts('samples/number', 'ads/cycles', 'ads/plcTime', 'ads/decoding', 'times');

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
  const STAMP = 133_000_000_000_000_000n;

  /** Simulates a PLC whose first notification arrives before (`early`) or after the response to the subscription. */
  function plc({ early, handles = [1, 2, 3] }) {
    const time = new NotificationTime({
      subscribe: async () => {
        const notificationHandle = handles.shift(), stamp = STAMP + BigInt(handles.length);
        if (early) time.saw(notificationHandle, stamp);
        else setImmediate(() => setImmediate(() => time.saw(notificationHandle, stamp)));
        return { notificationHandle, unsubscribe: async () => {} };
      },
    }, { indexGroup: 1, indexOffset: 2, size: 4 });
    return time;
  }

  for (const early of [true, false])
    it(`NotificationTime_${early ? 'NotifiedBeforeTheAnswer' : 'NotifiedAfterTheAnswer'}_IsTheTimeStampOfTheNotification`, async () => {
      const time = plc({ early });

      assert.deepEqual([(await time.read()).sent, (await time.read()).sent], [ofFileTime(STAMP + 2n), ofFileTime(STAMP + 1n)]);
    });

  // ads-client reads a packet in a step of its own after its arrival.
  it('NotificationTime_NotificationArrivedDuringAPauseOfTheProcess_IsUsed', async t => {
    const wait = new Promise(resolve => t.mock.method(globalThis, 'setTimeout', resolve));
    const time = new NotificationTime(
      { subscribe: async () => ({ notificationHandle: 1, unsubscribe: async () => {} }) }, { indexGroup: 1, indexOffset: 2, size: 4 });
    const read = time.read(), end = await wait;

    end();
    setImmediate(() => time.saw(1, STAMP));

    assert.equal((await read).sent, ofFileTime(STAMP));
  });

  it('NotificationTime_HandleOfAnEarlierRequest_IsIgnored', async () => {
    const time = plc({ early: false, handles: [1, 1] });
    await time.read();

    const next = time.read();
    time.saw(1, STAMP - 1n);

    assert.equal((await next).sent, ofFileTime(STAMP));
  });
});

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell, MS, T } from './inVirtualTime.mjs';
import { messages } from '../messages.mjs';

const { refusalMessages } = messages;

const two = () => cell({ signals: [{ signal: 'closed' }, { signal: 'speed' }], values: ['closed', 'speed'] });

describe('signals', () => {
  it('Value_Changed_IsPublishedOnceWithItsTimeStamp', () => {
    const { take, changes, time, stateOf } = two();

    for (; time.ms < 50; time.ms += 10) take({ 0: time.ms >= 20, 1: 3.5 });

    assert.deepEqual(changes(), [['closed', 0, 0n], ['speed', 3.5, 0n], ['closed', 1, 20n]]);
    assert.deepEqual(['closed', 'speed'].map(name => stateOf(`signal/${name}`)), ['live', 'live']);
  });

  // Words may be signed, and a 64-bit number is a bigint.
  for (const [value, bits] of [[0b1010, [0, 1, 0, 0]], [-2, [0, 1, 1, 1]], [-32768, [0, 0, 0, 1]], [2n ** 63n + 2n, [0, 1, 0, 0]], [true, [1, 0, 0, 0]]])
    it(`Bits_Of${value}_AreZeroOrOne`, () => {
      const places = [0, 1, 14, 31], names = places.map(String);
      const { take, changes } = cell({ signals: places.map(bit => ({ signal: `${bit}`, bit })), values: names });

      take(Object.fromEntries(names.map((_, i) => [i, value])));

      assert.deepEqual(changes().map(([name, one]) => [name, one]), names.map((name, i) => [name, bits[i]]));
    });

  for (const value of [1.5, 2 ** 60, 'on'])
    it(`Bit_Of${value}_IsRefused`, () => {
      const { take, changes, status } = cell({ signals: [{ signal: 'closed', bit: 0 }], values: ['closed'] });

      take({ 0: value });

      const text = typeof value === 'number' ? refusalMessages.noBits(value) : refusalMessages.notNumber(value);
      assert.deepEqual([changes(), status.signals.reasonOf('closed'), Number(status.values()['refused/type'])], [[], text, 1]);
    });

  it('Signals_256WithLongNamesAndOneTimeStamp_AreSentInMessagesOfUpTo64KiB', () => {
    const names = Array.from({ length: 256 }, (_, i) => `${i}`.padEnd(128, '\u001f')), indices = Object.keys(names);
    const { take, changes, sent, clock, output } = cell({ signals: names.map(signal => ({ signal })), values: names });
    clock.isSettled = false;
    take(Object.fromEntries(indices.map(i => [i, -1e-300 / 3])));

    clock.isSettled = true;
    output.check();

    // The gateway measures the complete message, which also has op and topic.
    const lengths = sent.map(([topic, msg]) => Buffer.byteLength(JSON.stringify({ op: 'publish', topic, msg })));
    assert.ok(lengths.every(bytes => bytes <= 65536), `${lengths}`);
    assert.deepEqual([changes().length, new Set(changes().map(([name]) => name)).size], [256, 256]);
  });

  it('Changes_InOneNotification_AreAllPublished', () => {
    const { output, changes, time } = two();
    time.ms = 30;

    output.publish([0, 1, 0].map((value, i) => ({ index: 0, value, stamp: T + BigInt(10 * i) * MS })));

    assert.deepEqual(changes(), [['closed', 0, 0n], ['closed', 1, 10n], ['closed', 0, 20n]]);
  });

  it('FirstValue_WithOldTimeStamp_KeepsIt', () => {
    const { take, changes, time } = two();
    time.ms = 7_200_000;

    take({ 0: true }, { stamp: T, isFirst: true });

    assert.deepEqual(changes(), [['closed', 1, 0n]]);
  });

  it('Change_BeforeTheClockIsKnown_IsPublishedAfterwards', () => {
    const { take, changes, clock, output, time } = two();
    clock.isSettled = false;
    take({ 0: 1 });
    assert.deepEqual(changes(), []);

    clock.isSettled = true;
    time.ms = 250;
    output.check();

    assert.deepEqual(changes(), [['closed', 1, 0n]]);
  });

  it('Gateway_Reconnected_ReceivesTheValuesRepeatedlyForThirtySeconds', () => {
    const { take, changes, output, time } = two();
    take({ 0: 1, 1: 2 });

    time.ms = 1000;
    output.signals.sender.opened();
    for (; time.ms < 60_000; time.ms += 250) {
      output.hold(T, 0n, new Set());
      output.check();
    }

    const closed = changes().filter(([name]) => name === 'closed');
    assert.ok(closed.length >= 30 && closed.length <= 32, `${closed.length}`);
    assert.deepEqual(new Set(closed.map(([, value, stamp]) => `${value} ${stamp}`)), new Set(['1 0']));
  });

  it('Gateway_RefusesSignalsLongAfterTheConnection_ReceivesThemEveryTenSecondsUntilItAcceptsThem', () => {
    const { take, changes, output, time } = two(), seen = [];
    output.signals.sender.opened();
    for (time.ms = 60_000; time.ms < 120_000; time.ms += 250) {
      if (time.ms === 60_000) take({ 0: 1 });
      output.check();
      // The gateway refuses all signals until 85 s.
      if (changes().length > seen.length && time.ms < 85_000) output.signals.sender.refused('publish /signals dropped: … (Unsynchronised)');
      while (seen.length < changes().length) seen.push(time.ms);
    }

    assert.deepEqual(seen, [60_000, 60_250, 70_250, 80_250, 90_250]);
  });

  it('Gateway_RefusesAnotherTopic_DoesNotReceiveTheSignalsAgain', () => {
    const { take, changes, output, time } = two();
    take({ 0: 1 });

    for (; time.ms < 5000; time.ms += 250) {
      output.signals.sender.refused('publish /joint_states dropped: … (JointTaken)');
      output.check();
    }

    assert.equal(changes().length, 1);
  });

  it('Signals_OneNotConfirmed_OnlyThatSignalIsInFault', () => {
    const { take, output, time, stateOf } = two();
    take({ 0: 1, 1: 2 });

    for (; time.ms < 3000; time.ms += 250) {
      output.hold(T, 0n, new Set([1]));
      output.check();
    }

    assert.deepEqual([stateOf('signal/closed'), stateOf('signal/speed')], ['live', 'fault']);
  });

  it('Value_NotANumber_IsRefusedAndTheLastValueIsKept', () => {
    const { take, changes, stateOf, status, time } = two();
    take({ 0: 1 });

    time.ms = 10;
    take({ 0: 'open' });

    assert.equal(changes().length, 1);
    assert.equal(stateOf('signal/closed'), 'refused');
    assert.ok(status.values()['signal/closed'].includes(refusalMessages.notNumber('open')), status.values()['signal/closed']);
  });

  it('TimeStamp_InTheFutureOrMissing_IsRefused', () => {
    const { take, changes, status } = two();

    take({ 0: 1 }, { stamp: T + 5000n * MS });
    take({ 1: 1 }, { stamp: null });

    assert.deepEqual(changes(), []);
    assert.deepEqual([Number(status.values()['refused/stamp-future']), Number(status.values()['refused/stamp-missing'])], [1, 1]);
  });

  it('Value_Lost_SignalIsInFault', () => {
    const { take, output, stateOf, status } = two();
    take({ 0: 1 });

    output.lose(0, { reason: 'node-gone', text: 'the server no longer has this node' });
    output.hold(T, 0n, new Set());

    assert.equal(stateOf('signal/closed'), 'fault');
    assert.equal(status.level, 2);
  });
});

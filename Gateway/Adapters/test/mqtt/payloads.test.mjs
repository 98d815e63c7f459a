// Tests messages that are not numbers: each entry of the configuration causes one line in the log and one state, and the process continues.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { missing } from '../broker/mosquitto.mjs';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { messages } from '../messages.mjs';
import { nanoseconds } from '../rosbridge.mjs';
import { cell, changes, poses } from './cell.mjs';

const { mqttMessages, refusalMessages } = messages;

const { stampIn, TopicValues } = await parts('mqtt/stamps', 'samples/topicValues');

const REST = `joints:
  - { joint: axis, topic: cell, field: joints.0 }
frames:
  - frame: part
    position: { unit: m, x: { topic: cell, field: x }, y: { topic: cell, field: y }, z: 0 }
    quaternion: { x: 0, y: 0, z: { topic: cell, field: qz }, w: { topic: cell, field: qw } }
signals:
  - { signal: closed, topic: cell, field: closed }
`;
const good = { joints: [1], x: 1, y: 2, qz: 0, qw: 1, closed: true };

describe('mqtt payloads', { skip: missing, concurrency: 3 }, () => {
  for (const [name, payload, reason] of [
    ['Empty', '', 'malformed'],
    ['NotJson', '{"joints": [', 'malformed'],
    ['Bytes', '\u0000\u0001\ufffd', 'malformed'],
    ['Text', '"far"', 'field'],
    ['Null', 'null', 'field'],
    ['Number', '7', 'field'],
    ['List', '[1, 2]', 'field'],
    ['Prototype', '{"__proto__": {"x": 1}}', 'field'],
    ['TextsInFields', JSON.stringify({ joints: ['1'], x: '1', y: '2', qz: '0', qw: '1', closed: 'true' }), 'type'],
    ['ObjectsInFields', JSON.stringify({ joints: [{}], x: {}, y: [], qz: null, qw: {}, closed: {} }), 'type'],
  ])
    it(`Payload_${name}_CausesOneLogLineForEachEntry`, async t => {
      const { bridge, adapter, send } = await cell(t, { rest: REST });

      for (let i = 0; i < 3; i++) await send('cell', payload);
      await until(() => Number(bridge.state?.[`refused/${reason}`]) >= 18, () => JSON.stringify(bridge.state));
      await send('cell', good);

      await until(() => changes(bridge, 'closed').length >= 1 && poses(bridge, 'part').length >= 1 && bridge.jointStates.length >= 1,
        () => JSON.stringify(bridge.state));
      for (const entry of ['axis', 'part', 'closed'])
        assert.equal(adapter.err.split('\n').filter(line => line.includes(`${entry} refused (${reason})`)).length, 1, adapter.err);
    });

  it('RetainedMessage_Deleted_ItsValueIsRefusedAsEmpty', async t => {
    const { bridge, send } = await cell(t, { rest: REST, prepare: ({ send }) => send('cell', good, { retain: true }) });
    await until(() => bridge.state?.['signal/closed']?.startsWith('live'), () => JSON.stringify(bridge.state));

    await send('cell', '', { retain: true });

    await until(() => bridge.state['signal/closed'].startsWith('refused') && bridge.state['signal/closed'].endsWith(mqttMessages.empty('cell')),
      () => JSON.stringify(bridge.state));
  });

  it('Quaternion_NotOfUnitLength_IsRefusedAndOtherValuesAreRead', async t => {
    const { bridge, send } = await cell(t, { rest: REST });

    await send('cell', { ...good, qw: 0.5 });

    await until(() => bridge.state?.['refused/not-unit'] === '1' && bridge.jointStates.length >= 1, () => JSON.stringify(bridge.state));
    assert.deepEqual(poses(bridge, 'part'), []);
  });

  for (const [name, time] of [['Missing', {}], ['Text', { t: 'now' }], ['OtherUnit', { t: '2026-11-24T12:00:00Z' }], ['Null', { t: null }]])
    it(`Time_${name}_IsRefused`, async t => {
      const { bridge, send } = await cell(t, { plant: '  time: { field: t, unit: ms }\n', rest: REST });

      await send('cell', { ...good, ...time });

      await until(() => Number(bridge.state?.['refused/stamp-missing']) === 6, () => JSON.stringify(bridge.state));
      assert.deepEqual([bridge.jointStates, poses(bridge, 'part'), bridge.published('/signals')], [[], [], []]);
    });

  for (const [name, zone, sent, text] of [
    ['WithoutAZone', '', { t: '2026-11-24T12:00:00.125' }, mqttMessages.noZone('cell', 't')],
    ['WithoutAZoneButInvalid', ', zone: UTC', { t: '2026-13-24T12:00:00.125' }, mqttMessages.noTime('cell', 'iso', 't')],
    ['Missing', '', {}, mqttMessages.noTime('cell', 'iso', 't')],
  ])
    it(`Time_Iso${name}_IsRefusedWithItsReason`, async t => {
      const { bridge, send } = await cell(t, { plant: `  time: { field: t, unit: iso${zone} }\n`, rest: REST });

      await send('cell', { ...good, ...sent });

      await until(() => bridge.joint('axis')?.reason.endsWith(text), () => JSON.stringify(bridge.state));
    });

  for (const [zone, offset] of [['UTC', 0], ['+01:30', 90 * 60_000]])
    it(`Time_IsoWithoutAZone_IsInTheConfiguredZone${zone}`, async t => {
      const { bridge, send, now } = await cell(t, { plant: `  time: { field: t, unit: iso, zone: "${zone}" }\n`, rest: REST });
      const ms = now() / 1_000_000n;

      await send('cell', { ...good, t: new Date(Number(ms) + offset).toISOString().replace('Z', '') });

      await until(() => bridge.jointStates.length > 0, () => JSON.stringify(bridge.state));
      assert.equal(nanoseconds(bridge.jointStates[0].header.stamp), ms * 1_000_000n);
    });

  it('Message_OfSparkplug_NamesTheProtocol', async t => {
    const topic = 'spBv1.0/plant/NDATA/cell', { bridge, send } = await cell(t, { rest: REST.replaceAll('topic: cell', `topic: ${topic}`) });

    await send(topic, '\u0008\u0001\ufffd');

    await until(() => bridge.joint('axis')?.reason.endsWith(mqttMessages.sparkplug(topic)), () => JSON.stringify(bridge.state));
  });

  it('Time_InSecondsInsteadOfMilliseconds_IsRefusedAsOld', async t => {
    const { bridge, send, now } = await cell(t, { plant: '  time: { field: t, unit: ms }\n', rest: REST });

    await send('cell', { ...good, t: Number(now() / 1_000_000_000n) });

    await until(() => Number(bridge.state?.['refused/stamp-old']) > 0, () => JSON.stringify(bridge.state));
    assert.deepEqual([bridge.jointStates, poses(bridge, 'part')], [[], []]);
  });
});

describe('mqtt stamps', () => {
  const T = 1_795_478_400_000_000_000n;
  for (const [value, unit, expected] of [
    [1_795_478_400.125, 's', T + 125_000_000n],
    [1_795_478_400_125, 'ms', T + 125_000_000n],
    [1_795_478_400_125_500, 'us', T + 125_500_000n],
    ['1795478400125500123', 'ns', T + 125_500_123n],
    ['2026-11-24T00:00:00Z', 'iso', T],
    ['2026-11-24T00:00:00.125500123Z', 'iso', T + 125_500_123n],
    ['2026-11-24T01:30:00.5+01:30', 'iso', T + 500_000_000n],
    ['2026-11-24T00:00:00', 'iso', null],
    ['2026-11-24', 'iso', null],
    ['2026-13-24T00:00:00Z', 'iso', null],
    [1_795_478_400, 'iso', null],
    ['-5', 'ms', null],
    ['1e3', 'ms', null],
    [true, 'ms', null],
    [{}, 's', null],
    [undefined, 's', null],
  ])
    it(`TimeStamp_${String(value)}In_${unit}_${expected === null ? 'IsNull' : 'IsConverted'}`, () => assert.equal(stampIn(value, unit), expected));

  for (const [value, zone, expected] of [
    ['2026-11-24T00:00:00.5', 'Z', T + 500_000_000n],
    ['2026-11-24T01:30:00', '+01:30', T],
    ['2026-11-24T00:00:00Z', '+01:30', T],
    ['2026-11-24', 'Z', null],
  ])
    it(`TimeStamp_${value}WithTheDefaultZone${zone}_${expected === null ? 'IsNull' : 'IsConverted'}`, () => assert.equal(stampIn(value, 'iso', zone), expected));
});

describe('values of topics', () => {
  const values = new TopicValues([{ address: { topic: 'a', field: 'x.1' } }, { address: { node: 'i=1' } }, { address: { topic: 'a' } }, { address: { topic: 'b' } }]);

  it('TopicValues_Topics_AreListedWithTheIndicesOfTheirValues', () =>
    assert.deepEqual([values.topics, values.indicesOf('a'), values.indicesOf('c')], [['a', 'b'], [0, 2], []]));

  it('Values_InAMessage_AreFoundByTheirPaths', () =>
    assert.deepEqual(values.in('a', { x: [1, 2] }, 5n).map(({ index, value, stamp }) => [index, value, stamp]), [[0, 2, 5n], [2, { x: [1, 2] }, 5n]]));

  for (const [name, field, message, value, text] of [
    ['NamesWithDots', ['Values', 'MAIN.fAxis1'], { Values: { 'MAIN.fAxis1': 1.5 } }, 1.5, 'Values."MAIN.fAxis1"'],
    ['Indices', ['tags', 1, 'value'], { tags: [{ value: 1 }, { value: 2 }] }, 2, 'tags.1.value'],
  ])
    it(`Field_ListWith${name}_IsFound`, () => {
      const listed = new TopicValues([{ address: { topic: 'a', field } }]);

      assert.equal(listed.in('a', message, 5n)[0].value, value);
      assert.equal(listed.in('a', {}, 5n)[0].refusal.text, refusalMessages.noField('a', text));
    });

  for (const message of [null, 5, 'text', [], { x: null }, { x: [1] }, { x: 'ab' }])
    it(`Values_MissingIn${JSON.stringify(message)}_AreRefused`, () => assert.equal(values.in('a', message, 5n)[0].refusal.reason, 'field'));
});

// Tests in virtual time the values of a control system that are older or newer than their time stamps.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { temporaryFile } from '../temporary.mjs';
import { cell, MS } from './inVirtualTime.mjs';

const { kinds, readConfiguration } = await parts('configuration/configuration', 'kinds');

const constant = value => ({ constant: value });
const PART = {
  frame: 'part', parents: ['world'], selector: null, position: [{ value: 1 }, constant(0), constant(0)], scale: 1, rotation: null, faultAfterMs: null, maxDeceleration: null,
};
const TABLE = { ...PART, frame: 'table', position: [constant(1), constant(0), constant(0)] };

const delayed = delayMs => cell(
  { joints: [{ joint: 'a', name: 'a', robot: '', scale: 1, offset: 0 }], frames: [PART, TABLE], signals: [{ signal: 'closed' }], values: ['a', 'part x', 'closed'] },
  { stampDelay: BigInt(delayMs) * MS });

/** Returns the times of all published values after the start in ms. */
const timesOf = ({ sent, poses, changes }) => [
  ...sent.filter(([topic]) => topic === '/joint_states').map(([, { header: { stamp: { sec, nanosec } } }]) => sec * 1000 + nanosec / 1e6 - 1_700_000_000_000),
  ...poses().map(({ ms }) => ms), ...changes().map(([, , ms]) => Number(ms)),
];

describe('the delay of time stamps', () => {
  for (const delayMs of [100, -80])
    it(`Values_${delayMs}MsOlderThanTheirTimeStamps_HaveTheTimeOfTheirMeasurement`, () => {
      const one = delayed(delayMs);
      one.time.ms = 500;

      one.take({ 0: 0.5, 1: 2, 2: 1 });

      assert.deepEqual(timesOf(one), Array(3).fill(500 - delayMs));
      assert.deepEqual(['joint/a', 'frame/part', 'signal/closed'].map(one.stateOf), ['live', 'live', 'live']);
    });

  it('Values_AtRest_AreConfirmedWithTheTimeOfTheirMeasurement', () => {
    const one = delayed(100);
    one.take({ 0: 0.5, 1: 2, 2: 1 });
    one.time.ms = 1200;

    one.output.hold(one.clock.now, 0n);

    assert.deepEqual(timesOf(one), [-100, 1100, -100, 1100, -100]);
  });

  it('StationaryFrame_OfAnyDelay_HasNoTime', () => assert.deepEqual(delayed(100).kept[0][1].transforms[0].header.stamp, { sec: 0, nanosec: 0 }));

  it('LostSample_SentAgain_KeepsItsTime', () => {
    const one = delayed(100), { output, sent, status } = one;
    output.unconfirmedMs = null;
    one.take({ 0: 0.5 });
    output.repeater.published(...sent[0]);
    one.time.ms = 1500;
    output.check();
    assert.equal(status.joints.stateOf('a'), 'rest');

    output.repeater.opened();
    output.check();

    assert.deepEqual(timesOf(one), [-100, -100]);
  });

  for (const [kind, plant] of Object.entries({
    opcua: 'endpoint: opc.tcp://plc', ads: 'endpoint: ads://plc/1.1.1.1.1.1:851, plain: true', rtde: 'host: ur', ros: 'endpoint: ws://127.0.0.1', mqtt: 'endpoint: mqtt://127.0.0.1',
  }))
    it(`Configuration_OfKind${kind}_HasTheDelay`, () => {
      const delayOf = more => readConfiguration(
        temporaryFile('plant.yaml', `plant: { kind: ${kind}, ${plant}${more} }\nsignals: []\n${kind === 'mqtt' ? 'joints: [{ joint: a, topic: a }]\n' : ''}`), {}, kinds).plant.stamp_delay_ms;

      assert.deepEqual([delayOf(''), delayOf(', stamp_delay_ms: 80')], [0, 80]);
      assert.throws(() => delayOf(', stamp_delay_ms: 1001'), /plant\.stamp_delay_ms: value 1001; /);
    });
});

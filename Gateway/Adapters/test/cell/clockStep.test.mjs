// Tests in virtual time that a step of the control clock does not discard values that the source does not send again.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell, MS, T } from './inVirtualTime.mjs';

const read = value => ({ value }), constant = number => ({ constant: number });
const joint = { joint: 'a', name: 'a', robot: '', scale: 1, offset: 0 };
/** A frame whose x coordinate (mm) is read. */
const framed = index => ({
  frame: 'part', parents: ['world'], selector: null, position: [read(index), constant(0), constant(0)], scale: 0.001, rotation: null,
  faultAfterMs: null,
});
/** A frame whose x coordinate (mm) and angle about z (degrees) are read. */
const part = {
  frame: 'part', parents: ['world'], selector: null, position: [read(0), constant(0), constant(0)], scale: 0.001, faultAfterMs: null,
  rotation: { kind: 'angles', parts: [constant(0), constant(0), read(1)], order: 'xyz', isFixed: true, scale: Math.PI / 180 },
};

describe('a step of the control clock', () => {
  for (const backMs of [-7_200_000, 7_200_000])
    it(`ClockStep_Of${-backMs}ms_ComponentsKeepTheirValues`, () => {
      const { output, take, poses, time, stateOf } = cell({ frames: [part], values: ['part x', 'part angle z'] }), moved = [];
      output.frames.silence.unconfirmedMs = null;
      take({ 0: 100, 1: 90 });
      [time.ms, time.setBackMs] = [900, backMs];

      output.clockStepped();
      for (; time.ms < 3000; time.ms += 100) {
        take({ 0: time.ms });
        output.check();
        moved.push([time.ms - backMs, 0.001 * time.ms]);
      }

      assert.deepEqual(poses().slice(1).map(({ ms, position }) => [ms, position[0]]), moved);
      assert.ok(poses().every(({ rotation }) => Math.abs(rotation[2] - Math.SQRT1_2) < 1e-12));
      assert.equal(stateOf('frame/part'), 'live');
    });

  for (const backMs of [-7_200_000, 1500, 7_200_000])
    it(`ClockStep_Of${-backMs}ms_KeepsValuesAndSendsTheNextOneEvenIfItIsEqual`, () => {
      const { take, changes, time, output, clock, stateOf } = cell({ signals: [{ signal: 'closed' }, { signal: 'speed' }], values: ['closed', 'speed'] });
      take({ 0: 1, 1: 3.5 });
      [time.ms, time.setBackMs] = [900, backMs];
      const now = (clock.now - T) / MS;

      output.clockStepped();
      output.signals.sender.opened();
      assert.deepEqual(changes().slice(2), [['closed', 1, 0n], ['speed', 3.5, 0n]]);
      take({ 0: 1 }, { stamp: null, isFirst: true });
      take({ 0: 1 });
      take({ 1: 4 });

      assert.deepEqual(changes().slice(4), [['closed', 1, now], ['speed', 4, now]]);
      assert.deepEqual([stateOf('signal/closed'), stateOf('signal/speed')], ['live', 'live']);
    });

  for (const backMs of [-7_200_000, 7_200_000])
    it(`ClockStep_Of${-backMs}ms_ConfirmedValuesAtRestAreSentWithTheNewTime`, () => {
      const { output, take, poses, sent, changes, time, clock, stateOf } =
        cell({ joints: [joint], frames: [framed(1)], signals: [{ signal: 'closed' }], values: ['a', 'part x', 'closed'] });
      take({ 0: 1.5, 1: 100, 2: 1 });
      [time.ms, time.setBackMs] = [900, backMs];
      sent.length = 0;

      output.clockStepped();
      output.hold(T + 900n * MS, 30n * MS);
      for (; time.ms < 3000; time.ms += 50) {
        output.hold(clock.now - 100n * MS, 30n * MS);
        output.check();
      }

      const first = BigInt(backMs < 0 ? 900 : 800 - backMs);
      assert.deepEqual(changes(), [['closed', 1, first]]);
      assert.ok(sent.some(([topic, { position }]) => topic === '/joint_states' && position[0] === 1.5));
      assert.ok(poses().some(({ ms, position }) => ms > 800 - backMs && position[0] === 0.1));
      assert.deepEqual(['joint/a', 'frame/part', 'signal/closed'].map(stateOf), ['rest', 'rest', 'live']);
    });
});

// Tests in virtual time that a step of the control clock does not discard values that the source does not send again.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell, MS, T } from './inVirtualTime.mjs';

const read = value => ({ value }), constant = number => ({ constant: number });
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
});

// Tests in virtual time that an object has the numbers of its parent while its parent changes.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell, MS, T } from './inVirtualTime.mjs';

const read = value => ({ value }), constant = number => ({ constant: number });
const [X, PARENT, Y] = [0, 1, 2];
/** An object whose x coordinate (m) and parent are read from variables of their own. */
const part = { frame: 'part', parents: ['world', 'tool0'], selector: read(PARENT), position: [read(X), constant(0), constant(0)], scale: 1, rotation: null, faultAfterMs: null, maxDeceleration: null };

/** Creates an object that is known to be in the world at 0.70 m since 0 ms, and a server that samples each variable every 50 ms. */
function gripped(frame = part, values = ['part x', 'part parent']) {
  const one = cell({ frames: [frame], values }), { output, take, time } = one;
  output.samplingS = 0.05;
  take({ [X]: 0.7, [PARENT]: 0, ...(values.length > 2 ? { [Y]: 0.2 } : {}) });
  const stampOf = ms => T + BigInt(ms) * MS;
  return {
    ...one,
    /** Publishes one notification at `at` ms: a list of the time in ms, the value and its number. */
    notify: (at, ...changes) => {
      time.ms = at;
      output.publish(changes.map(([ms, index, value]) => ({ index, value, stamp: stampOf(ms) })));
    },
    /** Confirms at `at` ms that all values are unchanged up to `ms`. */
    confirm: (at, ms) => {
      time.ms = at;
      output.hold(stampOf(ms), 150n * MS, new Set());
    },
    seen: () => one.poses().map(({ ms, parent, position }) => [ms, parent, position[0]]),
  };
}

/** Asserts that no pose has a number of the other parent. */
function assertMatched(seen) {
  for (const [ms, parent, x] of seen) assert.equal(x > 0.5, parent === 'world', `${ms} ms: ${x} m in ${parent}`);
}

describe('a change of the parent', () => {
  for (const [name, changes] of [['PoseFirst', [[1050, X, 0], [1075, PARENT, 1]]], ['ParentFirst', [[1050, PARENT, 1], [1075, X, 0]]], ['Together', [[1075, X, 0], [1075, PARENT, 1]]]])
    for (const areTogether of [true, false])
      it(`Parent_Sampled${name}In${areTogether ? 'One' : 'Two'}Notifications_IsPublishedOnceItsNumbersAreKnown`, () => {
        const { notify, seen } = gripped();

        if (areTogether) notify(1100, ...changes);
        else for (const [i, change] of changes.entries()) notify(1100 + 50 * i, change);

        assert.deepEqual(seen(), [[0, 'world', 0.7], [1075, 'tool0', 0]]);
      });

  it('Parent_ChangesWhileTheObjectMoves_NoPoseHasANumberOfTheOtherParent', () => {
    for (let phase = 1; phase <= 50; phase++)
      for (let change = 900; change < 950; change++) {
        // The belt moves the object at 0.3 m/s. The two variables are sampled every 50 ms, the second one later by the phase.
        const one = cell({ frames: [part], values: ['part x', 'part parent'] }), { output, take, time, clock, poses } = one;
        output.samplingS = 0.05;
        for (; time.ms < 1500; time.ms++) {
          const isGripped = time.ms >= change;
          if (time.ms % 50 === 0 && (time.ms === 0 || !isGripped || time.ms < change + 50)) take({ [X]: isGripped ? 0 : 0.55 + 0.0003 * time.ms });
          if (time.ms % 50 === phase % 50 && (time.ms < 50 || (isGripped && time.ms < change + 50))) take({ [PARENT]: isGripped ? 1 : 0 });
          if (time.ms % 60 === 0) output.hold(clock.now - 55n * MS, 150n * MS, new Set());
        }

        const seen = poses().map(({ ms, parent, position }) => [ms, parent, position[0]]);
        assertMatched(seen);
        const [first] = seen.find(([, parent]) => parent === 'tool0');
        assert.ok(first >= change && first <= change + 150, `gripped at ${change} ms, phase ${phase} ms: ${first} ms`);
      }
  });

  it('Parent_ChangesAndTheNumbersDoNot_IsPublishedOnceTheyAreConfirmed', () => {
    const { notify, confirm, seen } = gripped();

    notify(1100, [1050, PARENT, 1]);
    confirm(1150, 1090);
    const before = seen().length;
    confirm(1200, 1110);

    assert.deepEqual([before, seen().slice(1)], [1, [[1110, 'tool0', 0.7]]]);
  });

  it('Numbers_JumpInTheSameParent_ArePublishedOnceTheParentIsConfirmed', () => {
    const { notify, confirm, seen } = gripped();

    notify(1100, [1050, X, 3]);
    confirm(1120, 1080);
    const before = seen().length;
    confirm(1200, 1110);

    assert.deepEqual([before, seen().slice(1)], [1, [[1110, 'world', 3]]]);
  });

  it('Numbers_JumpInTheSameParentAndMoveOn_ArePublishedWithTheNextSample', () => {
    const { notify, seen } = gripped();

    notify(1150, [1050, X, 3], [1100, X, 3.01], [1150, X, 3.02]);

    assert.deepEqual(seen().slice(1), [[1100, 'world', 3.01], [1150, 'world', 3.02]]);
  });

  it('Numbers_OfAFastObject_AreNotDelayed', () => {
    const { notify, seen } = gripped();

    for (let ms = 50; ms <= 1000; ms += 50) notify(ms, [ms, X, 0.7 + 2e-6 * ms * ms]);

    assert.deepEqual(seen().map(([ms]) => ms), Array.from({ length: 21 }, (_, i) => 50 * i));
  });

  it('Numbers_WrittenLessOftenThanSampled_AreNotDelayed', () => {
    const { output, notify, seen } = gripped();
    output.samplingS = 0.01;

    for (let ms = 100; ms <= 2000; ms += 100) notify(ms, [ms, X, 0.7 + 0.0001 * Math.min(ms, 500) + 0.0003 * Math.max(0, ms - 500)]);

    // The usual interval is known only after the first samples.
    assert.deepEqual(seen().map(([ms]) => ms).filter(ms => ms > 300), Array.from({ length: 17 }, (_, i) => 100 * (i + 4)));
  });

  it('Coordinates_OfSeparateVariables_AreNotInterpolatedBetweenParents', () => {
    const { notify, poses } = gripped({ ...part, position: [read(X), read(Y), constant(0)] }, ['part x', 'part parent', 'part y']);
    notify(50, [40, X, 0.71], [50, Y, 0.21]);
    notify(100, [90, X, 0.72], [100, Y, 0.22]);

    notify(200, [140, X, 0], [150, Y, 0], [165, PARENT, 1]);
    notify(250, [190, X, 0.001], [200, Y, 0.001]);

    for (const { ms, parent, position: [x, y] } of poses()) assert.ok(parent === 'world' ? x >= 0.7 && y >= 0.2 : x <= 0.001 && y <= 0.001, `${ms} ms: ${x}, ${y} in ${parent}`);
    assert.equal(poses().find(({ parent }) => parent === 'tool0').ms, 165);
  });

  it('Parent_OfASourceThatSendsChangesAtOnce_IsPublishedAtOnce', () => {
    const { output, notify, seen } = gripped();
    output.unconfirmedMs = null;

    notify(1050, [1050, PARENT, 1]);

    assert.deepEqual(seen().slice(1), [[1050, 'tool0', 0.7]]);
  });

  it('Parent_Invalid_IsRefusedAtOnce', () => {
    const { notify, seen, stateOf } = gripped();

    notify(1050, [1050, PARENT, 2]);

    assert.deepEqual([seen().length, stateOf('frame/part')], [1, 'refused']);
  });

  it('Parent_AfterANewConnection_IsPublishedAtOnce', () => {
    const { output, notify, seen } = gripped();

    output.restart();
    notify(1100, [1050, X, 0], [1051, PARENT, 1]);

    assert.deepEqual(seen().slice(1), [[1051, 'tool0', 0]]);
  });
});

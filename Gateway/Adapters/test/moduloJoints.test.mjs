// Tests in virtual time joints whose value begins again after each turn, such as a modulo axis from 0° to 360°.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { changes, smooth, trapezoid } from './motions.mjs';
import { MS, plant, S } from './outputInVirtualTime.mjs';
import { parts } from './parts.mjs';
import { seeded } from './seeded.mjs';

const { endOfJoint, JointNames, JointStates } = await parts('samples/endOfData', 'ros/jointNames', 'ros/jointStates');

const SEED = 360, TURN = 2 * Math.PI;
const modulo = angle => angle - TURN * Math.floor(angle / TURN + 1e-9);

/** Creates an adapter of each kind that sends the value of joint a. */
const SOURCES = {
  ServerOfChanges: joint => {
    const cell = plant([joint]);
    return { ...cell, send: value => cell.value(0, value), hold: () => cell.output.hold(cell.clock.now - 10n * MS, 30n * MS) };
  },
  Ros: joint => {
    const cell = plant([]), sent = [], { clock, status, output } = cell;
    const names = new JointNames([{ ...joint, name: 'a', scale: 1, offset: 0 }]);
    const states = new JointStates(names, 10n * S, clock, { publish: (_, msg) => sent.push(msg) }, status, output.silence);
    const send = value => states.pass({ header: { stamp: { sec: Number(clock.now / S), nanosec: Number(clock.now % S) } }, name: ['a'], position: [value] });
    return { ...cell, sent, send, hold: () => {} };
  },
};

/** Sends the changes of a motion as a value from 0 to 2π until `endS`, and continues for 3 s. */
function turned(source, joint, { position }, endS) {
  const cell = SOURCES[source]({ joint: 'a', ...joint });
  let last = null;
  for (; cell.time.ms < 1000 * (endS + 3); cell.time.ms += 10) {
    const value = modulo(position(Math.min(cell.time.ms / 1000, endS)));
    if (value !== last) cell.send(value);
    last = value;
    cell.hold();
    cell.output.checkSilence();
  }
  return cell;
}

describe('a joint whose value begins again after each turn', () => {
  for (const source of Object.keys(SOURCES)) {
    it(`Joint_${source}StopsWhereItsValueBeginsAgain_IsAtRest`, () => {
      const turn = smooth({ v: 1.875 * TURN / 4, duration: 4 });

      const { stateOf, sent } = turned(source, {}, turn, 5);

      assert.equal(stateOf('a'), 'rest');
      // Headsets compute the whole turns themselves.
      const positions = sent.map(({ position: [value] }) => value);
      assert.ok(Math.max(...positions) > 6.2 && Math.abs(positions.at(-1)) < 1e-6, `${positions.slice(-3)}`);
    });

    it(`Joint_${source}DataEndInAMotionOfSeveralTurns_IsInFault`, () => {
      assert.equal(turned(source, {}, trapezoid({ v: 3, a: 2, brakeAt: 100, brake: 2 }), 7.5).stateOf('a'), 'fault');
    });
  }

  it('Verdict_ValueFromZeroToOneTurn_IsThatOfTheWholeAngle', () => {
    const random = seeded(SEED), judged = (samples, convert) => {
      const judge = endOfJoint();
      for (const { time, value } of samples) judge.add(BigInt(Math.round((time + 10) * 1e9)), convert(value));
      return [judge.verdict(0.02), judge.verdict(0.02, true), judge.unobserved(0.02)].map(one => one?.required ?? one);
    };
    for (let i = 0; i < 100; i++) {
      const v = 0.5 + 3 * random(), motion = trapezoid({ v, a: 2, brakeAt: 2 + 5 * random(), brake: 1 + 10 * random() });
      const samples = [...changes(motion, random, { interval: 0.02, until: motion.end * (0.5 + random()), quantum: 1e-5 })];

      const whole = judged(samples, value => value), found = judged(samples, modulo);

      found.forEach((required, k) => assert.ok(required === whole[k] || Math.abs(required - whole[k]) < 1e-6 * whole[k], `motion ${i} of seed ${SEED}: ${found}, ${whole}`));
    }
  });

  it('Verdict_LinearJoint_TakesEachStepAsAMotion', () => {
    const judge = endOfJoint(true);
    for (let i = 0; i < 10; i++) judge.add(BigInt(i + 1) * S / 10n, i < 2 ? 0.01 * i : 3.5 * i);

    assert.ok(judge.verdict(0.1).required > 100);
  });
});

// Tests in virtual time which first value of a new connection ends the fault of a joint whose data have ended.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { MS, T, moveAndStop, plant } from './outputInVirtualTime.mjs';

/** Control time of the last sample of joint a in `moveAndStop`. */
const LAST = T + 490n * MS;

/** A joint whose data ended during its motion, and one at rest whose data have not changed for too long. */
const ENDS = {
  InMotion: joint => ended({ ...joint }, 1),
  InMotionWithMaxDeceleration: joint => ended({ ...joint, maxDeceleration: 20 }, 1),
  Silent: joint => ended({ ...joint, maxDeceleration: 200, faultAfterMs: 2000 }, 2.6),
};

function ended(joint, seconds) {
  const cell = plant([joint, { joint: 'b' }]);
  moveAndStop(cell, seconds);
  assert.equal(cell.stateOf('a'), 'fault');
  return cell;
}

/** Connects again after a time, receives the first value of joint a, and continues for 1 s. Returns the number of samples of joint a. */
function reconnected(cell, afterMs, { value = 0.44, stamp = LAST } = {}) {
  const before = cell.sent.length;
  cell.time.ms += afterMs;
  cell.output.restart();
  cell.output.publish([{ index: 0, value, stamp, isFirst: true }]);
  moveAndStop(cell, cell.time.ms / 1000 + 1);
  return cell.sent.slice(before).filter(({ name }) => name.includes('a')).length;
}

describe('a joint whose data have ended', () => {
  for (const [end, make] of Object.entries(ENDS)) {
    // A stamp of more than 10 s ago is refused as too old, and a later one because it is not newer.
    for (const [time, afterMs] of [['Soon', 10], ['20SecondsLater', 20_000]])
      it(`FirstValue_${end}Reconnected${time}WithTheLastStamp_JointIsInFaultUntilANewerSample`, () => {
        const cell = make({ joint: 'a' }), [, since, ...reason] = cell.status.values()['joint/a'].split(' ');

        const sent = reconnected(cell, afterMs);

        assert.deepEqual(cell.status.values()['joint/a'].split(' '), ['fault', since, ...reason]);
        assert.deepEqual([sent, cell.stateOf('b'), cell.status.level], [0, 'live', 2]);
        cell.value(0, 0.9);
        assert.equal(cell.stateOf('a'), 'live');
      });

    it(`FirstValue_${end}ReconnectedWithALaterStamp_JointIsAtRest`, () => {
      const cell = make({ joint: 'a' });

      const sent = reconnected(cell, 20_000, { value: 0.9, stamp: T + 4000n * MS });

      assert.deepEqual([cell.stateOf('a'), cell.output.hasEnded(0)], ['rest', false]);
      assert.ok(sent > 0);
    });

    it(`FirstValue_${end}ReconnectedAfterTheClockOfTheSourceWasSetBack_JointIsAtRest`, () => {
      const cell = make({ joint: 'a' });

      cell.time.setBackMs = 3_600_000;
      const sent = reconnected(cell, 20_000, { stamp: T - 3_599_000n * MS });

      assert.deepEqual([cell.stateOf('a'), cell.output.hasEnded(0)], ['rest', false]);
      assert.ok(sent > 0);
    });

    for (const [value, expected] of [[0.44, 'fault'], [0.9, 'rest']])
      it(`FirstValue_${end}Reconnected${expected === 'fault' ? 'AtTheSame' : 'AtAnother'}PositionWithoutStamp_JointIsIn${expected === 'fault' ? 'Fault' : 'Rest'}`, () => {
        const cell = make({ joint: 'a' });

        reconnected(cell, 20_000, { value, stamp: null });

        assert.equal(cell.stateOf('a'), expected);
      });
  }

  for (const [end, interruption, interrupt, stamp] of [
    ['InMotion', 'AfterABadOne', output => output.refuse(0, { reason: 'BadSensorFailure', text: 'the sensor failed' }), LAST],
    ['Silent', 'AfterABadOne', output => output.refuse(0, { reason: 'BadSensorFailure', text: 'the sensor failed' }), LAST],
    ['InMotion', 'OfAReturnedVariable', output => output.lose(0, { reason: 'node-gone', text: 'the node is missing' }), null],
  ])
    it(`FirstValue_${end}${interruption}_ReasonIsTheEndOfTheDataAgain`, () => {
      const cell = ENDS[end]({ joint: 'a' }), reports = () => cell.status.joints.reports(200)[0], before = reports();
      interrupt(cell.output);
      assert.notDeepEqual(reports(), before);

      cell.time.ms += 20_000;
      cell.output.publish([{ index: 0, value: 0.44, stamp, isFirst: true }]);

      assert.deepEqual(reports(), before);
      cell.output.explain(0, { reason: 'retained', text: 'of unknown age' });
      assert.deepEqual(reports(), before);
    });

  it('FirstValue_SilentJointLostAndReturned_JointIsAtRest', () => {
    const cell = ENDS.Silent({ joint: 'a' });
    cell.output.lose(0, { reason: 'node-gone', text: 'the node is missing' });

    reconnected(cell, 20_000);

    assert.equal(cell.stateOf('a'), 'rest');
  });

  it('HasEnded_SilentJoint_IsFalse', () => {
    // Otherwise, each new subscription of a node would end the fault, and the next silence would begin it again.
    assert.equal(ENDS.Silent({ joint: 'a' }).output.hasEnded(0), false);
  });
});

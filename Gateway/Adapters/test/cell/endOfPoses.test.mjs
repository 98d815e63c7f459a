// Tests in virtual time that the pose of an object is not repeated after its data have ended.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell, MS, T } from './inVirtualTime.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { silenceMessages, stateMessages } = messages;

const read = value => ({ value }), constant = number => ({ constant: number });
/** An object whose x coordinate (m) and angle about z (rad) are read. */
const part = {
  frame: 'part', parents: ['belt'], selector: null, position: [read(0), constant(0), constant(0)], scale: 1, faultAfterMs: null, maxDeceleration: null,
  rotation: { kind: 'angles', parts: [constant(0), constant(0), read(1)], order: 'xyz', isFixed: true, scale: 1 },
};

const SAMPLING_MS = 50;

/**
 * Simulates an object, and a source that sends changes every 50 ms and confirms unchanged values.
 * @param place Gets x and the angle at a time in ms; null after the program that writes them has ended, whose last values then remain.
 * @param options Settings of the frame, and `observe`, which is called every 10 ms.
 */
function moving(place, untilMs, { observe = () => {}, ...settings } = {}) {
  const one = cell({ frames: [{ ...part, ...settings }], values: ['part x', 'part angle z'] }), { output, take, time, clock } = one;
  output.samplingS = SAMPLING_MS / 1000;
  let last = [];
  for (; time.ms <= untilMs; time.ms += 10) {
    if (time.ms % SAMPLING_MS === 0) {
      const now = place(time.ms) ?? last, changed = now.flatMap((value, index) => (value === last[index] ? [] : [[index, value]]));
      if (changed.length > 0) take(Object.fromEntries(changed));
      last = now;
    }
    if (time.ms % 60 === 0) output.hold(clock.now - 100n * MS, 150n * MS, new Set());
    if (time.ms % 250 === 0) output.check();
    observe(one, time.ms);
  }
  return one;
}

const last = ({ poses }) => poses().at(-1).ms;
/** A belt that moves an object at 0.3 m/s until the program that writes its position ends at 1 s. */
const interrupted = ms => (ms > 1000 ? null : [0.0003 * ms, 0]);
/** A belt that stops an object with 0.6 m/s² between 0.5 and 1 s. */
const stopped = ms => {
  const s = Math.min(ms, 1000) / 1000;
  return [0.3 * s - (s > 0.5 ? 0.3 * (s - 0.5) ** 2 : 0), 0];
};

describe('the end of the data of objects', () => {
  it('Frame_InFaultAfterSilence_IsNotRepeatedUntilItChanges', () => {
    const place = ms => (ms < 5000 ? stopped(ms) : [0.225 + 0.0003 * (ms - 5000), 0]), states = new Map();
    const one = moving(place, 6000, { faultAfterMs: 2000, observe: ({ stateOf }, ms) => states.set(ms, stateOf('frame/part')) });

    assert.deepEqual([states.get(2500), states.get(4000), states.get(5200)], ['rest', 'fault', 'live']);
    const times = one.poses().map(({ ms }) => ms), fault = [...states].find(([, state]) => state === 'fault')[0];
    assert.ok(fault >= 3000 && fault <= 3300, `${fault}`);
    assert.ok(times.some(ms => ms > fault - 250 && ms < fault), 'it is repeated before');
    assert.deepEqual(times.filter(ms => ms > fault && ms < 5000), []);
    assert.ok(times.filter(ms => ms > 5000).length > 10);
  });

  it('Frame_InFaultAfterSilence_IsNotRepeatedAfterANewConnectionWithTheSameValue', () => {
    const one = moving(stopped, 4000, { faultAfterMs: 2000 }), { output, take, poses, time, status } = one, before = poses().length;

    status.enter('waiting', 'the server ended the connection');
    time.ms = 20_000;
    output.restart();
    status.enter('connected');
    take({ 0: 0.225, 1: 0 }, { stamp: T + 1000n * MS, isFirst: true });
    output.hold(T + 19_900n * MS, 150n * MS, new Set());
    const repeated = poses().length;
    take({ 0: 0.5 }, { stamp: T + 20_000n * MS });

    assert.deepEqual([repeated - before, poses().length - before], [0, 1]);
  });

  it('Frame_InFaultAfterSilence_IsAtRestAfterANewConnectionWithAnEarlierClock', () => {
    const { output, take, poses, time, clock, stateOf } = moving(stopped, 4000, { faultAfterMs: 2000 }), before = poses().length;

    [time.ms, time.setBackMs] = [20_000, 3_600_000];
    output.restart();
    take({ 0: 0.225, 1: 0 }, { stamp: clock.now - 15_000n * MS, isFirst: true });
    time.ms += 100;
    output.hold(clock.now - 50n * MS, 150n * MS, new Set());

    assert.deepEqual([stateOf('frame/part'), poses().length - before], ['rest', 1]);
  });

  it('Frame_InFaultAfterSilence_HasNotEndedDuringAMotion', () => {
    // Otherwise, each new subscription of a node would end the fault, and the next silence would begin it again.
    const { output, stateOf } = moving(stopped, 4000, { faultAfterMs: 2000 });

    assert.deepEqual([stateOf('frame/part'), output.hasEnded(0)], ['fault', false]);
  });

  it('Frame_InFaultAfterSilence_IsAtRestAfterItsVariableWasMissingAndReturned', () => {
    const { output, take, poses, time, clock, stateOf } = moving(stopped, 4000, { faultAfterMs: 2000 }), before = poses().length;

    output.lose(0, { reason: 'not-readable', text: 'the symbol is missing' });
    take({ 0: 0.225 }, { stamp: null, isFirst: true });
    time.ms += 100;
    output.hold(clock.now - 50n * MS, 150n * MS, new Set());

    assert.deepEqual([stateOf('frame/part'), poses().length - before], ['rest', 1]);
  });

  it('Frame_AtRestSinceBeforeTheConnection_HasTheStateRest', () => {
    const { output, take, poses, time, stateOf } = cell({ frames: [part], values: ['part x', 'part angle z'] });
    time.ms = 3_600_000;
    take({ 0: 0.1, 1: 0 }, { stamp: T, isFirst: true });

    output.hold(T + 3_599_990n * MS, 30n * MS, new Set());

    assert.deepEqual([poses().length, stateOf('frame/part')], [1, 'rest']);
  });

  for (const [name, place, unit] of [['Moves', interrupted, 'm/s²'], ['Turns', ms => (ms > 1000 ? null : [0, 0.002 * ms]), 'rad/s²']])
    it(`Frame_${name}AsTheDataEnd_IsInFaultAndNotRepeatedIfItsDecelerationIsLimited`, () => {
      const limited = moving(place, 3000, { maxDeceleration: 1 }), unlimited = moving(place, 3000);

      assert.equal(last(limited), 1000);
      assert.match(limited.status.values()['frame/part'], like(`fault ${ANY} ${silenceMessages.endedBecause(silenceMessages.stopTooHard(ANY, ANY, unit, 'configured'))}`));
      assert.ok(limited.output.hasEnded(0));
      assert.ok(last(unlimited) > 2800, 'a stopper or a simulated belt stops an object at once');
      assert.deepEqual([unlimited.stateOf('frame/part'), unlimited.status.level], ['rest', 1]);
      assert.match(unlimited.status.frames.uncertainty[1], like(silenceMessages.unobservedStop(ANY, unit)));
    });

  it('Frame_StopNotObserved_IsANoticeUntilItMoves', () => {
    const notices = [], place = ms => (ms <= 1000 || ms > 4000 ? [0.0003 * ms, 0] : null);

    moving(place, 4500, { observe: ({ status }, ms) => notices.push([ms, status.values().notice]) });

    const [first] = notices.find(([, notice]) => notice !== undefined);
    assert.ok(first >= 2000 && first <= 2500, `${first}`);
    const warning = like(stateMessages.uncertainRest('part', silenceMessages.unobservedStop(ANY, 'm/s²')));
    assert.ok(notices.every(([ms, notice]) => (ms >= first && ms <= 4000 ? warning.test(notice) : ms > 4000 && ms < 4300 || notice === undefined)));
  });

  it('Frame_DataEndDuringTheMotion_IsLiveAgainWithItsNextPose', () => {
    const states = [];
    const place = ms => (ms > 1000 && ms < 2000 ? null : [0.0003 * ms, 0]);
    const one = moving(place, 2200, { maxDeceleration: 1, observe: ({ stateOf }) => states.push(stateOf('frame/part')) });

    assert.deepEqual(states.filter((state, i) => state !== states[i - 1]), ['live', 'fault', 'live']);
    assert.ok(last(one) >= 2150);
  });

  it('Frame_NotificationOfItsLastChangeLost_IsRepeatedWithTheValueThatIsReadAgain', () => {
    const { output, take, poses, time, clock, stateOf } = moving(stopped, 3000), before = poses().length;

    take({ 0: 0.4 }, { stamp: null, isFirst: true });
    for (; time.ms <= 4000; time.ms += 100) output.hold(clock.now - 50n * MS, 150n * MS, new Set());
    const { position } = poses().at(-1), atRest = stateOf('frame/part');
    take({ 1: 1 });

    assert.deepEqual([position[0], atRest], [0.4, 'rest']);
    assert.ok(poses().slice(before).every(pose => pose.position[0] === 0.4), JSON.stringify(poses().slice(before)));
  });

  // A value that is read again and differs is a later change, whose time is unknown. The same value is the end of the data.
  for (const [name, x, expected] of [['AnotherValue', 0.4, 'rest'], ['TheSameValue', 0.3, 'fault']])
    it(`Frame_DataEndDuringTheMotionAnd${name}IsReadAgain_HasTheState${expected === 'rest' ? 'Rest' : 'Fault'}`, () => {
      const { output, take, poses, time, clock, stateOf } = moving(interrupted, 3000, { maxDeceleration: 1 }), before = stateOf('frame/part');

      take({ 0: x }, { stamp: null, isFirst: true });
      time.ms += 100;
      output.hold(clock.now - 50n * MS, 150n * MS, new Set());

      assert.deepEqual([before, stateOf('frame/part')], ['fault', expected]);
      if (expected === 'rest') assert.equal(poses().at(-1).position[0], x);
    });

  it('Frame_StopsWithinItsDeceleration_IsAtRestAndRepeated', () => {
    const one = moving(stopped, 3000);

    assert.ok(last(one) > 2800, `${last(one)}`);
    assert.deepEqual([one.stateOf('frame/part'), one.status.level], ['rest', 0]);
  });

  it('Frame_StopsAtAStopperWithItsDecelerationConfigured_IsAtRestAndRepeated', () => {
    const one = moving(interrupted, 3000, { maxDeceleration: 20 });

    assert.ok(last(one) > 2800, `${last(one)}`);
    assert.equal(one.stateOf('frame/part'), 'rest');
  });

  it('Frame_StopsTwiceAtAStopper_IsUncertainOnlyTheFirstTime', () => {
    const uncertain = [], travel = ms => 0.0003 * (Math.min(ms, 1000) + Math.max(0, Math.min(ms, 4000) - 3000));
    moving(ms => [travel(ms), 0], 6000, { observe: ({ status }, ms) => status.frames.uncertainty !== null && uncertain.push(ms) });

    assert.ok(uncertain.length > 0 && uncertain.every(ms => ms > 1000 && ms < 3050), `${uncertain[0]} to ${uncertain.at(-1)} ms`);
  });

  it('Frame_MovedToAnotherPlaceAtItsLastChange_IsAtRest', () => {
    const one = moving(ms => [ms < 1000 ? 0.0003 * ms : -5, 0], 3000);

    assert.deepEqual([one.stateOf('frame/part'), one.poses().at(-1).position[0]], ['rest', -5]);
  });

  it('Frame_ParentChangesDuringTheMotion_IsAtRestInTheNewParent', () => {
    const frame = { ...part, parents: ['belt', 'tool0'], selector: read(2) }, { output, take, time, clock, stateOf, poses } = cell({ frames: [frame], values: ['x', 'angle', 'parent'] });
    output.samplingS = 0.05;
    for (; time.ms < 1000; time.ms += 50) take({ 0: 0.0003 * time.ms, 1: 0, 2: 0 });
    take({ 0: 0, 1: 0, 2: 1 });

    for (; time.ms < 3000; time.ms += 50) output.hold(clock.now - 50n * MS, 150n * MS, new Set());

    assert.deepEqual([stateOf('frame/part'), poses().at(-1).parent], ['rest', 'tool0']);
  });

  it('Frame_SlowAsItsSourceStopsWriting_IsInFault', () => {
    // A stop from 0.1 m/s within one sampling interval needs 2 m/s², which is below the assumed limit.
    const slow = ms => (ms > 1000 ? null : [0.0001 * ms, 0]), stop = { after: 'after-change', atRest: 'at-rest' };
    const uncertain = moving(slow, 3000);
    const abandoned = moving(slow, 3000, { observe: ({ output }) => { output.sourceStopOf = index => (index === 0 ? stop.after : stop.atRest); } });
    const unwritten = moving(stopped, 3000, { observe: ({ output }, ms) => { output.sourceStopOf = () => (ms > 2000 ? stop.atRest : null); } });

    assert.deepEqual([uncertain.stateOf('frame/part'), uncertain.status.level], ['rest', 1]);
    assert.match(uncertain.status.frames.uncertainty[1], like(silenceMessages.unobservedStop(ANY, 'm/s²')));
    assert.deepEqual([abandoned.stateOf('frame/part'), abandoned.status.level], ['fault', 2]);
    assert.equal(unwritten.status.frames.uncertainty[1], silenceMessages.notWritten);
  });

  it('Frame_SourceCannotConfirmAndDataEndDuringTheMotion_IsInFault', () => {
    const { output, take, time, status, stateOf } = cell({ frames: [{ ...part, maxDeceleration: 1 }], values: ['part x', 'part angle z'] });
    output.unconfirmedMs = null;
    for (; time.ms < 3000; time.ms += 50) {
      if (time.ms <= 1000) take({ 0: 0.0003 * time.ms, 1: 0 });
      output.check();
    }

    assert.equal(stateOf('frame/part'), 'fault');
    assert.match(status.values()['frame/part'], like(silenceMessages.endedBecause(silenceMessages.stopTooHard(ANY, ANY, 'm/s²', 'configured'))));
  });
});

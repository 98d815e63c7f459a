// Tests in virtual time how missing samples are interpreted and reported in the diagnostics.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { MS, T, moveAndStop, plant } from './outputInVirtualTime.mjs';
import { parts } from './parts.mjs';
import { ANY, like, messages } from './messages.mjs';

const { refusalMessages, silenceMessages, stateMessages } = messages;

const { AdapterStatus, Log, diagnostics } = await parts('gateway/status', 'log', 'gateway/messages');

describe('silence', () => {
  it('Motion_Interrupted_JointIsInFaultAndNotRepeated', () => {
    const cell = plant();

    moveAndStop(cell, 1);

    assert.equal(cell.stateOf('a'), 'fault');
    assert.ok(cell.faultMs > 490 && cell.faultMs <= 600, `the last sample is of 490 ms, the fault of ${cell.faultMs} ms`);
    assert.ok(cell.sent.filter(({ name }) => name.includes('a')).every(({ header: { stamp } }) => stamp.sec === 1_700_000_000 && stamp.nanosec < 0.5e9));
    assert.equal(cell.stateOf('b'), 'live');
    assert.match(cell.status.message, like(`a fault: ${silenceMessages.endedBecause(silenceMessages.stopTooHard(ANY, ANY, 'rad/s²', 'assumed'))}`));
    assert.equal(cell.status.level, 2);
    assert.equal(cell.lines.filter(line => line.includes('a fault')).length, 1);
  });

  for (const [maxDeceleration, limit, basis] of [[undefined, 12, 'assumed'], [20, 20, 'configured']]) {
    it(`Motion_InterruptedWith${maxDeceleration === undefined ? 'out' : ''}MaxDeceleration_ReasonContainsTheLimitAndItsSource`, () => {
      const cell = plant([{ joint: 'a', maxDeceleration }, { joint: 'b' }]);

      moveAndStop(cell, 1);

      assert.match(cell.status.values()['joint/a'], like(silenceMessages.stopTooHard(ANY, limit, 'rad/s²', basis)));
    });
  }

  it('Motion_SampledRarely_IsNeitherRepeatedNorEndedBetweenSamples', () => {
    const cell = plant([{ joint: 'a' }]);
    const samples = [];

    for (; cell.time.ms < 4000; cell.time.ms += 10) {
      if (cell.time.ms % 200 === 0) samples.push(cell.value(0, 3 * Math.sin(cell.time.ms / 500)));
      cell.output.hold(cell.clock.now - 10n * MS, 30n * MS);
      // No interval is known before the first sample, so the comparison starts later.
      if (cell.time.ms === 390) cell.sent.length = samples.length = 0;
    }

    assert.equal(cell.stateOf('a'), 'live');
    assert.equal(cell.sent.length, samples.length);
  });

  it('Motion_InterruptedThenContinued_JointIsLiveImmediately', () => {
    const cell = plant();
    moveAndStop(cell, 1);

    cell.value(0, 0.9);

    assert.deepEqual([cell.stateOf('a'), cell.status.level], ['live', 0]);
    assert.ok(cell.lines.some(line => line.includes(stateMessages.liveAgain('a'))));
  });

  it('Motion_InterruptedWithinTheConfiguredDeceleration_JointIsAtRest', () => {
    const cell = plant([{ joint: 'a', maxDeceleration: 200 }, { joint: 'b' }]);

    moveAndStop(cell, 2);

    const [state, since] = cell.status.values()['joint/a'].split(' ');
    assert.equal(state, 'rest');
    const { basis, confirmed } = silenceMessages;
    assert.ok(cell.status.values()['joint/a'].endsWith(stateMessages.assumedAtRest(basis(confirmed, null), 'joint', '')), cell.status.values()['joint/a']);
    // The state of rest began with the last sample, which arrived 1 s earlier.
    assert.ok(Number(since) < Date.now() / 1000 - 0.9, since);
    assert.equal(cell.status.level, 0);
  });

  /**
  * Moves two joints back and forth at up to 0.6 rad/s and reads them every 50 ms. At a moment of their highest speed, the joints in
  * `stopped` stop sending.
  */
  function swing(stopped, { amplitude = 0.3, prepare = () => {} } = {}) {
    const cell = plant(), cut = 1000 * Math.PI * 3;
    prepare(cell);
    for (; cell.time.ms < cut + 2000; cell.time.ms += 50) {
      const s = cell.time.ms / 1000;
      for (const joint of [0, 1]) if (cell.time.ms < cut || !stopped.includes(joint)) cell.value(joint, amplitude * Math.sin(2 * s));
      cell.output.hold(cell.clock.now - 50n * MS, 30n * MS);
    }
    return cell;
  }

  it('Motion_InterruptedAtLowSpeedWhileAnotherJointMoves_JointIsInFault', () => {
    const cell = swing([0]);

    assert.deepEqual([cell.stateOf('a'), cell.stateOf('b')], ['fault', 'live']);
    // The documentation promises that a headset shows the fault within two seconds.
    assert.ok(cell.faultMs - 1000 * Math.PI * 3 <= 700, `${cell.faultMs} ms`);
    // The limit is 1.5 times the largest deceleration of the motion (1.2 rad/s²), or four times the increase of the deceleration in the last samples.
    assert.match(cell.status.values()['joint/a'], like(silenceMessages.stopTooHard(ANY, ANY, 'rad/s²', 'observed')));
    assert.match(cell.status.values()['joint/a'], / 1\d\.\d rad\/s².* 1\.\d rad\/s²/);
  });

  it('Motion_InterruptedAtLowSpeedBeforeAnyDeceleration_RestIsUncertainEvenWhileAnotherJointMoves', () => {
    const cell = plant();
    for (; cell.time.ms < 3000; cell.time.ms += 50) {
      // From 0.5 s on, the speed is 0.4 rad/s. A stop within 50 ms needs a deceleration of up to 8 rad/s².
      const s = cell.time.ms / 1000, position = s < 0.5 ? 0.4 * s * s : 0.4 * (s - 0.25);
      if (s < 1) cell.value(0, position);
      cell.value(1, position);
      cell.output.hold(cell.clock.now - 50n * MS, 30n * MS);
    }

    assert.deepEqual([cell.stateOf('a'), cell.stateOf('b')], ['rest', 'live']);
    assert.match(cell.status.values()['joint/a'], like(silenceMessages.unobservedStop(ANY, 'rad/s²')));
  });

  it('Motion_OfAllJointsInterruptedAtLowSpeed_RestIsUncertain', () => {
    const cell = swing([0, 1]);

    assert.deepEqual([cell.stateOf('a'), cell.stateOf('b'), cell.status.level], ['rest', 'rest', 1]);
    const reason = cell.status.values()['uncertain/a'];
    assert.match(reason, like(silenceMessages.unobservedStop(ANY, 'rad/s²')));
    assert.match(reason, / 1\d\.\d rad\/s²$/);
    assert.equal(cell.status.message, stateMessages.uncertainRest('a', reason));
    assert.ok(cell.status.values()['joint/a'].endsWith(stateMessages.assumedAtRest(silenceMessages.basis(silenceMessages.confirmed, null), 'joint', reason)), cell.status.values()['joint/a']);
  });

  it('Motion_OfAllJointsInterruptedAtLowSpeedAndOneNoLongerWritten_OnlyThatJointIsInFault', () => {
    const prepare = cell => { cell.output.sourceStopOf = joint => joint === 0 && cell.time.ms > 1000 * Math.PI * 3 + 700 ? 'after-change' : null; };
    const cell = swing([0, 1], { prepare });

    assert.deepEqual([cell.stateOf('a'), cell.stateOf('b')], ['fault', 'rest']);
    const { endedBecause, notWritten, unobservedStop } = silenceMessages;
    assert.match(cell.status.values()['joint/a'], like(endedBecause(`${unobservedStop(ANY, 'rad/s²')}, and ${notWritten}`)));
    const repeated = cell.sent.filter(({ name }) => name.includes('a')).length;
    cell.output.hold(cell.clock.now, 30n * MS);
    assert.equal(cell.sent.filter(({ name }) => name.includes('a')).length, repeated, 'it is not repeated');
  });

  it('Rest_SourceStopsWritingAfterTheStop_IsUncertain', () => {
    const cell = plant([{ joint: 'a', maxDeceleration: 200 }, { joint: 'b', maxDeceleration: 200 }]);
    let stop = null;
    cell.output.sourceStopOf = joint => joint === 0 ? stop : null;
    moveAndStop(cell, 2);
    assert.deepEqual([cell.stateOf('a'), cell.status.level], ['rest', 0]);

    let seconds = 2;
    for (stop of ['after-change', 'at-rest']) {
      moveAndStop(cell, ++seconds);
      assert.deepEqual([cell.stateOf('a'), cell.stateOf('b'), cell.status.level], ['rest', 'live', 1]);
      assert.equal(cell.status.values()['uncertain/a'], silenceMessages.notWritten);
    }
  });

  it('Silence_LongerThanConfigured_JointIsInFault', () => {
    const cell = plant([{ joint: 'a', maxDeceleration: 200, faultAfterMs: 2000 }, { joint: 'b' }]);

    moveAndStop(cell, 2.4);
    const before = cell.stateOf('a');
    moveAndStop(cell, 2.6);

    assert.deepEqual([before, cell.stateOf('a')], ['rest', 'fault']);
    const count = cell.sent.filter(({ name }) => name.includes('a')).length;
    moveAndStop(cell, 3);
    assert.equal(cell.sent.filter(({ name }) => name.includes('a')).length, count);
  });

  it('Silence_NotConfirmedBySource_JointIsInFault', () => {
    const cell = plant([{ joint: 'a', maxDeceleration: 200 }, { joint: 'b' }]);

    moveAndStop(cell, 1.9, false);
    const before = cell.stateOf('a');
    moveAndStop(cell, 2.1, false);

    assert.deepEqual([before, cell.stateOf('a')], ['live', 'fault']);
    cell.output.hold(cell.clock.now - 10n * MS, 30n * MS);
    assert.equal(cell.stateOf('a'), 'rest', 'after another confirmation');
  });

  it('Joint_NeverReceived_IsMissingWithAReason', () => {
    const cell = plant();

    cell.value(0, NaN);
    cell.output.lose(1, { reason: 'node-gone', text: 'plant.yaml, line 3: no such node' });

    assert.match(cell.status.values()['joint/a'], like(`missing ${ANY} ${refusalMessages.notPosition('NaN')}`));
    assert.match(cell.status.values()['joint/b'], /^missing \d+\.\d{3} plant\.yaml, line 3: no such node$/);
    assert.equal(cell.status.level, 2);
  });

  it('Joint_ValueInvalidThenValid_IsRefusedThenLive', () => {
    const cell = plant();
    cell.value(0, 1);
    cell.value(1, 1);

    cell.time.ms = 10;
    cell.value(0, NaN);
    const refused = cell.status.values()['joint/a'];
    cell.time.ms = 20;
    cell.value(0, 1);

    assert.match(refused, /^refused \d+\.\d{3} value NaN/);
    assert.deepEqual([cell.stateOf('a'), cell.status.level], ['live', 0]);
  });

  it('Joint_ValidThenInvalidValueInOneBatch_IsRefused', () => {
    const cell = plant();

    cell.output.publish([{ index: 0, value: 1, stamp: T - MS }, { index: 0, value: null, stamp: null, refusal: { reason: 'node-gone', text: 'gone' }, isLost: true }]);

    assert.equal(cell.stateOf('a'), 'fault');
  });

  it('Level_FromTheStartToALostConnection_Is1Then2Then0Then2', () => {
    const status = new AdapterStatus('opcua', new Log('plant/test', [], () => {}));
    status.joints.expect('a');
    const levels = [status.level];

    status.enter('waiting', 'no server answers');
    status.enter('connecting');
    levels.push(status.level);
    status.enter('connected');
    status.joints.live('a');
    levels.push(status.level);
    status.enter('waiting', 'the connection was lost');

    assert.deepEqual([...levels, status.level], [1, 2, 0, 2]);
    assert.match(status.values()['joint/a'], /^fault \d+\.\d{3} the connection was lost$/);
    assert.equal(status.message, 'waiting: the connection was lost');
    assert.deepEqual(diagnostics('plant/p', status.level, status.message, { k: 'v' }).status,
      [{ level: 2, name: 'plant/p', message: 'waiting: the connection was lost', hardware_id: 'plant/p', values: [{ key: 'k', value: 'v' }] }]);
  });

  it('Level_GatewayDropsMessages_IsTwoForFiveSeconds', () => {
    const reports = [], status = new AdapterStatus('opcua', new Log('plant/test', [], () => {}), () => reports.push(status.level));
    status.joints.expect('a');
    status.enter('connected');
    status.joints.live('a');
    const live = status.level;
    reports.length = 0;

    status.refusedByGateway('joint a belongs to another source');
    status.refusedByGateway('joint a belongs to another source');

    assert.deepEqual([live, status.level, status.message], [0, 2, stateMessages.droppedByGateway('joint a belongs to another source')]);
    assert.deepEqual(reports, [2], 'the first refusal is reported at once');
    status.refusedByGateway('joint a belongs to another source', performance.now() - 5001);
    assert.deepEqual([status.level, status.message], [0, 'connected']);
  });

  it('Joint_RefusedThenDisconnected_IsFaultWithTheReasonOfTheConnection', () => {
    const { status, value } = plant();
    value(0, 1);
    value(0, NaN);
    const before = status.joints.stateOf('a');

    status.enter('waiting', 'the connection was lost');

    assert.deepEqual([before, status.joints.stateOf('a'), status.joints.reasonOf('a')], ['refused', 'fault', 'the connection was lost']);
  });

  it('Diagnostics_ManyJoints_JointsInFaultComeFirst', () => {
    const { status, value, time } = plant([{ joint: 'a' }, { joint: 'b' }, { joint: 'c' }]);
    time.ms = 10;
    value(2, 1);
    time.ms = 20;
    value(0, 1);

    const keys = Object.keys(status.values()).filter(key => key.startsWith('joint/'));

    assert.deepEqual(keys, ['joint/b', 'joint/a', 'joint/c']);
  });
});

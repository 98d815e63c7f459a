// Tests in virtual time how missing samples are interpreted if the source confirms no values.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { S, plant } from './outputInVirtualTime.mjs';
import { parts } from './parts.mjs';
import { messages } from './messages.mjs';

const { silenceMessages, stateMessages } = messages;

describe('a source that cannot confirm', () => {
  /**
  * Simulates a source that sends joint states and never confirms the last value. `position` contains for each joint a function from the
  * time in s to the position, or to null if the joint is not sent.
  */
  async function passive(position, seconds, faultAfterMs = null, observe = () => {}) {
    const { JointStates, JointNames } = await parts('ros/jointStates', 'ros/jointNames');
    const cell = plant([], { faultAfterMs }), { status, clock, time, output } = cell;
    const states = new JointStates(new JointNames([]), 10n * S, clock, { publish: () => {} }, status, output.silence);
    for (; time.ms < 1000 * seconds; time.ms += 50) {
      for (const [name, at] of Object.entries(position)) {
        const value = at(time.ms / 1000), stamp = clock.now;
        if (value !== null) states.pass({ header: { stamp: { sec: Number(stamp / S), nanosec: Number(stamp % S) } }, name: [name], position: [value] });
      }
      output.checkSilence();
      observe(cell);
    }
    return cell;
  }

  /** Does the same as `passive` with values of individual joints, as the MQTT adapter publishes them. */
  function topics(position, seconds, faultAfterMs = null, observe = () => {}) {
    const names = Object.keys(position), cell = plant(names.map(joint => ({ joint })), { faultAfterMs }), { time, output } = cell;
    output.silence.unconfirmedMs = null;
    output.samplingS = 0.1;
    for (; time.ms < 1000 * seconds; time.ms += 50) {
      names.forEach((name, i) => {
        const value = position[name](time.ms / 1000);
        if (value !== null) cell.value(i, value);
      });
      output.checkSilence();
      observe(cell);
    }
    return cell;
  }

  /** Positions of a joint that comes to rest at 1 s and is then not sent, and of a joint that swings. */
  const stops = s => (s > 1 ? null : 0.1 * Math.sin(s * Math.PI / 2)), swings = s => 0.1 * Math.sin(2 * s);

  it('SilentJoint_SourceCannotConfirm_RestIsUncertain', async () => {
    const { status, stateOf } = await passive({ x: stops, y: swings }, 3);

    assert.deepEqual([stateOf('x'), stateOf('y'), status.level], ['rest', 'live', 1]);
    const { basis, noValue, unconfirmed } = silenceMessages;
    assert.ok(status.values()['joint/x'].endsWith(stateMessages.assumedAtRest(basis(noValue, null), 'joint', unconfirmed)), status.values()['joint/x']);
    assert.equal(status.values()['uncertain/x'], unconfirmed);
    assert.equal(status.message, stateMessages.uncertainRest('x', unconfirmed));
  });

  it('AllJointsSilent_SourceCannotConfirm_ReasonStatesThatNothingArrives', async () => {
    const { status, stateOf } = await passive({ x: stops, y: stops }, 3);

    assert.deepEqual([stateOf('x'), stateOf('y'), status.level], ['rest', 'rest', 1]);
    for (const joint of ['x', 'y']) assert.equal(status.values()[`uncertain/${joint}`], silenceMessages.allUnconfirmed);
  });

  it('MotionAfterRest_SourceCannotConfirm_JointIsLiveAndCertain', async () => {
    const { status, stateOf } = await passive({ x: s => (s > 1 && s < 4 ? null : 0.1 * Math.sin(Math.min(s, 1) * Math.PI / 2)) }, 4.5);

    assert.deepEqual([stateOf('x'), status.level, status.values()['uncertain/x']], ['live', 0, undefined]);
  });

  it('InterruptedMotion_SourceCannotConfirm_JointIsInFault', async () => {
    const { status, stateOf } = await passive({ x: s => (s > 1 ? null : s * s), y: swings }, 3);

    assert.deepEqual([stateOf('x'), stateOf('y'), status.level], ['fault', 'live', 2]);
    assert.ok(status.values()['joint/x'].endsWith(silenceMessages.ended), status.values()['joint/x']);
  });

  for (const [source, run] of Object.entries({ JointStates: passive, Topics: topics }))
    for (const faultAfterMs of [null, 10_000]) {
      const silence = faultAfterMs === null ? 'Rest' : 'FaultAfter10s';

      it(`${source}InterruptedAt2RadPerSecond_Silence${silence}_JointIsInFaultBeforeTwoSeconds`, async () => {
        const { status, stateOf } = await run({ x: s => (s > 1 ? null : s * s), y: swings }, 2.1, faultAfterMs);

        assert.deepEqual([stateOf('x'), stateOf('y'), status.level], ['fault', 'live', 2]);
      });

      it(`${source}AtMostEveryTwoSeconds_Silence${silence}_JointIsInFaultOnlyIfTheNextSampleIsOverdue`, async () => {
        // The joint swings with a period of 40 s. Its samples become slower and end after 80.2 s, at its highest speed.
        const sent = new Set([[0, 0.25, 12], [3, 1.2, 16], [22.2, 2, 29]].flatMap(([from, interval, count]) =>
          Array.from({ length: count + 1 }, (_, i) => Math.round(1000 * (from + i * interval)))));
        const swing = s => (sent.has(Math.round(1000 * s)) ? Math.sin((s - 80.2) * Math.PI / 20) : null), states = [];
        const { stateOf } = await run({ x: swing, y: s => 0.05 * s }, 85, faultAfterMs, ({ time, stateOf: now }) => {
          if (time.ms < 84_000) states.push(now('x'));
        });

        assert.equal(states.indexOf('fault'), -1, `in fault after ${50 * states.indexOf('fault')} ms`);
        assert.equal(stateOf('x'), 'fault');
      });

      it(`${source}EveryTwoSeconds_Silence${silence}_JointIsNeverInFault`, async () => {
        const states = new Set(), swing = s => (s % 2 === 0 ? Math.sin(s * Math.PI / 20) : null);
        await run({ x: swing, y: s => 0.05 * s }, 80, faultAfterMs, ({ stateOf }) => states.add(stateOf('x')));

        assert.deepEqual([...states].sort(), ['live', 'rest']);
      });
    }

  it('StoppedJoint_AnotherJointMovesLater_IsAssumedAtRest', async () => {
    // After an earlier slow stop, both joints stop from 0.5 rad/s within one interval.
    const hard = s => (s < 2 ? 0.1 * Math.sin(s * Math.PI / 2) ** 2 : s < 3 ? 0.5 * (s - 2) : null);
    const { stateOf } = await passive({ x: hard, y: s => (s < 3 ? hard(s) : s < 10 ? null : 0.5 * (s - 10)) }, 14);

    assert.deepEqual([stateOf('x'), stateOf('y')], ['rest', 'live']);
  });

  it('SilentJoint_FaultAfterConfigured_RestIsCertainUntilTheFault', async () => {
    const { status, stateOf } = await passive({ x: stops, y: swings }, 4, 5000);

    assert.deepEqual([stateOf('x'), status.level, status.values()['uncertain/x']], ['rest', 0, undefined]);
    const { basis, noValue } = silenceMessages;
    assert.ok(status.values()['joint/x'].endsWith(stateMessages.assumedAtRest(basis(noValue, 5000), 'joint', '')), status.values()['joint/x']);
  });

  it('SilentJoint_SourceSendsPeriodically_JointIsInFault', () => {
    const { output, stateOf, time } = plant([], { faultAfterMs: 1000 });
    output.silence.unconfirmedMs = null;
    output.silence.heard('x');

    time.ms = 900;
    output.checkSilence();
    const before = stateOf('x');
    time.ms = 1100;
    output.checkSilence();

    assert.deepEqual([before, stateOf('x')], ['live', 'fault']);
  });

  it('Joints_MoreThan256_ReportsThatTheOthersAreNotForwarded', async () => {
    const joint = () => 0, { status } = await passive(Object.fromEntries(Array.from({ length: 257 }, (_, i) => [`a${i}`, joint])), 0.05);

    assert.deepEqual([status.level, status.values().notice, Number(status.values()['refused/too-many'])], [1, stateMessages.tooMany('joints', 256), 1]);
  });
});

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';
import { messages } from './messages.mjs';

const { refusalMessages, stateMessages } = messages;

const { grouped, StampRule, JointOutput, AdapterStatus, Log } =
  await parts('samples/grouping', 'samples/stampRule', 'samples/jointOutput', 'gateway/status', 'log');

const MS = 1_000_000n, S = 1000n * MS;
const T = 1_700_000_000n * S;

describe('grouping', () => {
  it('Samples_WithEqualTimeStamps_AreOneGroup', () => {
    const groups = grouped([{ index: 1, value: 2, stamp: T }, { index: 0, value: 1, stamp: T }], 0n);

    assert.deepEqual(groups.map(g => [g.stamp, g.samples.map(s => s.index)]), [[T, [0, 1]]]);
  });

  it('Samples_WithinTheTolerance_GetTheMiddleOfTheirTimeStamps', () => {
    const groups = grouped([0n, 300n, 500n, 501n].map((stamp, index) => ({ index, value: 0, stamp: T + stamp })), 500n);

    assert.deepEqual(groups.map(g => [g.stamp - T, g.samples.map(s => s.index)]), [[250n, [0, 1, 2]], [501n, [3]]]);
  });

  it('Samples_OfSeveralCyclesInAnyOrder_AreOrderedByTime', () => {
    const cycle = n => [0, 1].map(index => ({ index, value: n, stamp: T + BigInt(n) * 10n * MS }));

    const groups = grouped([...cycle(2), ...cycle(0), ...cycle(1)], MS);

    assert.deepEqual(groups.map(g => g.samples.map(s => s.value)), [[0, 0], [1, 1], [2, 2]]);
  });

  it('Samples_TwoOfOneJointWithinTheTolerance_AreTwoGroups', () => {
    const groups = grouped([{ index: 0, value: 1, stamp: T }, { index: 0, value: 2, stamp: T + 1n }], MS);

    assert.deepEqual(groups.map(g => g.samples.length), [1, 1]);
  });
});

describe('stamps', () => {
  for (const [name, stamp, now, reason] of [
    ['Missing', null, T, 'stamp-missing'],
    ['Zero', 0n, T, 'stamp-zero'],
    ['Before1970', -5n, T, 'stamp-zero'],
    ['FarFuture', T + S + 1n, T, 'stamp-future'],
    ['FarPast', T - 10n * S - 1n, T, 'stamp-old'],
    ['JustAllowedAhead', T + S, T, null],
    ['JustAllowedBehind', T - 10n * S, T, null],
    ['ClockUnknown', T, null, null],
  ]) {
    it(`TimeStamp_${name}_${reason === null ? 'IsAccepted' : 'IsRefused'}`, () => {
      const refusal = new StampRule(10n * S).judge(stamp, now);

      assert.equal(refusal?.reason ?? null, reason);
    });
  }

  it('TimeStamp_ZeroOrBefore1970_HasItsOwnText', () => {
    const rule = new StampRule(10n * S);

    assert.deepEqual([rule.judge(0n, T).text, rule.judge(-1n, T).text], [refusalMessages.zeroStamp, refusalMessages.before1970]);
  });

  it('TimeStamp_NotNewer_IsRefused', () => {
    const rule = new StampRule(10n * S);
    rule.judge(T, T);

    assert.equal(rule.judge(T, T).reason, 'stamp-not-newer');
    assert.equal(rule.judge(T - 1n, T).reason, 'stamp-not-newer');
    assert.equal(rule.judge(T + 1n, T), null);
  });

  it('TimeStamp_OfAnyAgeInAWrongUnit_HasTheTextAboutTheUnit', () => {
    const rule = new StampRule(1n << 80n);
    rule.judge(T, T);

    const { reason, text } = rule.judge(T / 1000n, T);

    assert.deepEqual([reason, text], ['stamp-not-newer', refusalMessages.farApart('1970-01-20')]);
    assert.equal(rule.judge(T - 5n * S, T).text, refusalMessages.notNewer(5000));
  });

  it('TimeStamp_AfterOneInAWrongUnitWithoutControlTime_IsNotCalledWrong', () => {
    const rule = new StampRule(10n * S);
    rule.judge(1000n * T, null);

    assert.equal(rule.judge(T, null).text, refusalMessages.notNewer(Number(999n * T) / 1e6));
  });

  it('TimeStamp_AfterTheClockWasSetBack_IsAccepted', () => {
    const rule = new StampRule(10n * S), before = T - 3600n * S;
    rule.judge(T, T);

    assert.equal(rule.judge(before, before), null);
    assert.equal(rule.judge(before, before).reason, 'stamp-not-newer');
  });
});

describe('joint output', () => {
  function output(joints) {
    const lines = [], sent = [];
    const status = new AdapterStatus('opcua', new Log('plant/test', [], line => lines.push(line)));
    const clock = { now: T, isSettled: true };
    const out = new JointOutput(joints, { tolerance: MS, oldest: 10n * S }, clock, { publish: (topic, msg) => sent.push({ topic, msg }) }, status);
    return { out, sent, status, lines, clock };
  }

  const joint = (name, scale = 1, offset = 0) => ({ joint: name, robot: '', name, scale, offset });

  it('Value_WithScaleAndOffset_KeepsItsTimeStampToTheNanosecond', () => {
    const { out, sent } = output([joint('a', 2, 0.5), joint('b', -1)]);

    out.publish([{ index: 0, value: 3, stamp: T + 100n }, { index: 1, value: 7n, stamp: T + 100n }]);

    assert.deepEqual(sent, [{
      topic: '/joint_states',
      msg: { header: { stamp: { sec: 1_700_000_000, nanosec: 100 }, frame_id: '' }, name: ['a', 'b'], position: [6.5, -7], velocity: [], effort: [] },
    }]);
  });

  for (const [name, value, reason] of [
    ['Text', 'far', 'type'], ['Null', null, 'type'], ['Boolean', true, 'type'], ['Array', [1], 'type'],
    ['NaN', NaN, 'not-finite'], ['Infinity', Infinity, 'not-finite'], ['TooLargeForScale', 1e308, 'not-finite'],
  ]) {
    it(`Value_${name}_IsRefusedAndCounted`, () => {
      const { out, sent, status } = output([joint('a', 100)]);

      out.publish([{ index: 0, value, stamp: T }]);

      assert.equal(sent.length, 0);
      assert.equal(status.values()[`refused/${reason}`], '1');
    });
  }

  it('Refusals_WithTheSameReason_AreLoggedOnceUntilAValidValue', () => {
    const { out, lines, clock } = output([joint('a')]);

    for (let i = 1n; i < 6n; i++) out.publish([{ index: 0, value: NaN, stamp: T + i }]);
    out.publish([{ index: 0, value: 1, stamp: T + 10n }]);
    out.publish([{ index: 0, value: 1, stamp: T + 11n }]);
    clock.now = T + 20n * S;
    for (let i = 20n; i < 26n; i++) out.publish([{ index: 0, value: 1, stamp: T + i }]);

    assert.deepEqual(
      lines.map(line => /not-finite|stamp-old/.exec(line)?.[0] ?? line), ['not-finite', `[plant/test] ${stateMessages.validAgain('a')}\n`, 'stamp-old']);
  });

  it('Values_ReceivedBeforeTheClockIsOffered_AreCountedAndNotPublished', () => {
    const { out, sent, status, lines, clock } = output([joint('a')]);

    clock.isSettled = false;
    out.publish([{ index: 0, value: 1, stamp: T }]);
    clock.isSettled = true;
    out.publish([{ index: 0, value: 2, stamp: T + 1n }]);

    assert.deepEqual(sent.map(s => s.msg.position), [[2]]);
    assert.equal(status.values()['refused/clock-unknown'], '1');
    assert.deepEqual(lines, []);
  });

  describe('of a plant that sends only changes', () => {
    const HOUR = 3600n * S;
    const passed = sent => sent.map(({ msg: { header: { stamp }, name, position } }) =>
      [BigInt(stamp.sec) * S + BigInt(stamp.nanosec) - T, name.join(), position.join()]);

    it('Joint_AtRest_IsRepeatedUpToTheConfirmedTime', () => {
      const { out, sent, clock } = output([joint('a'), joint('b')]);
      clock.now = T + S;
      out.publish([{ index: 0, value: 1, stamp: T }, { index: 1, value: 2, stamp: T }]);

      for (let i = 1n; i <= 20n; i++) {
        out.publish([{ index: 0, value: 1, stamp: T + i * 10n * MS }]);
        out.hold(T + i * 10n * MS, 0n, new Set([0]));
      }

      assert.deepEqual(passed(sent).filter(([, name]) => name === 'b'), [60n, 110n, 160n].map(ms => [ms * MS, 'b', '2']));
      out.publish([{ index: 1, value: 3, stamp: T + 205n * MS }]);
      assert.deepEqual(passed(sent).at(-1), [205n * MS, 'b', '3']);
    });

    it('FirstValue_WithOldTimeStamp_IsPublishedOnceConfirmedAtRest', () => {
      const { out, sent, status, clock } = output([joint('a')]);
      out.publish([{ index: 0, value: 7, stamp: T - HOUR, isFirst: true }]);
      out.hold(T + 50n * MS, 0n);
      const soon = sent.length;

      clock.now = T + S;
      out.hold(T + 500n * MS, 0n);

      assert.deepEqual([soon, passed(sent)], [0, [[500n * MS, 'a', '7']]]);
      assert.equal(status.values().refused, '0');
    });

    it('Value_StampedByAnotherClock_IsNeverAssumedAtRest', () => {
      const { out, sent, status, clock } = output([joint('a')]);
      for (let i = 0n; i < 5n; i++) {
        clock.now = T + i * 10n * MS;
        out.publish([{ index: 0, value: Number(i), stamp: clock.now - HOUR, isFirst: i === 0n }]);
      }

      clock.now = T + 10n * S;
      out.hold(T + 9n * S, 0n);

      assert.deepEqual([sent.length, status.values()['refused/stamp-old']], [0, '4']);
    });

    it('Joint_Refused_IsNotRepeated', () => {
      const { out, sent, clock } = output([joint('a'), joint('b')]);
      out.publish([{ index: 0, value: 1, stamp: T }, { index: 1, value: 1, stamp: T }, { index: 0, value: NaN, stamp: T + 1n }]);
      clock.now = T + S;

      out.hold(T + 500n * MS, 0n);
      out.restart();
      out.hold(T + 900n * MS, 0n);

      assert.deepEqual(passed(sent).slice(1), [[500n * MS, 'b', '1']]);
    });
  });

  it('Joint_Refused_DoesNotDelayOthers', () => {
    const { out, sent } = output([joint('a'), joint('b')]);

    out.publish([{ index: 0, value: NaN, stamp: T }, { index: 1, value: 1, stamp: T }]);

    assert.deepEqual(sent.map(s => s.msg.name), [['b']]);
  });
});

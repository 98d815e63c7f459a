// Tests the word for the reason why a joint has no current data.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { moveAndStop, plant, T } from './outputInVirtualTime.mjs';
import { parts } from './parts.mjs';
import { messages } from './messages.mjs';

const { AdapterStatus, Log, diagnostics } = await parts('gateway/status', 'log', 'gateway/messages');

describe('word for the reason of a joint', () => {
  const wordOf = ({ status }) => status.values()['reason/a'];

  for (const [name, word, act, options] of [
    ['NeverReceived', 'never-received', () => {}],
    ['NeverReceivedValid', 'not-finite', cell => cell.value(0, NaN)],
    ['TypeWrong', 'type', cell => cell.value(0, 'text')],
    ['StampRepeated', 'stamp-not-newer', cell => [1, 2].forEach(position => cell.value(0, position))],
    ['Lost', 'node-gone', cell => cell.output.lose(0, { reason: 'node-gone', text: 'gone' })],
    ['Explained', 'retained', cell => cell.output.explain(0, { reason: 'retained', text: 'it may be old' })],
    ['EndedInMotion', 'ended-in-motion', cell => moveAndStop(cell, 1)],
    ['NotConfirmed', 'not-confirmed', cell => moveAndStop(cell, 3, false), { maxDeceleration: 200 }],
    ['SilentTooLong', 'silent-too-long', cell => moveAndStop(cell, 3), { maxDeceleration: 200, faultAfterMs: 2000 }],
    ['Disconnected', 'not-connected', cell => {
      cell.value(0, 1);
      cell.status.enter('waiting', 'the connection was lost');
    }],
  ]) {
    it(`Joint_${name}_IsNamedInTheDiagnostics`, () => {
      const cell = plant([{ joint: 'a', ...options }, { joint: 'b' }]);

      act(cell);

      assert.equal(wordOf(cell), word);
    });
  }

  it('Joint_LiveOrAtRest_HasNoWord', () => {
    const cell = plant([{ joint: 'a', maxDeceleration: 200 }, { joint: 'b', maxDeceleration: 200 }]);

    cell.value(0, NaN);
    cell.time.ms = 10;
    cell.value(0, 1);
    const live = [cell.stateOf('a'), wordOf(cell)];
    moveAndStop(cell, 2);

    assert.deepEqual([...live, cell.stateOf('a'), wordOf(cell)], ['live', undefined, 'rest', undefined]);
  });

  it('Joint_WithoutAValueSinceTheReconnection_DoesNotSeemDisconnected', () => {
    const cell = plant();
    [0, 1].forEach(joint => cell.value(joint, 1));
    cell.status.enter('waiting', 'the broker closed the connection');
    const since = cell.status.values()['joint/a'].split(' ')[1];
    cell.time.ms = 5000;

    cell.status.enter('connected');
    cell.value(1, 1);

    const reason = messages.stateMessages.noValueAgain('the broker closed the connection');
    assert.equal(cell.status.values()['joint/a'], `fault ${since} ${reason}`);
    assert.equal(wordOf(cell), 'not-connected');
    assert.equal(cell.status.message, `a fault: ${reason}`);
    assert.equal(cell.stateOf('b'), 'live');
  });

  it('Joint_ConnectionLostTwiceWithoutAValue_HasTheFirstReason', () => {
    const cell = plant(), first = 'the broker closed the connection';
    cell.value(0, 1);
    for (const reason of [first, 'the broker does not answer']) {
      cell.status.enter('waiting', reason);
      assert.ok(cell.status.values()['joint/a'].endsWith(` ${first}`), cell.status.values()['joint/a']);
      cell.status.enter('connected');
      assert.ok(cell.status.values()['joint/a'].endsWith(messages.stateMessages.noValueAgain(first)), cell.status.values()['joint/a']);
    }
  });

  it('Joint_StampOfAClockThatStandsStill_IsReportedAsTheSame', () => {
    const cell = plant();

    [1, 2].forEach(position => cell.value(0, position));

    assert.ok(cell.status.values()['joint/a'].endsWith(messages.refusalMessages.sameStamp), cell.status.values()['joint/a']);
  });

  it('Joint_RefusedForAnotherReason_KeepsTheStartOfItsState', () => {
    const cell = plant(), state = () => cell.status.values()['joint/a'].split(' ').slice(0, 2), { '0': missing, '1': start } = state();
    cell.time.ms = 1000;
    cell.value(0, NaN);
    assert.deepEqual(state(), [missing, start]);
    cell.output.lose(0, { reason: 'node-gone', text: 'the node is gone' });
    assert.deepEqual(state(), [missing, start]);
    cell.value(0, 1);
    cell.time.ms = 2000;
    cell.value(0, NaN);
    const refused = state();
    cell.time.ms = 5000;

    cell.value(0, 'text');

    assert.deepEqual([refused[0], state()], ['refused', refused]);
    assert.equal(wordOf(cell), 'type');
  });

  it('Adapter_ConnectsAgainAfterARefusal_StillHasTheReason', () => {
    const { status } = plant();

    status.enter('refused', "the server's certificate is not trusted");
    status.enter('connecting');

    assert.deepEqual([status.values().state, status.values().reason], ['connecting', "the server's certificate is not trusted"]);
    status.enter('connected');
    assert.equal(status.values().reason, undefined);
  });

  it('Joint_StampInAnotherUnit_IsReportedWithItsTimeAndTheUnit', () => {
    const cell = plant();

    cell.output.publish([{ index: 0, value: 1, stamp: T / 1000n }]);

    assert.ok(cell.status.values()['joint/a'].endsWith(messages.refusalMessages.farApart('1970-01-20')), cell.status.values()['joint/a']);
    assert.equal(wordOf(cell), 'stamp-old');
  });

  it('Joint_StampBeyondAllDates_IsReportedWithoutADate', () => {
    const cell = plant();

    cell.output.publish([{ index: 0, value: 1, stamp: 1_000_000n * T }]);

    assert.ok(cell.status.values()['joint/a'].endsWith(messages.refusalMessages.farApart(null)), cell.status.values()['joint/a']);
    assert.equal(wordOf(cell), 'stamp-future');
  });

  it('FrameAndSignal_InFault_HaveNoKeyThatAJointOfTheSameNameHas', () => {
    const { status } = plant();
    for (const conditions of [status.frames, status.signals]) conditions.fault('other', { reason: 'node-gone', text: 'gone' });

    assert.equal(status.values()['reason/other'], undefined);
  });
});

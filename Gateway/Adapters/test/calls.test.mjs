// Tests in virtual time when a connection whose service calls remain without a response is ended.
import assert from 'node:assert/strict';
import { describe, it, mock } from 'node:test';
import { messages } from './messages.mjs';
import { parts } from './parts.mjs';

const { gatewayMessages } = messages;
const { Calls } = await parts('gateway/calls');

const CALL_MS = 1500;
const nextTurn = () => new Promise(setImmediate);

/** Starts calls of a server that responds to the first one. `reasons` are the reasons of the ended connections, with their times in ms. */
async function server(test) {
  mock.timers.enable({ apis: ['setTimeout'] });
  test.after(() => mock.timers.reset());
  const cell = { ms: 0, sent: [], reasons: [], failures: [] };
  cell.calls = new Calls(text => cell.sent.push(JSON.parse(text)), reason => {
    cell.reasons.push([cell.ms, reason]);
    cell.calls.closed();
  }, () => cell.ms);
  cell.call = () => cell.calls.call('/t').catch(({ message }) => cell.failures.push(message));
  cell.answer = () => cell.calls.answered({ id: cell.sent.at(-1).id, values: {} });
  cell.pass = async ms => {
    cell.ms += ms;
    mock.timers.tick(ms);
    await nextTurn();
  };
  const first = cell.call();
  cell.answer();
  await first;
  return cell;
}

describe('service calls', () => {
  it('Server_NeverRespondsAgain_EndsConnectionsAtGrowingIntervals', async t => {
    const cell = await server(t);

    for (let i = 0; i < 150; i++) {
      void cell.call();
      await cell.pass(CALL_MS);
    }

    const seconds = cell.reasons.map(([ms]) => ms / 1000);
    assert.deepEqual(seconds, [4.5, 13.5, 31.5, 67.5, 127.5, 187.5]);
    assert.deepEqual(cell.reasons.map(([, reason]) => reason), [4.5, 9, 18, 36, 60, 60].map(s => gatewayMessages.notAnswered('/t', s)));
  });

  it('Server_RespondsAgain_ResetsTheInterval', async t => {
    const cell = await server(t);
    const miss = async () => {
      void cell.call();
      await cell.pass(CALL_MS);
    };
    for (let i = 0; i < 3; i++) await miss();

    void cell.call();
    cell.answer();
    for (let i = 0; i < 3; i++) await miss();

    assert.deepEqual(cell.reasons.map(([ms]) => ms), [4500, 9000]);
  });

  it('Server_HasNeverResponded_EndsNoConnection', async t => {
    const cell = await server(t);
    cell.calls = new Calls(() => {}, reason => cell.reasons.push(reason), () => cell.ms);

    for (let i = 0; i < 100; i++) {
      void cell.call();
      await cell.pass(CALL_MS);
    }

    assert.deepEqual([cell.reasons, cell.failures.length], [[], 100]);
  });

  it('Response_ArrivesDuringAPauseOfThisProcess_IsUsed', async t => {
    const cell = await server(t), call = cell.call();

    const passed = cell.pass(10_000);
    cell.answer();
    await passed;
    await call;

    assert.deepEqual([cell.reasons, cell.failures], [[], []]);
  });

  it('Call_OneMissedForLong_EndsNoConnection', async t => {
    const cell = await server(t);
    void cell.call();

    await cell.pass(10_000);

    assert.deepEqual([cell.reasons, cell.failures], [[], [gatewayMessages.notAnswered('/t', CALL_MS / 1000)]]);
  });

  it('Connection_EndsDuringCalls_FailsThemAtOnceAndCountsNoMiss', async t => {
    const cell = await server(t);
    for (let i = 0; i < 4; i++) void cell.call();
    await cell.pass(1000);

    cell.calls.closed();
    await nextTurn();
    const failures = [...cell.failures];
    await cell.pass(10_000);

    assert.deepEqual([failures, cell.reasons], [Array(4).fill(gatewayMessages.closed), []]);
  });
});

// Tests in virtual time when a connection is opened again.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';

const { Backoff, reconnecting } = await parts('backoff');

describe('backoff', () => {
  it('Delays_Repeated_DoubleUpTo1500Ms', () => {
    const backoff = new Backoff(() => 0.5);

    assert.deepEqual([1, 2, 3, 4, 5].map(() => backoff.next()), [200, 400, 800, 1500, 1500]);
    backoff.reset();
    assert.equal(backoff.next(), 200);
  });

  it('Delays_Randomised_VaryByAtMost20Percent', () => {
    assert.ok(Math.abs(new Backoff(() => 0).next() - 160) < 1e-9 && Math.abs(new Backoff(() => 1).next() - 240) < 1e-9);
  });
});

describe('reconnecting', () => {
  /** Makes connections of the given lengths in ms in virtual time. The signal is aborted during the connection after them. */
  async function connections(t, lengths, isLoginRefused) {
    const stop = new AbortController(), rest = [...lengths], cell = { waits: [], ended: [], again: 0 };
    let now = 0;
    t.mock.method(Math, 'random', () => 0.5);
    t.mock.method(performance, 'now', () => now);
    t.mock.method(globalThis, 'setTimeout', (then, ms) => {
      cell.waits.push(ms);
      setImmediate(then);
    });
    const connect = async () => {
      if (rest.length === 0) stop.abort();
      else now += rest[0];
      return rest.shift();
    };
    await reconnecting(stop.signal, connect, length => cell.ended.push(length), () => cell.again++, isLoginRefused);
    return cell;
  }

  it('Connections_Short_AreRepeatedWithDoubledDelays', async t => {
    assert.deepEqual((await connections(t, [0, 0, 2000, 0, 0])).waits, [200, 400, 800, 1500, 1500]);
  });

  it('Connection_LongerThan2S_IsFollowedByTheShortestDelay', async t => {
    assert.deepEqual((await connections(t, [0, 0, 0, 2001, 0])).waits, [200, 400, 800, 200, 400]);
  });

  it('Connection_EndedByTheSignal_IsNotReported', async t => {
    const { ended, again } = await connections(t, [1, 2]);

    assert.deepEqual([ended, again], [[1, 2], 2]);
  });

  it('Login_Refused_IsRepeatedAfter30SecondsTo5Minutes', async t => {
    const { waits } = await connections(t, [1, 1, 1, 1, 1, 1, 0, 1], length => length === 1);

    assert.deepEqual(waits, [30_000, 60_000, 120_000, 240_000, 250_000, 250_000, 200, 30_000]);
  });

  it('Signal_AbortedDuringADelay_EndsItAndTheAttempts', async t => {
    const stop = new AbortController();
    let attempts = 0;
    t.mock.method(globalThis, 'setTimeout', () => {});

    await reconnecting(stop.signal, async () => attempts++, () => setImmediate(() => stop.abort()));

    assert.equal(attempts, 1);
  });
});

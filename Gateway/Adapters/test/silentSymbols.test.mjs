// Tests in virtual time how silent symbols are read.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';

const { SilentSymbols } = await parts('ads/silentSymbols');

describe('silent symbols', () => {
  function plc(isOnChange = true) {
    const cell = { now: 0, values: [1, 2], confirmed: [], lost: [], renewed: [], isRefusing: false, isRunning: true };
    cell.symbols = new SilentSymbols([true, true], 100, isOnChange, {
      read: async joint => {
        if (cell.values[joint] === null) throw new Error('gone');
        return cell.values[joint];
      },
      confirm: (joints, agoMs) => {
        cell.confirmed.push([...joints]);
        cell.agoMs = agoMs;
      },
      isRunning: () => cell.isRunning,
      lose: (joint, error) => cell.lost.push([joint, error.message]),
      renew: async joint => {
        cell.renewed.push(joint);
        if (cell.isRefusing) throw new Error('refused');
      },
    }, () => cell.now);
    cell.look = () => {
      cell.now += 500;
      return cell.symbols.look();
    };
    cell.values.forEach((value, joint) => cell.symbols.heard(joint, value));
    return cell;
  }

  it('Symbols_AtRest_AreConfirmed', async () => {
    const cell = plc();

    await cell.look();

    assert.deepEqual([cell.confirmed, cell.lost, cell.renewed], [[[0, 1]], [], []]);
  });

  // Headsets show a sample for about 300 ms.
  it('Symbols_AtRest_AreConfirmedAtLeastEvery100Ms', async t => {
    t.mock.timers.enable({ apis: ['setTimeout'] });
    const cell = plc(), stop = new AbortController();
    void cell.symbols.run(stop.signal);

    for (; cell.now < 1000; cell.now += 10) {
      t.mock.timers.tick(10);
      await new Promise(setImmediate);
    }
    stop.abort();

    assert.ok(cell.confirmed.length >= 10, `${cell.confirmed.length} in 1 s`);
  });

  it('Symbols_SlowRead_AreConfirmedAsOfTheStartOfTheRead', async () => {
    const cell = plc(), { actions } = cell.symbols, { read } = actions;
    actions.read = joint => {
      cell.now += 40;
      return read(joint);
    };

    await cell.look();

    assert.equal(cell.agoMs, 80);
  });

  it('Symbol_ChangedButNotNotifiedYet_IsNotSubscribedAgain', async () => {
    const cell = plc();
    cell.now += 100;
    cell.values[0] = 7;

    await cell.symbols.look();
    cell.now += 90;
    await cell.symbols.look();
    const { renewed } = cell;
    cell.symbols.heard(0, 7);
    await cell.look();

    assert.deepEqual([renewed, cell.confirmed], [[], [[1], [1], [0, 1]]]);
  });

  it('Symbol_RemovedThenRestored_IsLostThenSubscribedAgain', async () => {
    const cell = plc();
    cell.values[0] = null;

    await cell.look();
    cell.values[0] = 1;
    await cell.look();

    assert.deepEqual([cell.lost, cell.renewed, cell.confirmed], [[[0, 'gone']], [0], [[1], [1]]]);
  });

  it('Symbol_ChangedWithoutNotification_IsSubscribedAgain', async () => {
    const cell = plc();
    cell.values[0] = 7;

    await cell.look();
    await cell.look();

    assert.deepEqual([cell.renewed, cell.confirmed], [[0], [[1], [1]]]);
  });

  it('Symbol_WithPeriodicNotifications_IsNotConfirmedByAnEqualValue', async () => {
    const cell = plc(false);

    await cell.look();
    await cell.look();

    assert.deepEqual([cell.confirmed, cell.renewed], [[], [0, 1]]);
  });

  it('Symbol_SubscriptionRefused_IsTriedAgainEvery10SecondsAndThenWatched', async () => {
    const cell = plc(), requests = [];
    const lookUntil = async end => {
      while (cell.now < end) {
        cell.symbols.heard(1, 2);
        const { length } = cell.renewed;
        await cell.look();
        if (cell.renewed.length > length) requests.push(cell.now);
      }
    };
    cell.symbols.refuse(0, new Error('refused at first'));
    cell.isRefusing = true;

    await lookUntil(25_000);
    cell.isRefusing = false;
    await lookUntil(31_000);
    cell.values[0] = null;
    await cell.look();

    assert.deepEqual(requests, [10_000, 20_000, 30_000]);
    assert.deepEqual(cell.lost, [[0, 'refused at first'], [0, 'refused'], [0, 'refused'], [0, 'gone']]);
    // At 30.5 s and 31 s.
    assert.equal(cell.confirmed.filter(joints => joints.includes(0)).length, 2);
  });

  // A stopped PLC also returns its last values.
  it('Symbols_ProgramStopped_AreReadAgainAfterTheStart', async () => {
    const cell = plc();
    cell.values[0] = null;
    await cell.look();
    cell.values[0] = 1;

    cell.isRunning = false;
    await cell.look();
    assert.deepEqual([cell.renewed, cell.confirmed], [[], [[1]]]);
    cell.isRunning = true;
    await cell.look();

    assert.deepEqual([cell.renewed, cell.confirmed], [[0], [[1], [1]]]);
  });

  for (const value of [7, null])
    it(`Symbol_ProgramStopsDuringTheRead_IsNeitherSubscribedAgainNorLost (${value})`, async () => {
      const cell = plc(), { actions } = cell.symbols, { read } = actions;
      actions.read = joint => {
        cell.isRunning = false;
        return read(joint);
      };
      cell.values[0] = value;

      await cell.look();

      assert.deepEqual([cell.renewed, cell.lost, cell.confirmed], [[], [], []]);
    });

  it('Symbol_ProgramStopsDuringTheSubscription_IsSubscribedAgainAfterTheStart', async () => {
    const cell = plc(), { actions } = cell.symbols, { renew } = actions;
    actions.renew = joint => {
      cell.isRunning = false;
      return renew(joint);
    };
    cell.isRefusing = true;
    cell.symbols.discard(0);

    await cell.look();
    [cell.isRunning, cell.isRefusing] = [true, false];
    await cell.look();

    assert.deepEqual([cell.lost, cell.renewed], [[], [0, 0]]);
  });

  for (const [name, value, expected] of [['', 1, [0, 1]], ['OneNotReadable', null, [1]]])
    it(`Symbols_SubscriptionsRefused${name}_AreTriedAgainOneAfterTheOther`, async () => {
      const cell = plc(), counts = [];
      cell.values[0] = value;
      for (const symbol of [0, 1]) cell.symbols.refuse(symbol, new Error('refused'));
      cell.lost = [];
      cell.now += 9500;

      for (const _ of [1, 2]) {
        await cell.look();
        counts.push(cell.renewed.length + cell.lost.length);
      }

      assert.deepEqual([counts, cell.renewed], [[1, 2], expected]);
    });
});

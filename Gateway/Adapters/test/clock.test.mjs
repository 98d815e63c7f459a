import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';
import { messages } from './messages.mjs';

const { clockMessages } = messages;

const { finePause, Resolution, OfferedClock, ofFileTime, toRosTime } = await parts('clock/finePause', 'clock/resolution', 'clock/offeredClock', 'times');
const MS = 1_000_000n;
const T = 1_700_000_000_000n * MS;

/** Runs a test as on Windows, where a timer first calls `ends`. */
function onWindows(t, ends) {
  const { platform } = process, as = value => Object.defineProperty(process, 'platform', { value });
  as('win32');
  t.after(() => as(platform));
  t.mock.method(globalThis, 'setTimeout', then => {
    ends();
    setImmediate(then);
  });
}

const observed = (times, between = MS) => {
  const resolution = new Resolution();
  times.forEach((time, i) => resolution.observe(time, BigInt(i) * between, BigInt(i) * between + 1000n));
  return resolution;
};
const eight = step => Array.from({ length: 9 }, (_, i) => T + BigInt(7 * i * i + 3 * i) * step);

describe('resolution', () => {
  for (const step of [1n, 100n, 1000n, MS, 10n * MS, 1000n * MS]) {
    it(`Resolution_TimesInStepsOf${step}ns_IsTheStep`, () => assert.equal(observed(eight(step)).value, step));
  }

  it('Resolution_TooFewTimes_IsUnknown', () => assert.equal(observed(eight(MS).slice(0, 7)).value, 0n));

  it('Resolution_ClockConstantBetweenUpdates_IsTheUpdateInterval', () => {
    const times = eight(100n).flatMap(time => [time, time, time]);

    // The first reading arrived 1 µs after its request. The third shows the same time and was requested 100 ms after the first request.
    assert.equal(observed(times, 50n * MS).value, 100n * MS - 1000n);
  });

  it('Resolution_ClockStoppedOnce_RecoversWithinAMinute', () => {
    const resolution = new Resolution();
    let now = 0n;
    const observe = time => {
      resolution.observe(time, now, now);
      now += 200n * MS;
    };
    eight(MS).forEach(observe);
    for (let i = 0; i < 4; i++) observe(T + 10_000n * MS);
    observe(T + 11_000n * MS);
    const soonAfter = resolution.value;

    for (let i = 1n; i < 310n; i++) observe(T + (11_000n + 200n * i) * MS);

    // The clock showed the same time for 600 ms and then advanced by 1000 ms, so its resolution may have been 1000 ms.
    assert.deepEqual([soonAfter, resolution.value], [1000n * MS, MS]);
  });
});

describe('times', () => {
  it('FileTime_Of1970_IsZero', () => assert.equal(ofFileTime(116444736000000000n), 0n));

  it('FileTime_ConvertedToRosTime_KeepsTheResolutionOf100ns', () =>
    assert.deepEqual(toRosTime(ofFileTime(116444736000000000n + 12_345_678_901n)), { sec: 1234, nanosec: 567890100 }));
});

describe('plant clock', () => {
  const link = () => {
    const services = new Map();
    return { services, offer: (name, type, answer) => services.set(name, { type, answer }) };
  };
  const never = new AbortController().signal;

  it('Clock_NeverRead_IsNotOffered', async () => {
    const gateway = link(), clock = new OfferedClock(gateway, 'cell');

    await assert.rejects(clock.attach(async () => { throw new Error('no such service'); }, never), /no such service/);

    assert.deepEqual([gateway.services.size, clock.isSettled], [0, false]);
    await clock.doWithout(AbortSignal.abort());
    assert.deepEqual([gateway.services.size, clock.isSettled], [0, true]);
  });

  it('Request_PlantDisconnected_ReturnsTheReason', async () => {
    const gateway = link(), clock = new OfferedClock(gateway, 'cell', MS);
    await clock.attach(async () => ({ received: T, sent: T }), never);

    clock.detach();

    await assert.rejects(gateway.services.get('/nowpose/plant_time/cell').answer(), { message: clockMessages.notConnected });
    assert.ok(clock.isSettled);
  });

  it('Clock_DetachedDuringMeasurement_IsNeitherReadNorOffered', async () => {
    const gateway = link(), clock = new OfferedClock(gateway, 'cell');
    let time = T;
    const attached = clock.attach(async () => {
      time += 7n * MS;
      return { received: time, sent: time };
    }, never);

    clock.detach();

    assert.equal(await attached, false);
    assert.equal(gateway.services.size, 0);
    await assert.rejects(clock.read(), { message: clockMessages.notConnected });
  });

  it('Request_PlantConnected_ReturnsTimesAndResolution', async () => {
    const gateway = link(), clock = new OfferedClock(gateway, 'cell');
    let time = T;
    await clock.attach(async () => {
      time += 7n * MS;
      return { received: time, sent: time + MS };
    }, never);

    const { received, sent, ...rest } = await gateway.services.get('/nowpose/plant_time/cell').answer();

    assert.equal(BigInt(sent.sec) * 1000n * MS + BigInt(sent.nanosec) - BigInt(received.sec) * 1000n * MS - BigInt(received.nanosec), MS);
    assert.deepEqual(rest, { resolution_ns: 1_000_000, error_bound_ns: 0, synchronised: true });
  });

  it('Resolution_Configured_IsUsed', async () => {
    const gateway = link(), clock = new OfferedClock(gateway, 'cell', 5n * MS);
    await clock.attach(async () => ({ received: T, sent: T }), never);

    assert.equal((await clock.read()).resolution, 5n * MS);
  });

  it('Clock_PausedAndResumed_IsUnavailableDuringThePauseAndKeepsItsResolution', async () => {
    let now = 0n, time = T, isPaused = false;
    const coarse = new Set(), gateway = link(), clock = new OfferedClock(gateway, 'cell', null, () => now, each => coarse.add(each));
    const pass = length => {
      now += length;
      if (!isPaused) time += length;
    };
    await clock.attach(async () => {
      pass(3n * MS);
      return { received: time, sent: time };
    }, never);
    // Reads the clock every 200 ms, like a gateway.
    const asked = async () => {
      pass(197n * MS);
      return gateway.services.get('/nowpose/plant_time/cell').answer();
    };
    const before = await asked();

    isPaused = true;
    let answered = 0;
    for (let i = 0; i < 150; i++) await asked().then(() => answered++, error => assert.equal(error.message, clockMessages.stopped));
    isPaused = false;
    const after = await asked();

    assert.ok(answered > 0 && answered <= 7, `${answered} answers of a stopped clock`);
    assert.equal(before.resolution_ns, 1_000_000);
    assert.equal(after.resolution_ns, 1_000_000);
    // A standstill that has not ended may be a pause instead of a step of the clock.
    assert.deepEqual([...coarse], [null]);
  });

  // The clock of Windows has a resolution of 15.625 ms. A synchronised gateway reads it once a second, so it never reads the same time twice.
  it('Resolution_CoarseClockReadOnceASecond_StaysCoarse', async () => {
    let now = 0n;
    const gateway = link(), clock = new OfferedClock(gateway, 'cell', null, () => now), step = 15_625_000n;
    await clock.attach(async () => {
      now += 3n * MS;
      const time = T + now / step * step;
      return { received: time, sent: time };
    }, never);
    const observed = [];
    for (let second = 0; second < 200; second++) {
      now += 997n * MS;
      observed.push((await gateway.services.get('/nowpose/plant_time/cell').answer()).resolution_ns);
      await clock.settled;
    }

    assert.deepEqual([...new Set(observed)], [15_625_000]);
  });

  // A server on Windows has the same step as the timers of an adapter on Windows, so that each timer would end in a new step.
  it('Resolution_TimersAsCoarseAsTheClock_IsThatOfTheClock', async t => {
    const step = 15_625_000n, phase = 5n * MS;
    let now = 0n;
    onWindows(t, () => { now = (now / step + 1n) * step; });
    const clock = new OfferedClock(link(), 'cell', null, () => (now += 10_000n));
    await clock.attach(async () => {
      now += MS / 2n;
      const time = T + (now + phase) / step * step;
      return { received: time, sent: time };
    }, never);

    assert.ok(clock.resolution > 14n * MS && clock.resolution <= step, `${clock.resolution} ns`);
  });

  it('FinePause_SignalAborted_EndsAtOnce', async t => {
    onWindows(t, () => assert.fail('a timer was started'));
    const stop = new AbortController();

    const pause = finePause(3, stop.signal, () => 0n);
    stop.abort();

    await pause;
  });

  for (const [step, expected] of [[1000n * MS, [1000n * MS]], [10n * MS, []]])
    it(`Clock_InStepsOf${step / MS}ms_${expected.length > 0 ? 'IsReportedAsCoarse' : 'IsNotReported'}`, async () => {
      let now = 0n;
      const observed = new Set(), clock = new OfferedClock(link(), 'cell', null, () => now, coarse => observed.add(coarse));
      const read = async () => {
        now += 50n * MS;
        const time = T + now / step * step;
        return { received: time, sent: time };
      };
      await clock.attach(read, never);
      for (let i = 0; i < 400; i++) {
        await clock.read();
        await clock.settled;
      }

      assert.deepEqual([...observed].filter(coarse => coarse !== null), expected);
    });

  for (const [name, step, pause, expected] of [
    ['SetBack', -2000n * MS, 0n, 1], ['SetForward', 2000n * MS, 0n, 1], ['ChangedByHalfASecond', -500n * MS, 0n, 0], ['Paused', 0n, 10_000n * MS, 0],
  ])
    it(`Stepped_Clock${name}_IsReported${expected === 1 ? 'Once' : 'Never'}`, async () => {
      let now = 0n, time = T, isPaused = false, steps = 0;
      const clock = new OfferedClock(link(), 'cell', null, () => now);
      clock.stepped = () => { steps++; };
      const pass = length => {
        now += length;
        if (!isPaused) time += length;
      };
      await clock.attach(async () => {
        pass(3n * MS);
        const sent = time;
        pass(3n * MS);
        return { received: sent, sent };
      }, never);
      const readFor = async length => {
        for (const end = now + length; now < end;) {
          pass(200n * MS);
          await clock.read().catch(() => {});
        }
      };
      await readFor(2000n * MS);

      isPaused = true;
      await readFor(pause);
      isPaused = false;
      time += step;
      await readFor(2000n * MS);

      assert.equal(steps, expected);
    });

  it('Stepped_ResponseLateByFourSeconds_IsNotReported', async () => {
    let now = 0n, delay = 3n * MS, steps = 0;
    const clock = new OfferedClock(link(), 'cell', MS, () => now);
    clock.stepped = () => { steps++; };
    await clock.attach(async () => {
      const time = T + (now += delay);
      return { received: time, sent: time };
    }, never);

    delay = 4000n * MS;
    await clock.read();
    delay = 3n * MS;
    await clock.read();

    assert.equal(steps, 0);
  });

  it('Now_ClockDetached_IsUnknown', async () => {
    const clock = new OfferedClock(link(), 'cell', MS);
    await clock.attach(async () => ({ received: T, sent: T }), never);
    const known = clock.now;

    clock.detach();

    assert.ok(known >= T && known < T + 60_000n * MS);
    assert.equal(clock.now, null);
  });
});

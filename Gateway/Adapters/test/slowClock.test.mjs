// Tests the resolution of a clock whose reading takes longer than the clock stands still, in virtual time.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';
import { seeded } from './seeded.mjs';
import { VirtualTime } from './virtualTime.mjs';

const { READINGS_AT_ONCE, OfferedClock } = await parts('clock/clockStep', 'clock/offeredClock');
const MS = 1_000_000n, T = 1_700_000_000_000n * MS + 4_321_700n;
const NO_LIMIT = new AbortController().signal;
const LATE = new Error('no response within 1.5 s');

/** Creates a clock that is offered to a gateway, and read over a path of this length in each direction, with random delays of up to 1 ms more. */
function clockOf(t, { stepNs, eachWayMs, seed, shownNs = 100n, servingMs = 0.02, wakesMs = 0, irregular = 1, atOnce = READINGS_AT_ONCE, isLate = () => false }) {
  const virtual = new VirtualTime(t), random = seeded(seed);
  // The server processes the requests one after the other, by default in 20 to 60 µs for each, and the responses arrive in the same order.
  let free = 0n, arrived = 0n, wake = 0n;
  const later = (time, ms) => time + BigInt(Math.round(ms * 1e6));
  let count = 0;
  const read = async () => {
    if (isLate(count++)) throw await virtual.until(virtual.now + 1500n * MS).then(() => LATE);
    const received = later(virtual.now, eachWayMs + random());
    while (wakesMs > 0 && wake < received) wake = later(wake, wakesMs * (1 + irregular * random()));
    if (wake > free) free = wake;
    free = later(received > free ? received : free, servingMs * (1 + 2 * random()));
    const shown = T + free / stepNs * stepNs, time = shown - shown % shownNs, back = later(free, eachWayMs + random());
    arrived = back > arrived ? back : arrived;
    await virtual.until(arrived);
    return { received: time, sent: time };
  };
  const clock = new OfferedClock({ offer: () => {} }, 'cell', null, () => virtual.now);
  return { clock, virtual, attach: () => virtual.run(clock.attach(read, NO_LIMIT, atOnce)), reading: () => virtual.run(clock.read()) };
}

describe('clock that is read slowly', () => {
  for (const seed of [1, 2, 3])
    for (const [stepUs, eachWayMs] of [[15_625, 5], [4000, 1.5], [4000, 10], [10_000, 6], [2000, 3], [20_000, 25]])
      it(`Resolution_StepOf${stepUs}usReadOver${eachWayMs}ms_IsTheStep (seed ${seed})`, async t => {
        const stepNs = BigInt(stepUs) * 1000n, { attach, reading } = clockOf(t, { stepNs, eachWayMs, seed });
        await attach();

        const { resolution, errorBound } = await reading();

        assert.deepEqual([resolution, errorBound], [stepNs, 0n]);
      });

  for (const seed of [1, 2, 3])
    it(`Resolution_NoStep_LeavesABoundOfTheShortestGap (seed ${seed})`, async t => {
      const { attach, reading } = clockOf(t, { stepNs: 100n, eachWayMs: 5, seed });
      await attach();

      const { resolution, errorBound } = await reading();

      assert.equal(resolution, 100n);
      // The server needs at least 20 µs between two readings, so a step of 20 µs could not be seen.
      assert.ok(errorBound >= 19_000n && errorBound < 60_000n, `${errorBound} ns`);
    });

  it('Resolution_StepsOf15625usInWholeMilliseconds_IsTheLongerStep', async t => {
    const { attach, reading } = clockOf(t, { stepNs: 15_625_000n, shownNs: MS, eachWayMs: 5, seed: 1 });
    await attach();

    assert.equal((await reading()).resolution, 16n * MS);
  });

  for (const seed of [1, 2, 3])
    it(`Resolution_ServerSlowerThanEqualSteps_IsTheStep (seed ${seed})`, async t => {
      const { attach, reading } = clockOf(t, { stepNs: 12n * MS, eachWayMs: 5, seed, servingMs: 8 });
      await attach();

      const { resolution, errorBound } = await reading();

      assert.deepEqual([resolution, errorBound], [12n * MS, 0n]);
    });

  for (const seed of [1, 2, 3])
    it(`Resolution_ServerSlowerThanTheStep_IsTheLargestDivisor (seed ${seed})`, async t => {
      const { attach, reading } = clockOf(t, { stepNs: MS, shownNs: MS, eachWayMs: 5, seed, servingMs: 1.3 });
      await attach();

      const { resolution, errorBound } = await reading();

      assert.equal(resolution, MS);
      assert.ok(errorBound <= MS, `${errorBound} ns`);
    });

  // Simultaneous readings fail together.
  for (const [atOnce, late] of [[1, [3, 7, 8]], [READINGS_AT_ONCE, [3, 7, 8, 9, 10, 40]]])
    for (const seed of [1, 2, 3])
      it(`Resolution_SomeReadingsOf${atOnce}AtOnceFail_IsTheStep (seed ${seed})`, async t => {
        const { attach, reading } = clockOf(t, { stepNs: 10n * MS, eachWayMs: 1, seed, atOnce, isLate: i => late.includes(i) });
        assert.equal(await attach(), true);

        const { resolution, errorBound } = await reading();

        assert.deepEqual([resolution, errorBound], [10n * MS, 0n]);
      });

  it('Resolution_ThreeReadingsInARowFail_IsNotMeasured', async t => {
    const { attach } = clockOf(t, { stepNs: 4n * MS, eachWayMs: 1, seed: 1, atOnce: 1, isLate: i => i >= 3 && i <= 5 });

    await assert.rejects(attach(), LATE);
  });

  // The measurement is repeated every 20 s.
  for (const seed of [1, 2, 3])
    for (const [wakesMs, irregular] of [[2.5, 1], [10, 0], [20, 1], [50, 0.2], [50, 1]])
      it(`Resolution_ServerAnswersRequestsEvery${wakesMs}To${wakesMs * (1 + irregular)}ms_IsTheLargestDivisor (seed ${seed})`, async t => {
        const { clock, virtual, attach, reading } = clockOf(t, { stepNs: MS, shownNs: MS, eachWayMs: 2, seed, wakesMs, irregular, servingMs: 0.005 });
        await attach();
        for (let i = 0; i < 20; i++) {
          assert.equal((await reading()).resolution, MS, `reading ${i}`);
          await virtual.run(clock.settled);
          await virtual.run(virtual.until(virtual.now + 21_000n * MS));
        }
      });
});

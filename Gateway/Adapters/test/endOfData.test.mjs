// Tests in virtual time how the adapter detects that data end in mid-motion: stops cause no alarm, and interrupted motions cause an alarm.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { changes, smooth, trapezoid } from './motions.mjs';
import { parts } from './parts.mjs';
import { seeded } from './seeded.mjs';

const { EndOfData } = await parts('samples/endOfData');

const SEED = 4711, STOPS = 400, FLOOR = 12;
const INTERVALS = [0.01, 0.02, 0.05, 0.1];
const START = 1_700_000_000n * 1_000_000_000n;
const stampOf = time => START + BigInt(Math.round((time + 10) * 1e9));
const logarithmic = (random, from, to) => from * (to / from) ** random();

/** Resolution and errors of each kind of source, for a sampling interval in s. */
const SOURCES = {
  Exact: interval => ({ interval }),
  Quantised: (interval, random) => ({ interval, quantum: logarithmic(random, 1e-5, 3e-3) }),
  WithDeadband: (interval, random) => ({ interval, deadband: logarithmic(random, 1e-4, 1e-2) }),
  Noisy: (interval, random) => {
    const noise = logarithmic(random, 1e-6, 3e-4);
    return { interval, noise, quantum: noise, deadband: 8.5 * noise };
  },
  WithJitter: (interval, random) => ({ interval, jitter: 0.5 * random(), stampError: 0.01 * interval, quantum: 1e-5 }),
  WithGaps: interval => ({ interval, jitter: 0.1, skip: 0.15, quantum: 1e-5 }),
};

const MOTIONS = {
  Normal: random => smooth({ v: logarithmic(random, 0.02, 2), duration: 0.5 + 2 * random() }),
  Trapezoidal: random => {
    const v = logarithmic(random, 0.02, 3), a = logarithmic(random, 0.5, 10);
    return trapezoid({ v, a, brakeAt: v / a * (1 + random()) + random(), brake: a });
  },
  Emergency: random => {
    const v = logarithmic(random, 0.02, 3), a = logarithmic(random, 0.5, 10);
    return trapezoid({ v, a, brakeAt: v / a * (1 + random()) + random(), brake: logarithmic(random, 10, 30) });
  },
};

function judgeOf(samples, judge = new EndOfData(FLOOR)) {
  for (const { time, value } of samples) judge.add(stampOf(time), value);
  return judge;
}

describe('end of data', () => {
  for (const [motion, make] of Object.entries(MOTIONS))
    for (const [name, source] of Object.entries(SOURCES))
      it(`Verdict_${motion}Stops${name}_RaisesNoFalseAlarm`, () => {
        const random = seeded(SEED);
        for (let i = 0; i < STOPS; i++) {
          const interval = INTERVALS[i % INTERVALS.length], move = make(random), options = source(interval, random);
          const samples = [...changes(move, random, { ...options, until: move.end + 2 })];

          const judge = judgeOf(samples), verdict = judge.verdict(interval);

          // An emergency stop stops all joints. A hard stop while other joints move counts as an end of data, so this case is not checked here.
          if (motion !== 'Emergency' && name !== 'WithGaps') assert.equal(judge.verdict(interval, true), null, `alone, stop ${i} of seed ${SEED}`);
          assert.equal(verdict, null, `stop ${i} of seed ${SEED}: ${JSON.stringify(options)} ${JSON.stringify(samples.slice(-4))}`);
        }
      });

  for (const [interval, speed] of [[0.01, 0.25], [0.02, 0.5], [0.05, 1.2], [0.1, 2.4]])
    it(`Verdict_SineCutAt${speed}RadPerSecondEvery${1000 * interval}Ms_DetectsTheEndOfData`, () => {
      const random = seeded(SEED), peak = 1.2 * speed, amplitude = peak / 2;
      let found = 0;
      for (let i = 0; i < 200; i++) {
        // The data end after at least one reversal of the motion, while the joint moves at a speed of at least `speed`.
        const cut = (Math.PI * (3 + i % 3) + (random() - 0.5)) / 2, sine = { position: t => amplitude * Math.sin(2 * t) };
        const judge = judgeOf(changes(sine, random, { interval, from: 0, until: cut, jitter: 0.2, quantum: 1e-5 }));
        if (judge.verdict(interval) !== null) found++;
      }
      // A few ends are not detected, because the last interval is short or the positions are rounded.
      assert.ok(found >= 190, `${found} of 200`);
    });

  for (const [amplitude, hertz, interval] of [[0.4, 0.5, 0.1], [0.1, 1, 0.05], [0.1, 0.5, 0.1]])
    for (const jitter of [0, 0.1])
      it(`Verdict_SineOf${amplitude}RadAt${hertz}HzEvery${1000 * interval}MsWithJitter${jitter}CutAtItsHighestSpeed_DetectsTheEndOfData`, () => {
        const sine = { position: t => amplitude * Math.sin(2 * Math.PI * hertz * t) };
        for (let i = 0; i < 40; i++) {
          // Without jitter, the samples coincide with the turning points, so the steps there are as large as possible. The last sample is at the
          // highest speed.
          const random = seeded(SEED + i), until = (3 + i % 4) / (2 * hertz) + 0.6 * interval;

          const judge = judgeOf(changes(sine, jitter === 0 ? () => 0 : random, { interval, from: 0, until, jitter }));

          assert.notEqual(judge.verdict(interval, true), null, `seed ${SEED + i}, cut at ${until} s`);
        }
      });

  /** Counts the detected ends of sines with a number of samples per period, if a stop needs at least `ratio` times the highest deceleration. */
  function cutSines({ from, to, ratio, runs = 1500, ...source }) {
    const random = seeded(SEED), count = { found: 0, all: 0 };
    for (let i = 0; i < runs; i++) {
      const interval = INTERVALS[i % INTERVALS.length], samples = from + (to - from) * random(), omega = 2 * Math.PI / (samples * interval);
      const amplitude = logarithmic(random, 0.05, 1), phase = 2 * Math.PI * random(), period = samples * interval;
      const sine = { position: t => amplitude * Math.sin(omega * t + phase) };
      const sent = [...changes(sine, random, { interval, from: 0, until: period * (2 + 2 * random()), ...source })], [before, last] = sent.slice(-2);
      const needed = Math.abs(last.value - before.value) / (last.time - before.time) / interval;
      if (needed < ratio * amplitude * omega * omega) continue;
      count.all++;
      if (judgeOf(sent).verdict(interval, true) !== null) count.found++;
    }
    return count;
  }

  for (const [name, source] of Object.entries({ Exact: {}, Quantised: { quantum: 1e-5 }, Jittered: { jitter: 0.2, quantum: 1e-5 }, Noisy: { noise: 1e-4, quantum: 1e-4 } }))
    for (const [from, to, ratio, share] of [[8, 16, 1.5, 0.85], [8, 16, 2, 0.99], [16, 24, 1.5, 0.95], [24, 40, 1.5, 0.95]])
      it(`CutOf${name}Sine_${from}To${to}SamplesPerPeriodAndStopNeeds${ratio}TimesItsDeceleration_IsMostlyDetected`, () => {
        const { found, all } = cutSines({ from, to, ratio, ...source });

        assert.ok(all >= 50 && found >= share * all, `${found} of ${all}, seed ${SEED}`);
      });

  it('Verdict_ConstantSpeedFromTheStartToTheCut_DetectsTheEndOfData', () => {
    for (let i = 0; i < 40; i++) {
      const random = seeded(SEED + i);

      const judge = judgeOf(changes({ position: t => 0.8 * t }, random, { interval: 0.02, from: 0, until: 1, jitter: 0.1, quantum: 1e-5 }));

      assert.notEqual(judge.verdict(0.02), null, `seed ${SEED + i}`);
    }
  });

  it('Verdict_QuantisedValueMovesOneStepPerSample_DetectsNoEndOfData', () => {
    // 0.002 rad per 10 ms: a stop within the step explains the end of the data, although all steps are equal.
    const judge = judgeOf([...Array(30).keys()].map(i => ({ time: 0.01 * i, value: 0.002 * i })));

    assert.equal(judge.verdict(0.01), null);
  });

  it('Verdict_ConstantSpeed_RequiresSpeedDividedByInterval', () => {
    const judge = judgeOf(changes(trapezoid({ v: 1, a: 2, brakeAt: 100, brake: 1 }), () => 0, { interval: 0.02, until: 2 }));

    const { required, limit } = judge.verdict(0.02);

    // v/h is 50 rad/s². The resolution, which is derived from the smallest step at the start of the motion, reduces it slightly.
    assert.ok(required > 45 && required <= 50, `${required}`);
    assert.equal(limit, FLOOR);
  });

  it('Verdict_ConfiguredDeceleration_ReplacesTheObservedOne', () => {
    const samples = [...changes(trapezoid({ v: 1, a: 2, brakeAt: 100, brake: 1 }), () => 0, { interval: 0.02, until: 2 })];

    assert.equal(judgeOf(samples, new EndOfData(FLOOR, 60)).verdict(0.02), null);
    assert.equal(judgeOf(samples, new EndOfData(FLOOR, 30)).verdict(0.02).limit, 30);
  });

  it('Verdict_LargerDecelerationObservedBefore_DetectsNoEndOfData', () => {
    const random = seeded(SEED), judge = new EndOfData(FLOOR);
    const braked = trapezoid({ v: 4, a: 5, brakeAt: 1, brake: 40 });
    judgeOf(changes(braked, random, { interval: 0.01, until: braked.end + 0.5 }), judge);
    for (const { time, value } of changes(trapezoid({ v: 0.5, a: 2, brakeAt: 100, brake: 1 }), random, { interval: 0.01, from: 5, until: 7 }))
      judge.add(stampOf(time), value);

    assert.equal(judge.verdict(0.01), null);
  });

  for (const [place, isLearned] of [['TheSame', true], ['Another', false]])
    it(`Verdict_MotionStartsAgainAt${place}Place_${isLearned ? 'LearnsTheStop' : 'LearnsNothing'}`, () => {
      // The data end at the highest speed of the motion, 0.5 rad/s.
      const swing = { position: t => 0.25 * Math.sin(2 * t) }, cut = [...changes(swing, () => 0, { interval: 0.05, from: 0, until: 3 * Math.PI })];
      const judge = judgeOf(cut), before = judge.verdict(0.05, true), shift = isLearned ? 0 : 0.2;
      const later = { position: t => cut.at(-1).value + shift + 0.25 * Math.sin(2 * t) };

      for (const { time, value } of changes(later, () => 0, { interval: 0.05, from: 0, until: 3 * Math.PI }))
        judge.add(stampOf(time + 20), value);

      assert.notEqual(before, null);
      assert.equal(judge.verdict(0.05, true) === null, isLearned);
    });

  it('Verdict_FewSamples_IsUnknown', () => {
    const judge = judgeOf([0, 1, 2].map(i => ({ time: 0.01 * i, value: i })));

    assert.equal(judge.verdict(0.01), null);
  });

  it('Verdict_StepAfterRest_DetectsNoEndOfData', () => {
    const rest = [...Array(20).keys()].map(i => ({ time: 0.02 * i, value: 0.001 * i }));

    const judge = judgeOf([...rest, { time: 5, value: 2 }]);

    assert.equal(judge.verdict(0.02), null);
  });
});

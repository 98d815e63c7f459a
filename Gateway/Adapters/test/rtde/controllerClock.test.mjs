// Tests the estimate of the controller's clock in virtual time. It uses the controller's packages and the replies received between them.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { seeded } from '../seeded.mjs';
import { messages } from '../messages.mjs';

const { rtdeMessages } = messages;

const { ControllerClock } = await parts('rtde/controllerClock');

const MS = 1_000_000n, ns = ms => BigInt(Math.round(ms * 1e6));

/**
 * Simulates a controller with its own clock, and a network with a minimum delay of `minDelayMs`. The controller sends each package within
 * `sendMs` after its timestamp, except for a fraction of late packages. `at` is a time of this machine's counter in ms.
 */
class Link {
  packages = [];
  stepped = [];

  constructor({ seed, aheadMs = 5_000_000, ppm = 80, periodMs = 8, minDelayMs = 0.2, jitterMs = 2, sendMs = 2, assumedMs = 2, lateShare = 0,
    answers = true }) {
    Object.assign(this, { seed, aheadMs, ppm, periodMs, minDelayMs, jitterMs, sendMs, lateShare, random: seeded(seed), answers });
    this.clock = new ControllerClock(ns(assumedMs), by => this.stepped.push(Number(by) / 1e6));
    this.cycle = 1;
    this.question = null;
    this.arrived = 0;
  }

  /** Returns the time of the controller's clock in ms. */
  truth(at) { return at * (1 + this.ppm / 1e6) + this.aheadMs; }

  #delay() { return this.minDelayMs + this.jitterMs * this.random() ** 4; }

  /** Continues the simulation until a time, with about 16 requests per second. */
  play(untilMs) {
    for (;;) {
      const begun = this.cycle * this.periodMs;
      if (begun > untilMs) return;
      const sent = begun + this.sendMs * this.random() + (this.lateShare > 0 && this.random() < this.lateShare ? 30 * this.random() : 0);
      this.arrived = Math.max(this.arrived, sent + this.#delay());
      let asked = null;
      if (this.question !== null && this.question.there <= sent) {
        asked = this.question.asked;
        this.question = null;
      }
      this.clock.heard(ns(this.truth(begun)), ns(this.arrived), asked === null ? null : ns(asked));
      if (this.question === null && (this.answers || this.cycle === 1) && this.random() < this.periodMs / 60) {
        const later = this.arrived + this.periodMs * this.random();
        this.question = { asked: later, there: later + this.#delay() };
      }
      this.cycle++;
    }
  }

  /** Returns the error of the clock's current reading and its error bound, both in ms. */
  reading() {
    const at = this.arrived + 1, { sent, errorBound } = this.clock.at(ns(at));
    return { error: Number(sent - ns(this.truth(at))) / 1e6, bound: Number(errorBound) / 1e6 };
  }
}

describe('rtde clock', () => {
  for (const [what, options, mostError, mostBound] of [
    ['ESeries', { periodMs: 8 }, 2.2, 5], ['At500Hz', { periodMs: 2 }, 2, 4.5], ['Cb3', { sendMs: 8, assumedMs: 8 }, 3.5, 11],
    ['PromptController', { sendMs: 0 }, 0.4, 5], ['SlowWifi', { minDelayMs: 3, jitterMs: 40 }, 5.5, 14], ['ThinnedTo20Hz', { periodMs: 50 }, 2.5, 9],
    ['FastClock', { ppm: 500 }, 2.2, 5], ['SlowClock', { ppm: -500 }, 2.2, 5],
  ])
    it(`Clock_${what}_ErrorIsWithinItsBound`, () => {
      for (let seed = 1; seed <= 20; seed++) {
        const link = new Link({ seed, ...options });
        for (let second = 2; second <= 30; second++) {
          link.play(1000 * second);
          const { error, bound } = link.reading();
          assert.ok(Math.abs(error) <= bound, `seed ${seed}: error ${error} ms, bound ${bound} ms`);
          assert.ok(Math.abs(error) < mostError, `seed ${seed}: wrong by ${error} ms`);
          assert.ok(bound < mostBound, `seed ${seed}: bound ${bound} ms`);
        }
        assert.deepEqual(link.stepped, [], `seed ${seed}`);
      }
    });

  it('Clock_SomePackagesSentLate_IsNotMeasuredAgain', () => {
    for (let seed = 1; seed <= 20; seed++) {
      const link = new Link({ seed, lateShare: 0.1 });
      for (let ms = 2000; ms <= 30_000; ms += 100) {
        link.play(ms);
        const { error } = link.reading();
        assert.ok(Math.abs(error) < 2.5, `seed ${seed}: wrong by ${error} ms`);
      }
      assert.deepEqual(link.stepped, [], `seed ${seed}`);
    }
  });

  it('Clock_AssumedSendDelayTooSmall_ErrorExceedsTheBound', () => {
    const wrong = Array.from({ length: 20 }, (_, i) => {
      const link = new Link({ seed: i + 1, sendMs: 0, minDelayMs: 0.01, jitterMs: 0.02, assumedMs: 0 });
      // The controller sends all packages 5 ms late, which the adapter cannot observe.
      link.truth = at => at * (1 + link.ppm / 1e6) + link.aheadMs + 5 * (at % link.periodMs > 1e-9 ? 1 : 0);
      link.play(5000);
      const { error, bound } = link.reading();
      return Math.abs(error) > bound;
    });

    assert.ok(wrong.every(isWrong => isWrong));
  });

  for (const by of [-3000, -20, 20, 3000])
    it(`Clock_SteppedBy${by}Ms_IsMeasuredAgain`, () => {
      for (let seed = 1; seed <= 10; seed++) {
        const link = new Link({ seed });
        link.play(5000);
        link.aheadMs += by;
        link.play(7000);

        const { error, bound } = link.reading();
        assert.ok(Math.abs(error) <= bound && bound < 5, `seed ${seed}: error ${error} ms, bound ${bound} ms`);
        assert.ok(Math.abs(link.stepped.reduce((sum, step) => sum + step, 0) - by) < 5, `seed ${seed}: ${link.stepped}`);
      }
    });

  it('Clock_WithoutAnswers_ErrorStaysWithinItsBound', () => {
    for (let seed = 1; seed <= 10; seed++) {
      const link = new Link({ seed, answers: false, ppm: 300 });
      link.play(2000);
      link.clock.expectNoAnswers(ns(0.6));
      link.play(600_000);

      const { error, bound } = link.reading();
      // The bound consists of the send delay, the round-trip time, and the delay of the fastest package within a few seconds.
      assert.ok(Math.abs(error) <= bound && bound < 3.6, `seed ${seed}: error ${error} ms, bound ${bound} ms`);
    }
  });

  it('Clock_WithoutAnswersAndPackagesLateForSeconds_ErrorMostlyStaysWithinItsBound', () => {
    let held = 0, count = 0;
    for (let seed = 1; seed <= 10; seed++) {
      const link = new Link({ seed, answers: false });
      link.play(2000);
      link.clock.expectNoAnswers(ns(0.6));
      // In each period of 10 s, the packages of the first 8 s are late by 12 ms, so the lower bound decreases.
      for (let ms = 2000; ms <= 62_000; ms += 100) {
        link.minDelayMs = ms % 10_000 < 8000 ? 12 : 0.2;
        link.play(ms);
        const { error, bound } = link.reading();
        // The first period is not checked: only its end shows that the packages were late.
        if (ms < 10_000) continue;
        count++;
        if (Math.abs(error) <= bound) held++;
        assert.ok(bound < 14, `seed ${seed}: bound ${bound} ms`);
      }
      assert.deepEqual(link.stepped, [], `seed ${seed}`);
      link.minDelayMs = 0.2;
      link.play(400_000);
      assert.ok(link.reading().bound < 3.6, `seed ${seed}: bound ${link.reading().bound} ms`);
    }
    assert.ok(held > 0.99 * count, `${held} of ${count}`);
  });

  for (const by of [-2000, 2000])
    it(`Clock_WithoutAnswersSteppedBy${by}Ms_IsMeasuredAgain`, () => {
      const link = new Link({ seed: 3, answers: false });
      link.play(2000);
      link.clock.expectNoAnswers(ns(0.6));
      link.play(4000);
      link.aheadMs += by;
      link.play(6000);

      const { error } = link.reading();
      assert.ok(Math.abs(error) < 3, `wrong by ${error} ms`);
      assert.equal(link.stepped.length, 1);
    });

  it('Clock_RobotSendsNoData_ThrowsAnError', () => {
    const link = new Link({ seed: 1 });
    assert.throws(() => link.clock.at(0n), { message: rtdeMessages.noData });
    link.play(3000);

    assert.throws(() => link.clock.at(4200n * MS), { message: rtdeMessages.noData });
  });
});

// Tests the code of the control clock, and the clock of the page that shows it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { load } from './vlcParts.mjs';

const { controlCells } = await load('code');
const { ControlClock } = await load('controlClock');
const { grainOf } = await load('grain');
const { Monitor } = await load('monitor');

describe('the delay of a monitor', () => {
  it('covers the fastest case and that of one more frame', () => {
    const monitor = new Monitor();
    for (let i = 0; i < 60; i++) monitor.frame((1000 * i) / 60);
    const { mean, maxError } = monitor.delayMs;

    // The start of a refresh, the middle of the scan, and half of the visible time before and after it.
    const [first, last] = [1.5, 3.5].map(refreshes => (1000 * refreshes) / 60);
    assert.ok(mean - maxError <= first + 1e-9 && mean + maxError >= last - 1e-9, `${mean} ± ${maxError} ms`);
  });
});

const text = cells => cells.map(Number).join('');

describe('the code and its clock', () => {
  it('draws the codes of the vector file', () => {
    const file = new URL('../../Packages/com.nowpose.mril/Documentation~/led-matrix/timestamp-codes.csv', import.meta.url);
    const [, ...lines] = readFileSync(file, 'utf8').trim().split('\n');
    const controls = lines.map(line => line.split(',')).filter(([, kind]) => kind === 'control');

    assert.ok(controls.length > 100);
    for (const [value, , rows] of controls) {
      const bits = BigInt(`0x${rows}`).toString(2).padStart(64, '0');
      assert.equal(text(controlCells(Number(value))), bits, `${value} ms`);
    }
  });

  // The round-trip time is 2 ms, and the control clock is 5000 s ahead.
  const exchange = { t1: 100, t4: 102, t2: 5_000_101_000_000n, t3: 5_000_101_000_000n, resolutionNs: 1 };
  const clockWith = (grainMs, ...exchanges) => exchanges.reduce((clock, e) => (clock.add(e), clock), new ControlClock(grainMs));

  /** Returns the control time minus 5000 s, ms, and its error bound. */
  const shown = (clock, now) => {
    const { ns, boundMs } = clock.at(now);
    return [Number(ns - 5_000_000_000_000n) / 1e6, boundMs].map(ms => Math.round(ms * 1000) / 1000);
  };

  it('assumes equal delays in both directions', () => {
    assert.deepEqual(shown(clockWith(0, exchange), 102), [102, 1]);
  });

  it('adds half the resolution of the control clock to the time and to the bound', () => {
    assert.deepEqual(shown(clockWith(0, { ...exchange, resolutionNs: 20_000_000 }), 102), [112, 11]);
  });

  it('intersects exchanges whose resolutions differ', () => {
    const late = { t1: 200, t4: 202, t2: 5_000_200_000_000n, t3: 5_000_200_000_000n, resolutionNs: 20_000_000 };

    const [ms, boundMs] = shown(clockWith(0, { ...exchange, resolutionNs: 20_000_000 }, late), 202);

    // The control clock is ahead of the page's clock by 5000 s − 1 ms (bound of the first exchange) to 5000 s + 20 ms (bound of the second one).
    // Since the first exchange, the skew can have added 0.05 ms.
    assert.ok(Math.abs(ms - 211.5) < 0.06 && Math.abs(boundMs - 10.5) < 0.06, `${ms} ± ${boundMs} ms`);
  });

  for (const grainMs of [0.1, 1]) {
    it(`adds its own clock's resolution of ${grainMs} ms to the bound`, () => {
      assert.deepEqual(shown(clockWith(grainMs, exchange), 102), [102, 1 + grainMs]);
    });
  }

  it('estimates a clock with a resolution of 1 ms and keeps all exchanges', () => {
    const clock = new ControlClock(1), truth = 5_000_000;
    let count = 0;
    for (let ms = 0.37; ms < 5000; ms += 61.7, count++) {
      const [t2, t3, t4] = [ms + 0.1, ms + 0.6, ms + 0.7].map((at, i) => (i < 2 ? BigInt(Math.round((truth + at) * 1e6)) : Math.floor(at)));
      clock.add({ t1: Math.floor(ms), t2, t3, t4, resolutionNs: 1 });
    }

    const { ns, boundMs } = clock.at(5000);
    const error = Number(ns) / 1e6 - truth - 5000;

    assert.equal(clock.count, count);
    assert.ok(Math.abs(error) <= boundMs && boundMs < 2, `error ${error} ms, bound ${boundMs} ms`);
  });

  it('discards earlier exchanges when the control clock steps', () => {
    const clock = clockWith(0.1, exchange), later = { ...exchange, t1: 200, t4: 202 };

    const hasStepped = clock.add({ ...later, t2: exchange.t2 + 120_000_000n, t3: exchange.t3 + 120_000_000n });

    assert.equal(hasStepped, true);
    assert.equal(clock.at(202), null);
  });

  /** A clock with a resolution of `stepMs` that advances by 0.01 ms with each reading. One reading is delayed by 40 ms. */
  const cut = stepMs => {
    let looks = 0;
    return () => {
      looks += looks === 30 ? 4000 : 1;
      return Math.floor(looks * 0.01 / stepMs) * stepMs;
    };
  };
  for (const [stepMs, grainMs] of [[0.005, 0.1], [0.1, 0.1], [1, 1], [16, 16]]) {
    it(`measures a clock's resolution of ${stepMs} ms`, () => {
      assert.ok(Math.abs(grainOf(cut(stepMs)) - grainMs) < 1e-9);
    });
  }
});

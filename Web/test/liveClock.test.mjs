// Tests the page's estimate of the control time from the responses of the gateway.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { buildSync } from 'esbuild';

const source = fileURLToPath(new URL('../src/operations/liveClock.ts', import.meta.url));
const { outputFiles } = buildSync({ entryPoints: [source], bundle: true, write: false, format: 'esm' });
const { LiveClock } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

describe('the estimated control time', () => {
  it('is that of the response with the smallest delay of the last 10 s', () => {
    const clock = new LiveClock();
    [0.1, 0.02, 0.3, 0.05].forEach((delay, i) => clock.add(1000 + i / 2, i / 2 + delay, 0));

    assert.ok(Math.abs(clock.at(2) - (1002 - 0.02)) < 1e-9);
    clock.add(1012, 12.2, 0);
    assert.ok(Math.abs(clock.at(12.2) - 1012) < 1e-9, 'older responses do not count');
  });

  for (const step of [-1.2, 1.2, -100, 100]) it(`follows a step of the control clock by ${step} s at once`, () => {
    const clock = new LiveClock();
    for (let now = 0; now < 5; now += 0.5) clock.add(1000 + now, now, 0);

    clock.add(1005 + step, 5, 1);

    assert.equal(clock.at(5), 1005 + step);
  });

  it('follows another clock whose steps are not counted', () => {
    const clock = new LiveClock();
    clock.add(1000, 0, null);

    clock.add(7, 0.5, null);

    assert.equal(clock.at(0.5), 7);
  });
});

// Tests in virtual time how an adapter reads the control clock from its gateway.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';
import { seeded } from './seeded.mjs';

const { GatewayClock, OfferedClock } = await parts('clock/gatewayClock', 'clock/offeredClock');
const MS = 1_000_000n, S = 1000n * MS, T = 1_700_000_000n * S;

const us = number => BigInt(Math.round(number)) * 1000n;

/** Reads the gateway's clock once a second. The control clock is ahead of this machine's counter and faster than the counter by `ppm`. */
function read({ ppm = 0n, seed = 1, seconds = 60, trip = random => us(200 + 3000 * random() ** 2) } = {}) {
  const random = seeded(seed), time = { now: 0n };
  const clock = new GatewayClock({}, () => time.now), control = at => T + at + (at * ppm) / 1_000_000n;
  for (let i = 0; i < seconds; i++) {
    const asked = BigInt(i) * S, up = trip(random), down = trip(random);
    clock.observe(control(asked + up), asked, asked + up + down);
    time.now = asked + up + down;
  }
  return { clock, control, time };
}

const size = ns => (ns < 0n ? -ns : ns);

describe('clock of the gateway', () => {
  it('Now_BeforeTheFirstReading_IsUnknown', () => assert.equal(new GatewayClock({}, () => 0n).now, null));

  for (const ppm of [0n, -200n, 200n])
    for (const seed of [1, 2, 3])
      it(`Now_Skew${ppm}ppm_Seed${seed}_ErrsByLessThanTheFastestRoundTrip`, () => {
        const { clock, control, time } = read({ ppm, seed });

        // The bounds include 0.7 ms for the maximum skew in the second between two readings.
        assert.ok(size(clock.now - control(time.now)) < MS, `${clock.now - control(time.now)} ns`);
      });

  it('Now_AsymmetricDelays_ErrsByAtMostHalfTheRoundTrip', () => {
    const asked = 0n, heard = 10n * MS, clock = new GatewayClock({}, () => heard);

    clock.observe(T, asked, heard);

    assert.equal(clock.now - (T + heard), -5n * MS);
  });

  it('Now_ControlClockSteps_FollowsTheNextReading', () => {
    const { clock, time } = read();

    clock.observe(T + 3600n * S, time.now, time.now + MS);

    assert.equal(clock.now, T + 3600n * S - MS / 2n);
  });

  for (const [step, isReported] of [[3600n * S, true], [-3600n * S, true], [S / 2n, false]])
    it(`Stepped_By${step / MS}ms_Is${isReported ? '' : 'Not'}Reported`, () => {
      let steps = 0;
      const clock = new GatewayClock({}, () => 0n, () => { steps++; });
      for (let i = 0n; i < 10n; i++) clock.observe(T + i * S, i * S, i * S + MS);

      clock.observe(T + 10n * S + step, 10n * S, 10n * S + MS);
      clock.observe(T + 11n * S + step, 11n * S, 11n * S + MS);

      assert.equal(steps, isReported ? 1 : 0);
    });

  it('PlantClock_PlantHasNoClock_ReadsTheClockOfTheGateway', async () => {
    const time = { now: 5n * S }, stop = new AbortController();
    const gateway = { offer: () => {}, call: async () => ({ time: { sec: Number(T / S), nanosec: 0 } }) };
    const clock = new OfferedClock(gateway, 'cell', MS, () => time.now);
    assert.deepEqual([clock.isSettled, clock.now], [false, null]);

    await clock.doWithout(stop.signal);

    assert.deepEqual([clock.isSettled, clock.now], [true, T]);
    await clock.attach(async () => ({ received: T + S, sent: T + S, resolution: 1n }), stop.signal);
    assert.equal(clock.now, T + S);
    clock.detach();
    assert.equal(clock.now, null);
    stop.abort();
  });

  it('PlantClock_GatewayNotConnected_IsUnknown', async () => {
    const stop = new AbortController(), clock = new OfferedClock({ offer: () => {}, call: async () => { throw new Error('away'); } }, 'cell');

    const known = clock.doWithout(stop.signal);
    stop.abort();
    await known;

    assert.equal(clock.now, null);
  });
});

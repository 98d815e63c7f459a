// Tests the comparison of source timestamps with the server's time stamps.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';
import { seeded } from '../seeded.mjs';

const { StampComparison } = await parts('opcua/stampComparison');
const { stampsAhead, stampsBehind } = messages.opcuaMessages;
const MS = 1_000_000n, T = 1_700_000_000_000n * MS;

describe('source timestamps', () => {
  /** Compares the time stamps of a change every 100 ms, whose source timestamps have these ages. Returns the reports. */
  const reports = (seconds, ageMs, everyMs = 100, clockAheadMs = 40n) => {
    const found = [], comparison = new StampComparison(text => found.push(text));
    for (let ms = 0; ms <= seconds * 1000; ms += everyMs) {
      const server = T + BigInt(ms) * MS;
      comparison.add(server - BigInt(Math.round(ageMs(ms) * 1e6)), server, server + clockAheadMs * MS);
    }
    return found;
  };

  for (const [name, ageMs, expected] of [
    ['OfTheServersClock', random => 10 * random, null],
    ['EqualToTheServers', () => 0, null],
    ['AheadByRounding', random => -1 + random, null],
    ['OfASourceThatIsSampledSeldom', random => 200 * random, null],
    ['AheadOfTheServer', random => -150 + 10 * random, stampsAhead(140)],
    ['BehindTheServer', random => 150 + 10 * random, stampsBehind(150)],
  ])
    it(`Stamps_${name}_${expected === null ? 'AreNotReported' : 'AreReported'} (seed 1)`, () => {
      const random = seeded(1), kind = text => text?.replace(/[0-9.]+ ms/, '') ?? null;

      assert.deepEqual(reports(6, () => ageMs(random())).map(kind), [kind(expected)]);
    });

  it('Stamps_SourceCorrected_EndsTheReport', () =>
    assert.deepEqual(reports(11, ms => (ms < 5500 ? 150 : 0)), [stampsBehind(150), null]));

  // A server that does not stamp with its CurrentTime, which headsets use.
  it('Stamps_ServersAreOfAnotherClock_AreNotCompared', () => assert.deepEqual(reports(8, () => 150, 100, 60_000n), []));

  it('Stamps_FewChanges_AreNotCompared', () => assert.deepEqual(reports(8, () => 150, 1000), []));

  it('Stamps_Missing_AreNotCompared', () => {
    const comparison = new StampComparison(() => assert.fail('compared'));

    for (let i = 0n; i < 100n; i++) {
      comparison.add(null, T + 100n * i * MS, T + 100n * i * MS);
      comparison.add(T + 100n * i * MS, null, T + 100n * i * MS);
      comparison.add(T, T + 100n * i * MS, null);
    }
  });
});

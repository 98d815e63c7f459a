import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DataType, DataValue, StatusCodes, Variant } from './library.mjs';
import { parts } from '../parts.mjs';

const { NotificationReader, TimeVariable } = await parts('opcua/notificationReader', 'opcua/timeVariable');

const START = 1_700_000_000_000;

/** Creates a time variable with one notification per list of labels. The time of a label is twice the label. */
function timeVariable(...notifications) {
  const variable = new TimeVariable(500n);
  for (const labels of notifications) variable.learn(labels.map(label => ({ label: BigInt(label), time: 2n * BigInt(label) })));
  return variable;
}

const every1000 = (from, count) => Array.from({ length: count }, (_, i) => from + 1000 * i);

describe('time variable', () => {
  it('At_TimeStampNearACycle_ReturnsTheTimeOfTheCycle', () => {
    const variable = timeVariable([1000, 2000], [3000]);

    assert.deepEqual([500n, 1400n, 1500n, 1501n, 2000n, 3500n].map(label => variable.at(label)), [2000n, 2000n, 2000n, 4000n, 4000n, 6000n]);
  });

  it('At_TimeStampFarFromAllCycles_ReturnsNull', () =>
    assert.deepEqual([499n, 2501n, 9000n].map(label => timeVariable([1000], [2000]).at(label)), [null, null, null]));

  it('At_CyclesOfTheNewestTwoNotifications_ReturnsTheirTimes', () => {
    const variable = timeVariable(every1000(0, 200), [], every1000(200_000, 200), [], every1000(400_000, 200), []);

    assert.deepEqual([199_000n, 200_000n, 399_000n, 400_000n, 599_000n].map(label => variable.at(label)), [null, 400_000n, 798_000n, 800_000n, 1_198_000n]);
  });

  it('At_ManyShortNotifications_ReturnsTheTimesOf64Cycles', () => {
    const variable = timeVariable(...every1000(0, 100).map(label => [label]));

    assert.deepEqual([variable.at(35_000n), variable.at(36_000n)], [null, 72_000n]);
  });

  it('At_ServerClockSetBack_ReturnsTheTimesOfTheNewCycles', () => {
    const variable = timeVariable(every1000(1_000_000, 100), every1000(0, 2), every1000(2000, 1));

    assert.deepEqual([variable.at(1000n), variable.at(2000n), variable.at(1_050_000n)], [2000n, 4000n, null]);
  });
});

describe('values with the time of a variable', () => {
  for (const [samplingMs, publishingMs] of [[10, 1000], [1, 1000]])
    it(`Values_SampledEvery${samplingMs}MsAndPublishedEvery${publishingMs}Ms_AllHaveTheirTime`, () => {
      const found = [], output = { publish: values => found.push(...values), hold: () => {} }, refused = [];
      const context = { configuration: { values: [{ address: { node: 'a' } }] }, output, status: { refuse: reason => refused.push(reason) }, clock: { now: null } };
      const reader = new NotificationReader(context, { time: { node: 'time', unit: null }, timestamp: 'variable', groupMs: 0.5 });
      const value = (node, dataType, number, ms) => ({ node, value: new DataValue({ value: new Variant({ dataType, value: number }), statusCode: StatusCodes.Good, sourceTimestamp: new Date(START + ms) }) });

      for (let from = 0; from < 3 * publishingMs; from += publishingMs) {
        const cycles = Array.from({ length: publishingMs / samplingMs }, (_, i) => from + i * samplingMs);
        reader.read([...cycles.map(ms => value(0, DataType.Double, ms, ms)), ...cycles.map(ms => value(1, DataType.DateTime, new Date(ms), ms))]);
      }

      assert.equal(found.length, 3 * publishingMs / samplingMs);
      assert.deepEqual(found.filter(({ value, stamp }) => stamp !== BigInt(value) * 1_000_000n), []);
      assert.deepEqual(refused, []);
    });
});

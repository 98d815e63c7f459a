// Tests in virtual time how the adapter treats nodes that are deleted or have a Bad status for a time, and are then usable again.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DataType, DataValue, StatusCodes, Variant } from './opcua/library.mjs';
import { parts } from './parts.mjs';

const { SilentNodes, NotificationReader, AdapterStatus, Log, PlantOutput } = await parts(
  'opcua/silentNodes', 'opcua/notificationReader', 'gateway/status', 'log', 'samples/plantOutput');

const START = 1_700_000_000_000, ofMs = ms => BigInt(ms) * 1_000_000n;

const good = (value, ms) => new DataValue({ value: new Variant({ dataType: DataType.Double, value }), statusCode: StatusCodes.Good, sourceTimestamp: new Date(ms) });
const bad = statusCode => new DataValue({ statusCode });

/** Simulates a server with one node, and an adapter that reads it with notifications and read requests. `now` is the time in ms on all clocks. */
function adapter() {
  const cell = { now: START };
  const status = new AdapterStatus('opcua', new Log('plant/test', [], () => {})), sent = [];
  const label = 'joint a', joint = { joint: 'a', robot: '', name: 'a', scale: 1, offset: 0 };
  const configuration = { joints: [joint], frames: [], wholeFrames: [], signals: [], values: [{ label, address: { node: 'n0' }, path: ['joints', 0] }] };
  const clock = { get now() { return ofMs(cell.now); }, isSettled: true };
  const output = new PlantOutput(configuration, { tolerance: 1_000_000n, oldest: 10_000_000_000n }, clock,
    { publish: (topic, msg) => sent.push(msg), publishNewest: () => {}, publishKept: () => {}, forgetKept: () => {} }, status, () => cell.now);
  const reader = new NotificationReader({ configuration, output, status, clock }, { time: null, timestamp: 'source', groupMs: 0.5 });
  Object.assign(cell, { status, reader, sent, value: good(1, cell.now) });
  status.enter('connected');
  cell.connect = () => {
    reader.restart();
    cell.nodes = new SilentNodes({ readAll: async () => [cell.value], monitorAgain: async () => null }, reader, ['0'], () => 'joints[0].node', () => cell.now);
  };
  cell.notify = value => {
    cell.value = value;
    cell.nodes.heard([{ node: 0, value }]);
    reader.read([{ node: 0, value }]);
  };
  cell.look = async () => {
    cell.now += 500;
    reader.holdNodes(ofMs(cell.now - 50), await cell.nodes.read());
  };
  cell.connect();
  cell.notify(cell.value);
  return cell;
}

const gone = bad(StatusCodes.BadNodeIdUnknown);

describe('deletions of nodes', () => {
  for (const [found, report] of [
    ['ByARead', async cell => {
      cell.value = gone;
      await cell.look();
      await cell.look();
    }],
    ['ByANotification', async cell => {
      cell.notify(gone);
      await cell.look();
    }],
    ['ByAReadThenByANotification', async cell => {
      cell.value = gone;
      await cell.look();
      cell.notify(gone);
    }],
    ['ByAReadInTwoConnections', async cell => {
      cell.value = gone;
      await cell.look();
      cell.connect();
      await cell.look();
    }],
  ]) {
    it(`Deletion_Found${found}_IsCountedOnce`, async () => {
      const cell = adapter();

      await report(cell);

      assert.equal(Number(cell.status.values()['refused/node-gone']), 1);
      assert.match(cell.status.values()['joint/a'], /^fault /);
    });
  }

  it('Deletion_AfterTheNodeWasRestored_IsCountedAgain', async () => {
    const cell = adapter();
    cell.value = gone;
    await cell.look();

    cell.notify(good(2, cell.now));
    cell.value = gone;
    await cell.look();

    assert.equal(Number(cell.status.values()['refused/node-gone']), 2);
  });
});

describe('values with a Bad status', () => {
  for (const [time, ageMs, status] of [
    ['AtTheStart', 3_600_000, StatusCodes.BadWaitingForInitialData],
    ['Later', 0, StatusCodes.BadSensorFailure],
  ])
    it(`GoodValue_WithTheStampOfBeforeABadStatus${time}_IsAtRestAndRepeated`, async () => {
      const cell = adapter(), value = good(1, cell.now - ageMs);
      cell.connect();
      if (ageMs === 0) await cell.look();
      cell.notify(bad(status));
      await cell.look();
      const refused = cell.status.values()['joint/a'], before = cell.sent.length;

      cell.notify(value);
      await cell.look();

      assert.match(refused, /^refused /);
      assert.match(cell.status.values()['joint/a'], /^rest /);
      assert.deepEqual([cell.sent.length - before, cell.sent.at(-1).position], [1, [1]]);
    });
});

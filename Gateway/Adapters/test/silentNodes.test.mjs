// Tests in virtual time how silent nodes are read, for each way in which servers treat a deleted node.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DataType, DataValue, StatusCodes, Variant } from './opcua/library.mjs';
import { parts } from './parts.mjs';
import { messages } from './messages.mjs';

const { nodeMessages } = messages;

const { SilentNodes } = await parts('opcua/silentNodes');

const good = (value, ms) => new DataValue({
  value: new Variant({ dataType: DataType.Double, value }), statusCode: StatusCodes.Good, sourceTimestamp: ms === undefined ? null : new Date(ms),
});
const bad = statusCode => new DataValue({ statusCode });

/** Simulates a server with two nodes. `answers` are its responses to a read of these nodes. */
function server(answers = [good(1), good(2)]) {
  const cell = { answers, now: 0, asked: [], lost: [], refused: [], renewed: [], refusal: null, ended: new Set() };
  cell.nodes = new SilentNodes(
    {
      readAll: async ids => {
        cell.asked.push(ids);
        return ids.map(id => cell.answers[Number(id)]);
      },
      monitorAgain: async node => {
        cell.renewed.push(node);
        return cell.refusal;
      },
    },
    { map: { nodes: ['n0', 'n1'] }, lose: (node, { reason, text }) => cell.lost.push([node, reason, text]), refuse: (node, { reason }) => cell.refused.push([node, reason]), expectFirst: () => {}, hasEnded: node => cell.ended.has(node) },
    ['0', '1'], node => `joints[${node}].node`, () => cell.now);
  cell.hear = (node, value) => cell.nodes.heard([{ node, value }]);
  cell.look = async () => {
    cell.now += 500;
    return [...await cell.nodes.read()];
  };
  cell.hear(0, good(1));
  cell.hear(1, good(2));
  return cell;
}

describe('silent nodes', () => {
  it('Node_RecentlyNotified_IsNotRead', async () => {
    const cell = server();
    cell.now = 300;
    cell.hear(1, good(2));

    const unchanged = await cell.look();

    assert.deepEqual([cell.asked, unchanged], [[['0', '1']], [0, 1]]);
    cell.hear(0, good(3));
    cell.now -= 450;
    await cell.look();
    assert.deepEqual(cell.asked[1], ['1']);
  });

  it('Node_SilentForLessThanTheIntervalsOfTheServer_IsNotRead', async () => {
    const cell = server();
    cell.nodes.silentMs = 1000;

    const looks = [await cell.look(), await cell.look()];

    assert.deepEqual([looks, cell.asked], [[[], [0, 1]], [['0', '1']]]);
  });

  it('Node_ReadReturnsUnknown_IsLostOnceAndMonitoredAgainWhenRestored', async () => {
    const cell = server();
    cell.answers[0] = bad(StatusCodes.BadNodeIdUnknown);

    const during = [await cell.look(), await cell.look()];
    cell.answers[0] = good(1);
    await cell.look();

    assert.deepEqual(during, [[1], [1]]);
    assert.deepEqual(cell.lost, [[0, 'node-gone', nodeMessages.gone('joints[0].node', 'n0', 'BadNodeIdUnknown')]]);
    assert.deepEqual(cell.renewed, [0]);
  });

  it('Node_NotificationReportsItLost_IsMonitoredAgainWhenRestored', async () => {
    const cell = server();
    cell.hear(0, bad(StatusCodes.BadNodeIdInvalid));

    cell.answers[0] = bad(StatusCodes.BadNodeIdUnknown);
    await cell.look();
    cell.answers[0] = good(5);
    await cell.look();

    assert.deepEqual(cell.renewed, [0]);
  });

  it('Node_RestoredButMonitoringFails_IsMonitoredLater', async () => {
    const cell = server();
    cell.hear(0, bad(StatusCodes.BadNodeIdUnknown));
    cell.refusal = 'BadTooManyMonitoredItems';

    await cell.look();
    await cell.look();

    assert.deepEqual(cell.renewed, [0, 0]);
    assert.equal(cell.lost.at(-1)[1], 'not-monitored');
    assert.match(cell.lost.at(-1)[2], /BadTooManyMonitoredItems/);
  });

  it('Node_ValueChangesWithoutNotification_IsMonitoredAgainAfterTwoReads', async () => {
    const cell = server();
    cell.answers[0] = good(1.5);

    const first = await cell.look(), renewed = [...cell.renewed];
    await cell.look();

    assert.deepEqual([first, renewed, cell.renewed], [[1], [], [0]]);
  });

  it('Node_NotifiedDuringTheRead_IsNotSilent', async () => {
    const cell = server();
    const readAll = cell.nodes.session.readAll;
    cell.nodes.session.readAll = ids => {
      cell.hear(0, good(9));
      return readAll(ids);
    };

    assert.deepEqual(await cell.look(), [1]);
    assert.deepEqual(await cell.look(), [1]);
    assert.deepEqual(cell.renewed, []);
  });

  it('Node_StatusBadOnlyInARead_IsRefusedOnceThenMonitoredAgain', async () => {
    const cell = server();
    cell.answers[0] = bad(StatusCodes.BadSensorFailure);

    await cell.look();
    await cell.look();
    cell.answers[0] = good(1);
    await cell.look();

    assert.deepEqual([cell.refused, cell.renewed], [[[0, 'status-bad']], [0]]);
  });

  /** Reads the nodes `looks` times. If `isWritten` is true, the source writes the unchanged value of node 0 before each read. */
  async function atRest(cell, looks, isWritten) {
    for (let i = 0; i < looks; i++) {
      if (isWritten) cell.answers[0] = good(1, 1_000_000 + cell.now);
      await cell.look();
    }
  }

  it('StopOf_SourceStopsWritingOneNodeAtRest_IsAtRestForThatNodeOnly', async () => {
    const cell = server();
    cell.hear(0, good(1, 999_000));
    await atRest(cell, 20, true);
    assert.equal(cell.nodes.stopOf(0), null);

    await atRest(cell, 3, false);
    assert.equal(cell.nodes.stopOf(0), null, 'three intervals may pass');
    await atRest(cell, 1, false);

    assert.deepEqual([cell.nodes.stopOf(0), cell.nodes.stopOf(1), cell.renewed], ['at-rest', null, []]);
  });

  it('Node_OfAJointInFaultWrittenAgainUnchanged_IsMonitoredAgain', async () => {
    const cell = server();
    cell.hear(0, good(1, 999_000));
    await atRest(cell, 20, true);
    await atRest(cell, 10, false);
    cell.ended.add(0);

    await atRest(cell, 1, true);

    assert.deepEqual([cell.nodes.stopOf(0), cell.renewed], [null, [0]]);
    cell.ended.clear();
    cell.hear(0, good(1, 1_000_000 + cell.now));
    await atRest(cell, 3, true);
    assert.deepEqual(cell.renewed, [0]);
  });

  it('Read_Late_NeitherMonitorsNodesAgainNorCountsAsAStop', async () => {
    const cell = server();
    cell.hear(0, good(1, 999_000));
    await atRest(cell, 20, true);
    cell.now += 5000;

    await atRest(cell, 1, true);
    await atRest(cell, 10, false);

    assert.deepEqual([cell.nodes.stopOf(0), cell.renewed], [null, []], 'it was not written for 5 s before, too');
  });

  it('StopOf_SourceWritesAllNodesWhenOneChanges_IsNull', async () => {
    const cell = server();
    cell.hear(0, good(1, 999_000));
    for (let i = 0; i < 20; i++) {
      cell.hear(1, good(i, 1_000_000 + cell.now));
      await atRest(cell, 1, true);
    }

    await atRest(cell, 100, false);

    assert.equal(cell.nodes.stopOf(0), null);
  });

  it('StopOf_SourceStopsWritingAfterTheLastChange_IsAfterChange', async () => {
    const cell = server();
    cell.hear(0, good(1, 999_000));
    await atRest(cell, 20, true);

    cell.hear(0, good(2, 1_000_000 + cell.now));
    cell.answers[0] = good(2, 1_000_000 + cell.now);
    await atRest(cell, 5, false);

    assert.equal(cell.nodes.stopOf(0), 'after-change');
  });

  it('StopOf_SourceStampsOnlyChanges_IsNull', async () => {
    const cell = server();
    for (let i = 0; i < 20; i++) {
      cell.hear(0, good(i, 1_000_000 + cell.now));
      cell.answers[0] = good(i, 1_000_000 + cell.now);
      await atRest(cell, 3, false);
    }
    await atRest(cell, 100, false);

    assert.equal(cell.nodes.stopOf(0), null);
  });

  it('Node_ValueStaysNaN_CountsAsUnchanged', async () => {
    const cell = server([good(NaN), good(2)]);
    cell.hear(0, good(NaN));

    assert.deepEqual([await cell.look(), await cell.look(), cell.renewed], [[0, 1], [0, 1], []]);
  });
});

// Tests a server whose minimum intervals are longer than those that the adapter requests.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { until } from '../program.mjs';
import { adapterFor, OPEN, serverFor } from './plant.mjs';
import { messages } from '../messages.mjs';

const { opcuaMessages } = messages;

const JOINTS = ['arm_joint_1', 'arm_joint_2'].map(joint => ({ joint, node: `ns=1;s=${joint}` }));

describe('minimum intervals of an OPC UA server', { concurrency: 2 }, () => {
  for (const [minimumMs, plant, notice] of [
    [100, [], undefined],
    [500, [], opcuaMessages.slow(500, 500)],
    [500, ['sampling_ms: 500'], undefined],
  ])
    it(`Intervals_Minimum${minimumMs}MsAnd${plant.length}Entries_DoNotCauseReadsWhileTheJointsMove`, async t => {
      const server = await serverFor(t, { minimumMs });
      const { bridge, states } = await adapterFor(t, server, [...OPEN, ...plant], JOINTS);
      const count = (await states(4)).length, before = server.valueReads;

      await states(count + 8);

      // On a busy machine, a notification may be late, so that its node is read.
      const reads = server.valueReads - before;
      assert.ok(reads <= 2, `${reads} reads during ${bridge.jointStates.length - count} samples`);
      await until(() => bridge.state?.publishing_ms === String(minimumMs), () => JSON.stringify(bridge.state));
      assert.equal(bridge.state.notice, notice);
    });
});

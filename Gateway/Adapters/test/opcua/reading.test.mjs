import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { StatusCodes } from './library.mjs';
import { start, until } from '../program.mjs';
import { nanoseconds } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { adapterFor, configuration, OPEN, serverFor } from './plant.mjs';
import { ControlClock, YoubotServer } from './server.mjs';
import { messages } from '../messages.mjs';

const { nodeMessages, summaryMessages } = messages;

const HOUR_MS = 3_600_000;
const READS = ['GetEndpointsRequest', 'CreateSessionRequest', 'ActivateSessionRequest', 'CloseSessionRequest', 'ReadRequest',
  'CreateSubscriptionRequest', 'ModifySubscriptionRequest', 'DeleteSubscriptionsRequest', 'CreateMonitoredItemsRequest', 'DeleteMonitoredItemsRequest', 'PublishRequest',
  'OpenSecureChannelRequest', 'CloseSecureChannelRequest', 'TranslateBrowsePathsToNodeIdsRequest'];

/** Configured joint, index of the true value, and the tolerance of the data type in which the server sends the value. */
const ALL = [
  [{ joint: 'a', node: 'ns=1;s=arm_joint_2' }, 1, 1e-12],
  [{ joint: 'b', node: 'ns=1;s=axis_1_deg', unit: 'deg' }, 0, 1e-12],
  [{ joint: 'c', node: 'ns=1;s=encoder_2', scale: 1e-6 }, 1, 1e-6],
  [{ joint: 'd', node: 'ns=1;s=positions', index: 3 }, 3, 1e-12],
  [{ joint: 'e', node: 'ns=1;s=positions', index: 6, unit: 'm' }, 6, 1e-12],
  [{ joint: 'f', node: 'ns=1;s=gripper_mm', unit: 'mm' }, 5, 1e-9],
];
const JOINTS = ALL.map(([entries]) => entries);

/** Returns the largest difference between the published positions and the true positions of the robot at their time stamps. */
function worst(states, place, name = 'a') {
  const distances = states.filter(s => s.name.includes(name)).map(s =>
    Math.abs(s.position[s.name.indexOf(name)] - YoubotServer.truth(place, nanoseconds(s.header.stamp))));
  assert.ok(distances.length > 0);
  return Math.max(...distances);
}

describe('reading over OPC UA', () => {
  let server;
  const clock = new ControlClock({ offsetMs: HOUR_MS, ppm: 50 });
  before(async () => { server = await new YoubotServer({ clock }).start(); });
  after(() => server.stop());
  const spoilt = (test, spoil) => {
    server.spoil = spoil;
    test.after(() => { server.spoil = (_, sent) => sent; });
  };

  it('Joints_OfEveryDataType_HaveTheTruePositionAtTheirTimeStamp', async t => {
    const { bridge, states } = await adapterFor(t, server, OPEN, JOINTS);

    const seen = await states(50);
    // The server samples each variable with its own timer. On a busy machine, few of them are sampled in the same cycle.
    await until(() => bridge.jointStates.some(s => s.name.length === JOINTS.length), 'a message with all joints');

    for (const [{ joint }, place, tolerance] of ALL) assert.ok(worst(seen, place, joint) < tolerance, joint);
  });

  it('Values_SampledBetweenTwoPublishings_AllArrive', async t => {
    const { states } = await adapterFor(t, server, [...OPEN, 'publishing_ms: 200'], [JOINTS[0]]);

    const times = (await states(40)).map(s => nanoseconds(s.header.stamp));

    assert.ok(times.every((time, i) => i === 0 || time > times[i - 1]));
    // If one value of each publishing arrived, no gap would be shorter than the publishing interval.
    const gaps = times.slice(2).map((time, i) => Number(time - times[i + 1]) / 1e6);
    assert.ok(Math.min(...gaps) < 100, `${gaps}`);
  });

  it('PlantClock_Requested_IsBetweenRequestAndAnswer', async t => {
    const { bridge, states } = await adapterFor(t, server, OPEN, [JOINTS[0]]);
    await states(1);
    const earliest = clock.now;

    const { result, values } = await bridge.call('/nowpose/plant_time/cell');

    assert.equal(result, true, JSON.stringify(values));
    const [received, sent] = [values.received, values.sent].map(nanoseconds);
    // OPC UA encodes times with a resolution of 100 ns.
    assert.ok(received >= earliest - 100n && sent >= received && sent <= clock.now, `${earliest} ${received} ${sent}`);
    assert.deepEqual([values.resolution_ns, values.synchronised], [100, true]);
  });

  it('TimeVariable_Configured_StampsTheValuesOfItsCycle', async t => {
    // The server's own time stamps of the values and of the time variable are wrong by an hour.
    const wrong = date => new Date(date.getTime() - HOUR_MS);
    spoilt(t, (_, sent) => ({ ...sent, sourceTimestamp: wrong(sent.sourceTimestamp), serverTimestamp: wrong(sent.serverTimestamp) }));
    const { bridge, states } = await adapterFor(t, server, [...OPEN, 'time: {node: "ns=1;s=time_ns"}'], JOINTS);

    const seen = await states(20);

    for (const [{ joint }, place, tolerance] of ALL) assert.ok(worst(seen, place, joint) < tolerance, joint);
    const { values } = await bridge.call('/nowpose/plant_time/cell');
    assert.ok(Math.abs(Number(nanoseconds(values.sent) - clock.now)) < 60e9);
  });

  it('TimeVariable_StampedLaterThanTheValues_IsReportedWithGroupMs', async t => {
    // The server stamps the time variable 3 ms later than the other variables.
    spoilt(t, (name, sent) => name === 'time_ns' ? { ...sent, sourceTimestamp: new Date(sent.sourceTimestamp.getTime() + 3) } : sent);
    const plant = [...OPEN, 'time: {node: "ns=1;s=time_ns"}'];
    const narrow = await adapterFor(t, server, plant, [JOINTS[0]]), wide = await adapterFor(t, server, [...plant, 'group_ms: 4'], [JOINTS[0]]);

    await narrow.run.said(`a refused (time-unmatched): ${nodeMessages.noTimeOfCycle('ns=1;s=time_ns', '0.5')}`);

    assert.ok(worst(await wide.states(5), 1) < 1e-12);
    assert.deepEqual(narrow.bridge.jointStates, []);
  });

  it('Values_OfEachInvalidKind_AreRefusedWhileOthersStayLive', async t => {
    const later = (sent, ms) => ({ ...sent, sourceTimestamp: new Date(sent.sourceTimestamp.getTime() + ms) });
    const at = (sent, date) => ({ ...sent, sourceTimestamp: date, sourcePicoseconds: 0 });
    const cases = [
      ['stamp-missing', { node: 'ns=1;s=arm_joint_2' }, sent => at(sent, new Date(Date.UTC(1601, 0, 1)))],
      ['stamp-zero', { node: 'ns=1;s=arm_joint_3' }, sent => at(sent, new Date(0))],
      ['stamp-future', { node: 'ns=1;s=arm_joint_4' }, sent => later(sent, 5000)],
      ['stamp-old', { node: 'ns=1;s=arm_joint_5' }, sent => later(sent, -60_000)],
      ['status-bad', { node: 'ns=1;s=axis_1_deg' }, sent => ({ ...sent, statusCode: StatusCodes.BadNoCommunication })],
      ['status-uncertain', { node: 'ns=1;s=gripper_mm' }, sent => ({ ...sent, statusCode: StatusCodes.UncertainLastUsableValue })],
      ['not-finite', { node: 'ns=1;s=not_a_number' }],
      ['type', { node: 'ns=1;s=name' }],
      ['type', { node: 'ns=1;s=positions' }],
      ['type', { node: 'ns=1;s=time_s', index: 0 }],
      ['index', { node: 'ns=1;s=positions', index: 7 }],
    ];
    const spoils = new Map(cases.map(([, { node }, spoil]) => [node.split('=').at(-1), spoil]));
    spoilt(t, (variable, sent) => spoils.get(variable)?.(sent) ?? sent);
    const joints = cases.map(([, entries], i) => ({ joint: `wrong_${i}`, ...entries }));
    const { bridge, state, states, run } = await adapterFor(t, server, OPEN, [...joints, { joint: 'good', node: 'ns=1;s=arm_joint_1' }]);

    const seen = await states(10);
    const counts = await state(s => cases.every(([reason]) => Number(s[`refused/${reason}`]) > 1));

    assert.equal(counts.state, 'connected');
    assert.ok(bridge.jointStates.every(s => s.name.join() === 'good'), JSON.stringify(seen[0]));
    cases.forEach(([reason], i) =>
      assert.equal(run.err.split('\n').filter(line => line.includes(`wrong_${i} refused (${reason})`)).length, 1, `${reason}\n${run.err}`));
    const counted = Object.entries(counts).filter(([key]) => key.startsWith('refused/')).reduce((sum, [, count]) => sum + Number(count), 0);
    assert.equal(Number(counts.refused), counted);
  });

  it('Nodes_ServerMonitorsTwoNodesPerRequest_AreAllReadAtOnce', async t => {
    const limited = await serverFor(t, { itemsPerCall: 2 }), joints = [0, 1, 2, 3, 4];

    const { states, state } = await adapterFor(t, limited, OPEN, joints.map(i => ({ joint: `j${i}`, node: `ns=1;s=arm_joint_${i + 1}` })));

    const { reconnects } = await state(s => joints.every(i => s[`joint/j${i}`]?.startsWith('live'))), received = await states(20);
    assert.equal(reconnects, '0');
    for (const i of joints) assert.ok(worst(received, i, `j${i}`) < 1e-12, `joint ${i}`);
  });

  it('Node_Unknown_IsReportedWithItsLine', async t => {
    const { state, path } = await adapterFor(t, server, OPEN, [{ joint: 'z', node: 'ns=1;s=nowhere' }]);

    const { reason } = await state(s => s.state === 'refused');

    assert.equal(reason, nodeMessages.noneReadable(nodeMessages.unknown(`${path}, line 10: joints[0].node`, 'ns=1;s=nowhere', 'BadNodeIdUnknown')));
  });

  it('Node_UnknownBesideAKnownOne_IsMissingWhileTheOtherIsLive', async t => {
    const { states, state, path, bridge } = await adapterFor(t, server, OPEN, [JOINTS[0], { joint: 'z', node: 'ns=1;s=nowhere' }]);

    await states(5);
    await state(s => s.state === 'connected');

    const { state: found, reason } = bridge.joint('z');
    assert.equal(found, 'missing');
    assert.ok(reason.includes(nodeMessages.unknown(`${path}, line 12: joints[1].node`, 'ns=1;s=nowhere', 'BadNodeIdUnknown')), reason);
    assert.equal(bridge.status.level, 2);
  });

  it('Node_ThatIsNoVariable_KeepsTheReasonWithItsLine', async t => {
    const { states, path, bridge } = await adapterFor(t, server, OPEN, [JOINTS[0], { joint: 'z', node: 'ns=0;i=2253' }]);
    const text = nodeMessages.unknown(`${path}, line 12: joints[1].node`, 'ns=0;i=2253', 'BadAttributeIdInvalid');

    await until(() => bridge.joint('z')?.reason === text, () => bridge.state?.['joint/z']);
    // The node is read every 0.5 s, and the diagnostics are sent once a second.
    await states(200);

    assert.equal(bridge.joint('z').reason, text);
    const { 'reason/z': word, 'refused/node-gone': gone, 'refused/status-bad': bad } = bridge.state;
    assert.deepEqual([word, gone, bad], ['node-gone', '1', undefined]);
  });

  it('Node_WithNamespaceUri_IsFound', async t => {
    const uri = server.namespaces()[1];
    const { states } = await adapterFor(t, server, [...OPEN, `time: {node: "nsu=${uri};s=time_ns"}`], [
      { joint: 'a', node: `nsu=${uri};s=arm_joint_2` }, { joint: 'b', node: 'ns=1;s=axis_1_deg', unit: 'deg' }]);

    const seen = await until(async () => {
      const all = await states(5);
      return all.some(s => s.name.includes('a')) && all.some(s => s.name.includes('b')) && all;
    }, 'both joints');

    assert.ok(worst(seen, 1, 'a') < 1e-12 && worst(seen, 0, 'b') < 1e-12);
  });

  it('Node_UnknownNamespaceUri_IsReportedWithItsLineAndTheServersNamespaces', async t => {
    const { state, path } = await adapterFor(t, server, OPEN, [{ joint: 'z', node: 'nsu=urn:another:server;s=x' }]);

    const { reason } = await state(s => s.state === 'refused');

    const place = `${path}, line 10: joints[0].node`;
    const expected = nodeMessages.namespaces(nodeMessages.noNamespace(place, 'nsu=urn:another:server;s=x'), server.namespaces());
    assert.ok(reason.includes(expected), reason);
  });

  it('Server_ReadByAllTests_ReceivedNoWriteRequest', () => {
    assert.deepEqual([...server.asked.keys()].filter(name => !READS.includes(name)), []);
    assert.ok(server.asked.get('PublishRequest') > 100);
  });

  it('Clock_SetBackByAnHour_IsFollowed', async t => {
    const { bridge, states } = await adapterFor(t, server, OPEN, [JOINTS[0]]);
    await states(10);

    clock.step(-HOUR_MS);
    t.after(() => clock.step(HOUR_MS));
    const count = bridge.jointStates.length;
    const seen = (await states(count + 20)).slice(-10);

    assert.ok(seen.every(s => Math.abs(Number(nanoseconds(s.header.stamp) - clock.now)) < 5e9));
    assert.ok(worst(seen, 1) < 1e-12);
  });
});

describe('robot at rest', () => {
  // Simulates a server that changes the time stamp of a value only when the value changes.
  const resting = names => {
    const kept = new Map();
    return (name, sent) => {
      if (!names(name)) return sent;
      const ago = new Date(sent.sourceTimestamp.getTime() - HOUR_MS);
      if (!kept.has(name)) kept.set(name, { ...sent, sourceTimestamp: ago, serverTimestamp: ago });
      return kept.get(name);
    };
  };
  const stampsOf = (seen, joint) => seen.filter(s => s.name.includes(joint)).map(s => nanoseconds(s.header.stamp));
  const [moving, still] = [{ joint: 'a', node: 'ns=1;s=arm_joint_2' }, { joint: 'still', node: 'ns=1;s=arm_joint_3' }];

  for (const plant of [[], ['time: {node: "ns=1;s=time_ns"}']])
    it(`Joint_AtRest${plant.length > 0 ? 'BesideATimeVariable' : ''}_IsRepeatedWithNewStamps`, async t => {
      const server = await serverFor(t, { clock: new ControlClock({ offsetMs: HOUR_MS }) });
      server.spoil = resting(name => name === 'arm_joint_3');
      const from = server.clock.now, { bridge, run } = await adapterFor(t, server, [...OPEN, ...plant], [moving, still]);

      const stamps = await until(() => {
        const stamps = stampsOf(bridge.jointStates, 'still');
        return stamps.length >= 20 && stamps;
      }, () => JSON.stringify(bridge.state));

      const to = server.clock.now;
      assert.ok(stamps.every((stamp, i) => stamp > (stamps[i - 1] ?? from) && stamp < to));
      assert.equal(new Set(bridge.jointStates.filter(s => s.name.includes('still')).map(s => s.position[s.name.indexOf('still')])).size, 1);
      assert.ok(worst(bridge.jointStates, 1) < 1e-12);
      assert.doesNotMatch(run.err, /still refused/);
    });

  it('Robot_AtRest_IsPublishedAndReported', async t => {
    const server = await serverFor(t, { clock: new ControlClock({ offsetMs: HOUR_MS }) });
    server.spoil = resting(name => name.startsWith('arm_joint'));
    const from = server.clock.now, { bridge, states } = await adapterFor(t, server, OPEN, [moving, still]);

    const seen = await states(3);

    assert.ok(seen.every(s => s.name.join() === 'a,still'), JSON.stringify(seen));
    assert.ok(stampsOf(seen, 'still').every((stamp, i, all) => stamp > (all[i - 1] ?? from) && stamp < server.clock.now));
    assert.equal(bridge.state?.refused ?? '0', '0');
  });
});

describe('check', () => {
  it('Check_OpcUa_ListsEndpointSecurityAndTimes', async t => {
    const path = temporaryFile('plant.yaml', configuration('ws://127.0.0.1:1', 'opc.tcp://plc:4840', ['sampling_ms: 4', 'publishing_ms: 8'], JOINTS));
    const run = start(t, [path, '--check']);

    assert.equal(await run.ended, 0, run.err);
    assert.match(run.out, /OPC UA opc\.tcp:\/\/plc:4840, SignAndEncrypt, Basic256Sha256; /);
    assert.ok(run.out.includes(`${summaryMessages.stamps('the source time stamp', 4, 8)}; joints a, b`), run.out);
  });
});

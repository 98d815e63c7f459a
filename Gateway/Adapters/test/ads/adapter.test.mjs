import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { until } from '../program.mjs';
import { nanoseconds } from '../rosbridge.mjs';
import { assertMatchesPlc, cell, clockOf, jointIs, statesOf } from './cell.mjs';
import { command, group, state } from './frames.mjs';
import { Plc } from './plc.mjs';
import { PlcSymbol } from './symbols.mjs';
import { angle, opening, variables, youBot } from './youbot.mjs';

describe('ads', () => {
  it('Adapter_Notifications_GivePositionsAtTheirTimeStamps', async t => {
    const { bridge, server } = await cell(t, { plc: youBot({ cycleMs: 5, aheadMs: 40_000, ppm: 100 }) });

    const states = await statesOf(bridge, 100);

    // Time stamps truncated to milliseconds would cause errors of up to 0.9e-3 rad (1e-3 s times 0.9 rad/s).
    assertMatchesPlc(states);
    const stamps = states.map(s => nanoseconds(s.header.stamp));
    assert.ok(stamps.some(stamp => stamp % 1_000_000n !== 0n), 'stamps below a millisecond');
    assert.deepEqual(server.seen.filter(s => [command.write, command.writeControl].includes(s.command)), []);
    assert.ok(server.seen.filter(s => s.command === command.readWrite).every(s => s.group === group.infoByNameEx));
  });

  it('Adapter_UnitsAndTypes_AreConvertedToRadAndMetres', async t => {
    const joints = `  - { joint: a, symbol: MAIN.fAxis1, unit: deg }
  - { joint: b, symbol: MAIN.fAxis2, unit: deg, offset: 1 }
  - { joint: c, symbol: MAIN.nEncoder3, scale: 0.000001 }
  - { joint: d, symbol: MAIN.fGripper, unit: mm }
`;
    const { bridge } = await cell(t, { joints });

    const states = await statesOf(bridge, 20);

    const truth = { a: time => angle(0, time), b: time => angle(1, time) + 1, c: time => angle(2, time), d: opening };
    for (const { header, name, position } of states)
      name.forEach((joint, i) => {
        const expected = truth[joint](nanoseconds(header.stamp));
        assert.ok(Math.abs(position[i] - expected) < 2e-6, `${joint}: ${position[i]}, not ${expected}`);
      });
    assert.deepEqual([...new Set(states.flatMap(s => s.name))].sort(), ['a', 'b', 'c', 'd']);
  });

  for (const [symbol, unit, tolerance] of [
    ['GVL.nTime', 'ns', 1e-6], ['GVL.ftTime', undefined, 1e-6], ['GVL.fSeconds', 's', 1e-5],
    ['TwinCAT_SystemInfoVarList._TaskInfo[1].DcTaskTime', 'dctime', 1e-6],
  ])
    it(`Adapter_TimeIn${symbol.replace(/\W/g, '')}_IsUsedAsTimeStamp`, async t => {
      // The time stamps of the notifications are wrong by 3 s, so an adapter that uses them fails this test.
      const plc = youBot({ cycleMs: 5, stampOf: time => (time + 3_000_000_000n) / 100n + 116444736000000000n });
      const more = `  timestamp: variable\n  time: { symbol: "${symbol}"${unit ? `, unit: ${unit}` : ''} }\n`;
      const { bridge } = await cell(t, { plc, more });

      assertMatchesPlc(await statesOf(bridge, 40), tolerance);
    });

  for (const [kind, more] of [['Notification', ''], ['Variable', '  timestamp: variable\n  time: { symbol: GVL.nTime, unit: ns }\n']])
    it(`Clock_ReadFrom${kind}_IsBetweenRequestAndAnswer`, async t => {
      const CYCLE_NS = 5_000_000, plc = youBot({ cycleMs: CYCLE_NS / 1e6, aheadMs: -7000 });
      const { bridge, server } = await cell(t, { plc, more });
      await statesOf(bridge);
      await clockOf(bridge);

      for (let i = 0; i < 20; i++) {
        const before = plc.now(), { values } = await bridge.call('/nowpose/plant_time/cell'), after = plc.now();
        const { received, sent, resolution_ns, error_bound_ns, synchronised } = values;

        assert.deepEqual(received, sent);
        // On a busy machine, the readings may not show the cycle. The bound then contains it.
        if (kind === 'Variable') assert.ok(resolution_ns + error_bound_ns >= CYCLE_NS, `resolution ${resolution_ns}, bound ${error_bound_ns}`);
        else assert.ok(resolution_ns > 0 && resolution_ns <= 1_000_000 && error_bound_ns === 0, `resolution ${resolution_ns}, bound ${error_bound_ns}`);
        const late = BigInt(kind === 'Variable' ? resolution_ns + error_bound_ns + 100_000 : 0);
        assert.ok(nanoseconds(received) >= before - late && nanoseconds(received) <= after, `${before} ${nanoseconds(received)} ${after}`);
        assert.equal(synchronised, true);
      }
      // The adapter cancels the subscriptions with which it reads the clock.
      await until(() => server.notifications <= 8, () => `${server.notifications} notifications`);
    });

  for (const [kind, more] of [['Notification', ''], ['Variable', '  timestamp: variable\n  time: { symbol: GVL.nTime, unit: ns }\n']])
    it(`Clock_ReadFrom${kind}InPlantWithoutJoints_IsOffered`, async t => {
      const { bridge, plc } = await cell(t, { plc: youBot({ cycleMs: 5, aheadMs: -7000 }), more, joints: '  []\n' });
      await clockOf(bridge);

      const { values } = await bridge.call('/nowpose/plant_time/cell');

      assert.ok(Math.abs(Number(nanoseconds(values.sent) - plc.now())) < 3.5e9, JSON.stringify(values));
      await until(() => bridge.state?.state === 'connected', () => JSON.stringify(bridge.state));
      assert.deepEqual([bridge.jointStates, bridge.state.samples, bridge.state.refused], [[], '0', '0']);
    });

  it('Adapter_PublishingInterval_SendsAllSamplesInFewerMessages', async t => {
    const { bridge, server, plc } = await cell(t, { more: '  sampling_ms: 5\n  publishing_ms: 100\n' });

    const states = await statesOf(bridge, 80);

    const stamps = states.filter(s => s.name.includes('arm_joint_5')).map(s => nanoseconds(s.header.stamp));
    const packets = server.packetsOf(plc.find('GVL.aJoints[4]')), sent = packets.flat().filter(time => time >= stamps[0] && time <= stamps.at(-1));
    assert.deepEqual(stamps, sent);
    // A reading of the clock sends the waiting samples early, and a busy machine reads it more often than at each twentieth sample.
    assert.ok(packets.length * 2 <= packets.flat().length, `${packets.length} packets with ${packets.flat().length} samples`);
  });

  it('Adapter_OneJointAtRest_RepeatsItWithNewStamps', async t => {
    const plc = new Plc([...variables(), new PlcSymbol('MAIN.fStill', 'LREAL', () => 1.5)], { cycleMs: 5, aheadMs: 40_000 });
    const joints = '  - { joint: arm_joint_1, symbol: "GVL.aJoints[0]" }\n  - { joint: still, symbol: MAIN.fStill }\n';
    const { bridge } = await cell(t, { plc, more: '  on_change: true\n', joints });

    const told = await until(() => {
      const still = bridge.jointStates.filter(s => s.name.includes('still'));
      return still.length >= 10 && still;
    }, () => JSON.stringify(bridge.state));

    const stamps = told.map(s => nanoseconds(s.header.stamp));
    assert.ok(told.every(s => s.position[s.name.indexOf('still')] === 1.5));
    assert.ok(stamps.every((stamp, i) => i === 0 || stamp > stamps[i - 1]));
    assert.ok(stamps.at(-1) < plc.now());
  });

  it('Adapter_AllJointsAtRest_ReadsThemAndAssumesRest', async t => {
    const still = ['one', 'two'].map(name => new PlcSymbol(`MAIN.${name}`, 'LREAL', () => 1.5));
    const joints = '  - { joint: one, symbol: MAIN.one }\n  - { joint: two, symbol: MAIN.two }\n';
    const { bridge, server } = await cell(t, { plc: new Plc([...variables(), ...still], { cycleMs: 5 }), more: '  on_change: true\n', joints });
    // Reads the clock repeatedly, like a gateway.
    const asked = setInterval(() => void bridge.call('/nowpose/plant_time/cell').catch(() => {}), 200);
    t.after(() => clearInterval(asked));

    await jointIs(bridge, 'one', 'rest');
    const count = bridge.jointStates.length, reads = () => server.seen.filter(s => s.command === command.read && s.group === group.memory).length;
    const readBefore = reads();
    await until(() => bridge.jointStates.length > count + 20, 'joints at rest to be repeated');

    // Virtual-time tests check how often the adapter reads, and that it publishes what it has read.
    const repeated = bridge.jointStates.slice(count), stamps = repeated.filter(s => s.name.includes('one')).map(s => nanoseconds(s.header.stamp));
    assert.ok(repeated.every(s => s.position.every(position => position === 1.5)));
    assert.ok(stamps.every((stamp, i) => i === 0 || stamp > stamps[i - 1]), `${stamps}`);
    assert.ok(reads() > readBefore, 'the symbols are read');
    await until(() => bridge.status.level === 0, () => JSON.stringify(bridge.status));
  });

  it('Adapter_RouterOnThisMachine_UsesTheAddressThatTheRouterAssigns', async t => {
    const { bridge } = await cell(t, { local: '' });

    assertMatchesPlc(await statesOf(bridge, 20));
  });
});

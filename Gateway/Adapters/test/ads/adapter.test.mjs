import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check, start, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { seeded } from '../seeded.mjs';
import { temporaryFile } from '../temporary.mjs';
import { command, group, state } from './frames.mjs';
import { AdsServer } from './server.mjs';
import { Plc } from './plc.mjs';
import { PlcSymbol } from './symbols.mjs';
import { angle, opening, variables, youBot } from './youbot.mjs';

const NET_ID = '5.24.12.7.1.1';

const LOCAL = '  local_net_id: 192.168.0.10.1.1\n';

const configuration = ({ port, url, more = '', joints, local = LOCAL }) => `gateway:
  url: ${url}
plant:
  kind: ads
  name: cell
  endpoint: ads://127.0.0.1:${port}/${NET_ID}:851
${local}  plain: true
${more}joints:
${joints ?? [0, 1, 2, 3, 4].map(i => `  - joint: arm_joint_${i + 1}\n    symbol: GVL.aJoints[${i}]\n`).join('')}`;

/** A PLC, a gateway and an adapter between them. */
async function cell(t, { plc = youBot({ cycleMs: 5 }), more, joints, local, server: options } = {}) {
  const server = new AdsServer(plc, options), port = await server.listen();
  t.after(() => server.close());
  const bridge = await RosbridgeDouble.start(t);
  const path = temporaryFile('ads.yaml', configuration({ port, url: bridge.url, more, joints, local }));
  return { plc, server, bridge, port, path, adapter: start(t, [path]) };
}

const clockOf = bridge => until(async () => (await bridge.call('/nowpose/plant_time/cell')).result, 'the clock');

const statesOf = (bridge, count = 1) => until(
  () => bridge.jointStates.length >= count && bridge.jointStates, () => `${count} joint states; ${JSON.stringify(bridge.state)}`);

/** Asserts that each joint of each message is where the PLC had it at the message's stamp. The PLC decides which joints share a cycle. */
function assertTrue(states, tolerance = 1e-6) {
  for (const { header, name, position } of states)
    name.forEach((joint, i) => {
      const truth = angle(Number(joint.at(-1)) - 1, nanoseconds(header.stamp));
      assert.ok(Math.abs(position[i] - truth) < tolerance, `${joint} at ${JSON.stringify(header.stamp)}: ${position[i]}, not ${truth}`);
    });
  assert.deepEqual([...new Set(states.flatMap(s => s.name))].sort(), [1, 2, 3, 4, 5].map(i => `arm_joint_${i}`));
}

describe('ads', { concurrency: 4 }, () => {
  it('Adapter_Notifications_HaveThePositionAtTheirStamp', async t => {
    const { bridge, server } = await cell(t, { plc: youBot({ cycleMs: 5, aheadMs: 40_000, ppm: 100 }) });

    const states = await statesOf(bridge, 100);

    // A stamp truncated to a millisecond would cause errors of up to 1e-3 s times 0.9 rad/s.
    assertTrue(states);
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
    it(`Adapter_TimeIn${symbol.replace(/\W/g, '')}_BecomesTheStamp`, async t => {
      // The stamps of the notifications are wrong by 3 s, so an adapter that used them would fail this test.
      const plc = youBot({ cycleMs: 5, stampOf: time => (time + 3_000_000_000n) / 100n + 116444736000000000n });
      const more = `  timestamp: variable\n  time: { symbol: "${symbol}"${unit ? `, unit: ${unit}` : ''} }\n`;
      const { bridge } = await cell(t, { plc, more });

      assertTrue(await statesOf(bridge, 40), tolerance);
    });

  for (const [kind, more, coarsest] of [['Notification', '', 1_000_000], ['Variable', '  timestamp: variable\n  time: { symbol: GVL.nTime, unit: ns }\n', 5_000_000]])
    it(`Clock_${kind}_LiesBetweenRequestAndAnswer`, async t => {
      const plc = youBot({ cycleMs: 5, aheadMs: -7000 });
      const { bridge, server } = await cell(t, { plc, more });
      await statesOf(bridge);
      await clockOf(bridge);

      for (let i = 0; i < 20; i++) {
        const before = plc.now(), { values } = await bridge.call('/nowpose/plant_time/cell'), after = plc.now();
        const { received, sent, resolution_ns, error_bound_ns, synchronised } = values;

        assert.deepEqual(received, sent);
        assert.ok(resolution_ns > 0 && resolution_ns <= coarsest, `resolution ${resolution_ns}`);
        if (kind === 'Variable') assert.ok(resolution_ns >= 4_900_000, `resolution ${resolution_ns}`);
        const late = BigInt(kind === 'Variable' ? resolution_ns + 100_000 : 0);
        assert.ok(nanoseconds(received) >= before - late && nanoseconds(received) <= after, `${before} ${nanoseconds(received)} ${after}`);
        assert.deepEqual([error_bound_ns, synchronised], [0, true]);
      }
      // The subscriptions that read the clock are cancelled.
      await until(() => server.notifications <= 8, () => `${server.notifications} notifications`);
    });

  for (const [kind, more] of [['Notification', ''], ['Variable', '  timestamp: variable\n  time: { symbol: GVL.nTime, unit: ns }\n']])
    it(`Clock_${kind}WithoutJoints_IsOfferedWithoutSamples`, async t => {
      const { bridge, plc } = await cell(t, { plc: youBot({ cycleMs: 5, aheadMs: -7000 }), more, joints: '  []\n' });
      await clockOf(bridge);

      const { values } = await bridge.call('/nowpose/plant_time/cell');

      assert.ok(Math.abs(Number(nanoseconds(values.sent) - plc.now())) < 1e9, JSON.stringify(values));
      await until(() => bridge.state?.state === 'connected', () => JSON.stringify(bridge.state));
      assert.deepEqual([bridge.jointStates, bridge.state.samples, bridge.state.refused], [[], '0', '0']);
    });

  it('Adapter_PublishingInterval_SendsAllSamplesInFewerMessages', async t => {
    const { bridge } = await cell(t, { more: '  sampling_ms: 5\n  publishing_ms: 100\n' });

    const states = await statesOf(bridge, 80);

    const stamps = states.filter(s => s.name.includes('arm_joint_5')).map(s => nanoseconds(s.header.stamp));
    const steps = stamps.slice(1).map((stamp, i) => Number(stamp - stamps[i]) / 5e6);
    // A machine that sleeps longer than the double catches up leaves a gap. If intermediate samples were dropped, most steps would be gaps.
    assert.ok(steps.every(step => step > 0 && Number.isInteger(step)), `${steps}`);
    assert.ok(steps.filter(step => step === 1).length > 0.8 * steps.length, `${steps}`);
  });

  it('Adapter_OnChangeWithOneJointAtRest_RepeatsItOftenEnoughForAHeadset', async t => {
    const plc = new Plc([...variables(), new PlcSymbol('MAIN.fStill', 'LREAL', () => 1.5)], { cycleMs: 5, aheadMs: 40_000 });
    const joints = '  - { joint: arm_joint_1, symbol: "GVL.aJoints[0]" }\n  - { joint: still, symbol: MAIN.fStill }\n';
    const { bridge } = await cell(t, { plc, more: '  on_change: true\n', joints });

    const told = await until(() => {
      const still = bridge.jointStates.filter(s => s.name.includes('still'));
      return still.length >= 10 && still;
    }, () => JSON.stringify(bridge.state));

    const stamps = told.map(s => nanoseconds(s.header.stamp)), gaps = stamps.slice(1).map((stamp, i) => Number(stamp - stamps[i]) / 1e6);
    assert.ok(told.every(s => s.position[s.name.indexOf('still')] === 1.5));
    assert.ok(gaps.sort((a, b) => a - b)[5] < 300 && gaps[0] > 0, `${gaps}`);
    assert.ok(stamps.at(-1) < plc.now());
  });

  const jointIs = (bridge, name, expected) => until(
    () => bridge.joint(name)?.state === expected && bridge.joint(name), () => `${name} ${expected}: ${JSON.stringify(bridge.state)}`);

  it('Adapter_OnChangeWithAllJointsAtRest_ReadsThemBackAndAssumesRest', async t => {
    const still = ['one', 'two'].map(name => new PlcSymbol(`MAIN.${name}`, 'LREAL', () => 1.5));
    const joints = '  - { joint: one, symbol: MAIN.one }\n  - { joint: two, symbol: MAIN.two }\n';
    const { bridge } = await cell(t, { plc: new Plc([...variables(), ...still], { cycleMs: 5 }), more: '  on_change: true\n', joints });
    // A gateway reads the clock repeatedly as well.
    const asked = setInterval(() => void bridge.call('/nowpose/plant_time/cell').catch(() => {}), 200);
    t.after(() => clearInterval(asked));

    await jointIs(bridge, 'one', 'rest');
    const count = bridge.jointStates.length;
    await until(() => bridge.jointStates.length > count + 20, 'joints at rest to be repeated');

    const repeated = bridge.jointStates.slice(count), stamps = repeated.filter(s => s.name.includes('one')).map(s => nanoseconds(s.header.stamp));
    const gaps = stamps.slice(1).map((stamp, i) => Number(stamp - stamps[i]) / 1e6).sort((a, b) => a - b);
    assert.ok(repeated.every(s => s.position.every(position => position === 1.5)));
    // On a busy machine some gaps are longer. A headset shows a sample for 300 ms.
    assert.ok(gaps[gaps.length >> 1] < 200, `${gaps}`);
    await until(() => bridge.status.level === 0, () => JSON.stringify(bridge.status));
  });

  it('Adapter_SymbolMissingInNewProgram_IsFaultWhileOthersStayLive', async t => {
    const joints = '  - { joint: arm_joint_1, symbol: "GVL.aJoints[0]" }\n  - { joint: axis, symbol: MAIN.fAxis2, unit: deg }\n';
    const { plc, bridge } = await cell(t, { joints });
    await Promise.all(['arm_joint_1', 'axis'].map(name => jointIs(bridge, name, 'live')));

    plc.download(variables().filter(({ name }) => name !== 'MAIN.fAxis2'));
    await until(() => bridge.joint('axis').reason.includes('has no symbol MAIN.fAxis2'), () => JSON.stringify(bridge.state));
    await jointIs(bridge, 'arm_joint_1', 'live');

    assert.equal(bridge.joint('axis').state, 'fault');
    assert.equal(bridge.status.level, 2);
    plc.download(variables());
    await jointIs(bridge, 'axis', 'live');
  });

  it('Adapter_SymbolUnknownAtStart_IsMissingWhileOthersAreLive', async t => {
    const joints = '  - { joint: arm_joint_1, symbol: "GVL.aJoints[0]" }\n  - { joint: axis, symbol: MAIN.fAxs2 }\n';
    const { bridge } = await cell(t, { joints });

    await jointIs(bridge, 'arm_joint_1', 'live');

    assert.equal(bridge.joint('axis').state, 'missing');
    assert.match(bridge.joint('axis').reason, /line 11: the PLC has no symbol MAIN\.fAxs2; similar symbols are MAIN\.fAxis2/);
  });

  it('Adapter_PlcStopped_ReportsItAndReadsAgainAfterTheStop', async t => {
    const { plc, bridge, adapter } = await cell(t);
    await statesOf(bridge);

    plc.plcState = state.stop;
    await adapter.said('waiting: the PLC\'s program is in state Stop');
    const count = bridge.jointStates.length;
    await until(() => Number(bridge.state?.['refused/plc-stopped']) > 0, 'refusals');
    assert.equal(bridge.jointStates.length, count);
    assert.equal((await bridge.call('/nowpose/plant_time/cell')).result, false);
    assert.match(bridge.joint('arm_joint_1').state, /fault|refused/);
    assert.ok(bridge.status.message.includes('state Stop'), bridge.status.message);

    plc.plcState = state.run;
    await statesOf(bridge, count + 5);
    assert.equal((await until(() => bridge.state?.state === 'connected' && bridge.state, 'diagnostics')).kind, 'ads');
  });

  it('Adapter_NewProgram_LooksUpItsVariablesAgain', async t => {
    const { plc, bridge, adapter } = await cell(t);
    await statesOf(bridge);

    plc.download(variables());

    await adapter.said('looked up again');
    const count = bridge.jointStates.length;
    assertTrue((await statesOf(bridge, count + 20)).slice(count));
  });

  it('Adapter_ConfigMode_IsReportedUntilRunMode', async t => {
    const plc = youBot({ cycleMs: 5 });
    plc.systemState = state.config;
    const { bridge, adapter } = await cell(t, { plc });

    await adapter.said(`waiting: TwinCAT at ${NET_ID} is in Config mode`);
    plc.systemState = state.run;

    await statesOf(bridge);
    await clockOf(bridge);
    plc.systemState = state.config;
    await adapter.said(`TwinCAT at ${NET_ID} went to Config mode`);
  });

  it('Adapter_PlcClosedAndRestarted_IsReadAgain', async t => {
    const { plc, server, bridge, adapter, port } = await cell(t);
    await statesOf(bridge);

    await server.close();
    await adapter.said('nothing answers at 127.0.0.1');
    const again = new AdsServer(plc);
    t.after(() => again.close());
    await again.listen(port);

    const count = bridge.jointStates.length;
    await statesOf(bridge, count + 5);
    await until(() => Number(bridge.state?.reconnects) > 0, () => JSON.stringify(bridge.state));
  });

  it('Adapter_PlcStopsAnswering_IsReportedAndReadAgain', async t => {
    const { server, bridge, adapter } = await cell(t);
    await statesOf(bridge);

    server.silent = true;
    await adapter.said('waiting: ');
    server.silent = false;

    const count = bridge.jointStates.length;
    await statesOf(bridge, count + 5);
  });

  it('Adapter_RouterOnThisMachine_AssignsAnAddress', async t => {
    const { bridge } = await cell(t, { local: '' });

    assertTrue(await statesOf(bridge, 20));
  });

  it('Adapter_InvalidFrames_DoNotEndTheProcess', async t => {
    const random = seeded(4711), connections = [];
    const server = createServer(socket => {
      connections.push(socket.on('error', () => {}));
      socket.on('data', () => {
        const length = Math.floor(random() * 300), bytes = Buffer.alloc(6 + length);
        for (let i = 0; i < bytes.length; i++) bytes[i] = Math.floor(random() * 256);
        // Most messages are whole frames of the protocol, addressed to the adapter, with random content. The others are not even frames.
        if (connections.length % 4 > 0) bytes.writeUInt16LE(0, 0);
        if (connections.length % 5 > 0) bytes.writeUInt32LE(length, 2);
        if (length > 32) Buffer.from([192, 168, 0, 10, 1, 1, 0x89, 0x80]).copy(bytes, 6);
        if (length > 32) bytes.writeUInt16LE([8, 9, 2, 6][connections.length % 4], 22);
        socket.write(bytes);
      });
    }).listen(0, '127.0.0.1');
    await once(server, 'listening');
    t.after(() => {
      connections.forEach(socket => socket.destroy());
      server.close();
    });
    const bridge = await RosbridgeDouble.start(t);
    const adapter = start(t, [temporaryFile('ads.yaml', configuration({ port: server.address().port, url: bridge.url }))]);

    await until(() => connections.length >= 4, () => adapter.err);

    await until(() => bridge.state?.state === 'waiting', () => JSON.stringify(bridge.state));
    assert.deepEqual(bridge.jointStates, []);
    assert.equal(adapter.child.exitCode, null);
  });

  it('Adapter_NoRoute_ExplainsHowToAddOne', async t => {
    const { adapter } = await cell(t, { server: { routes: ['10.0.0.1.1.1'] } });

    await adapter.said('if it has never answered, add a route to this machine: in TwinCAT, SYSTEM > Routes > Add, AMS Net Id 192.168.0.10.1.1, transport TCP_IP');
  });

  for (const [name, joints, said] of [
    ['UnknownSymbol', '  - joint: a\n    symbol: MAIN.fAxs1\n', /ads\.yaml, line 11: the PLC has no symbol MAIN\.fAxs1; similar symbols are MAIN\.fAxis1, MAIN\.fAxis2/],
    ['WholeArray', '  - joint: a\n    symbol: GVL.aJoints\n', /line 11: GVL\.aJoints is ARRAY \[0\.\.4\] OF LREAL; name one element, such as GVL\.aJoints\[0\]/],
    ['Text', '  - joint: a\n    symbol: MAIN.sName\n', /line 11: MAIN\.sName is STRING; a joint's value must be a number/],
  ])
    it(`Adapter_${name}_NamesTheLine`, async t => {
      const { adapter } = await cell(t, { joints });

      await adapter.said('line 11');
      assert.match(adapter.err, said);
    });

  for (const [name, stampOf, reason] of [
    ['Zero', () => 0n, 'stamp-missing'],
    ['Frozen', () => 134_000_000_000_000_000n, 'stamp-not-newer'],
  ])
    it(`Adapter_${name}Stamp_IsRefusedWithAReason`, async t => {
      const { bridge } = await cell(t, { plc: youBot({ cycleMs: 5, stampOf }) });

      await until(() => Number(bridge.state?.[`refused/${reason}`]) > 10, () => JSON.stringify(bridge.state));
      assert.ok(bridge.jointStates.length <= 5, 'at most one for each joint');
    });

  it('Adapter_Terminated_RemovesItsNotifications', async t => {
    const { server, bridge, adapter } = await cell(t);
    await statesOf(bridge);

    adapter.child.kill('SIGTERM');

    assert.equal(await adapter.ended, 0);
    assert.ok(server.seen.filter(s => s.command === command.deleteNotification).length >= 5);
  });

  describe('configuration', () => {
    const good = configuration({ port: 48898, url: 'ws://127.0.0.1:47011' });

    it('Check_ValidFile_NamesEndpointAndJoints', async t => {
      const { status, out } = await check(t, temporaryFile('ads.yaml', good));

      assert.equal(status, 0);
      assert.match(out, /is valid: ADS ads:\/\/127\.0\.0\.1:48898\/5\.24\.12\.7\.1\.1:851, NO SECURITY; t_k is the stamp of ADS, sampled every 10 ms, published every 10 ms; joints arm_joint_1, /);
    });

    for (const [name, from, to, expected] of [
      ['NotPlain', '  plain: true\n', '', /^line 3: plant\.plain: missing; ADS is neither encrypted nor authenticated/],
      ['Endpoint', /ads:.*/, '192.168.0.20', /^line 6: plant\.endpoint: value "192\.168\.0\.20"; allowed is .*ads:\/\/HOST\/AMS NET ID:AMS PORT/],
      ['NetId', '5.24.12.7.1.1', '5.24.12.700.1.1', /^line 6: plant\.endpoint: .* parts of an AMS Net Id are 0 to 255/],
      ['LocalNetId', '192.168.0.10.1.1', '192.168.0.10', /^line 7: plant\.local_net_id: value "192\.168\.0\.10"; allowed is this machine's own AMS Net Id/],
      ['Timestamp', 'plain: true', 'plain: true\n  timestamp: notifications', /^line 9: plant\.timestamp: .*did you mean notification\?/],
      ['NoTime', 'plain: true', 'plain: true\n  timestamp: variable', /^line 9: plant\.timestamp: value "variable"; add time/],
      ['TimeUnused', 'plain: true', 'plain: true\n  timestamp: notification\n  time: { symbol: GVL.nTime }', /^line 10: plant\.time: timestamp is notification; remove time/],
      ['Publishing', 'plain: true', 'plain: true\n  sampling_ms: 20\n  publishing_ms: 10', /^line 10: plant\.publishing_ms: value 10; allowed is a time from sampling_ms, 20, to 10000 ms/],
      ['Symbol', 'symbol: GVL.aJoints[0]', 'symbol: GVL aJoints', /^line 11: joints\[0\]\.symbol: .*; allowed is the name of a variable/],
    ])
      it(`Check_Invalid${name}_NamesItsLine`, () => {
        const text = good.replace(from, to);
        assert.notEqual(text, good);
        const path = temporaryFile('ads.yaml', text), lines = wrongIn(path);

        assert.match(lines[0].replace(`${path}, `, ''), expected);
      });
  });
});

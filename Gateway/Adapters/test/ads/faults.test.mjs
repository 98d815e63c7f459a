// Tests how an adapter reports faults of a PLC and of its variables, and how it continues after them.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { connect, createServer } from 'node:net';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { start, startProcess, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { seeded } from '../seeded.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { assertMatchesPlc, cell, clockOf, configuration, jointIs, NET_ID, statesOf } from './cell.mjs';
import { command, state } from './frames.mjs';
import { AdsServer } from './server.mjs';
import { variables, youBot } from './youbot.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { adsMessages, symbolMessages } = messages;
const { ReadOnlyClient } = await parts('ads/readOnlyClient');

describe('faults over ADS', () => {
  it('Symbol_MissingInNewProgram_IsInFaultWhileOthersStayLive', async t => {
    const joints = '  - { joint: arm_joint_1, symbol: "GVL.aJoints[0]" }\n  - { joint: axis, symbol: MAIN.fAxis2, unit: deg }\n';
    const { plc, bridge } = await cell(t, { joints });
    await Promise.all(['arm_joint_1', 'axis'].map(name => jointIs(bridge, name, 'live')));

    plc.download(variables().filter(({ name }) => name !== 'MAIN.fAxis2'));
    await until(() => like(symbolMessages.unknown(ANY, 'MAIN.fAxis2', undefined)).test(bridge.joint('axis').reason), () => JSON.stringify(bridge.state));
    await jointIs(bridge, 'arm_joint_1', 'live');

    assert.equal(bridge.joint('axis').state, 'fault');
    assert.equal(bridge.status.level, 2);
    plc.download(variables());
    await jointIs(bridge, 'axis', 'live');
  });

  it('Symbol_UnknownAtStart_IsMissingWhileOthersAreLive', async t => {
    const joints = '  - { joint: arm_joint_1, symbol: "GVL.aJoints[0]" }\n  - { joint: axis, symbol: MAIN.fAxs2 }\n';
    const { bridge } = await cell(t, { joints });

    await jointIs(bridge, 'arm_joint_1', 'live');

    assert.equal(bridge.joint('axis').state, 'missing');
    assert.match(bridge.joint('axis').reason, like(symbolMessages.unknown('line 11', 'MAIN.fAxs2', ['MAIN.fAxis2'])));
  });

  // The client has two notifications of its own, and one is reserved for the clock.
  it('Notification_Refused_OnlyItsJointIsMissingUntilThePlcAcceptsIt', async t => {
    const { server, bridge } = await cell(t, { server: { maxNotifications: 6 } });
    const inState = wanted => [1, 2, 3, 4, 5].filter(i => bridge.joint(`arm_joint_${i}`)?.state === wanted);

    await until(() => inState('live').length === 3 && inState('missing').length === 2, () => JSON.stringify(bridge.state));
    await statesOf(bridge, 20);
    await clockOf(bridge);

    for (const i of inState('missing'))
      assert.match(bridge.joint(`arm_joint_${i}`).reason, like(adsMessages.notNotified(`GVL.aJoints[${i - 1}]`, ANY)));
    assert.deepEqual([inState('missing').length, bridge.state.state, bridge.state.reconnects], [2, 'connected', '0']);

    server.maxNotifications = Infinity;
    await until(() => inState('live').length === 5, () => JSON.stringify(bridge.state));
    assert.deepEqual([bridge.state.state, bridge.state.reconnects], ['connected', '0']);
  });

  it('Notifications_AllRefused_ReasonIsThatOfThePlc', async t => {
    const { adapter } = await cell(t, { server: { maxNotifications: 3 } });

    await adapter.said('waiting: ');

    assert.match(adapter.err, /memory/i);
  });

  it('Clock_VariableDoesNotAdvance_IsNamed', async t => {
    const more = '  timestamp: variable\n  time: { symbol: GVL.nStoppedTime, unit: ns }\n';
    const { adapter } = await cell(t, { more });

    await adapter.said(adsMessages.clockNotReadable(adsMessages.clockStopped('GVL.nStoppedTime')));
  });

  it('Adapter_NewPlcProgram_LooksUpTheVariablesAgain', async t => {
    const { plc, bridge, adapter } = await cell(t);
    await statesOf(bridge);

    plc.download(variables());

    await adapter.said('looked up again');
    const count = bridge.jointStates.length;
    assertMatchesPlc((await statesOf(bridge, count + 20)).slice(count));
  });

  it('Adapter_NewPlcProgramReusesHandles_PublishesNoValueAsAnotherJoint', async t => {
    const { plc, server, bridge, adapter } = await cell(t, { plc: youBot({ cycleMs: 1 }), more: '  sampling_ms: 1\n' });
    await clockOf(bridge);
    const subscriptions = () => server.seen.filter(s => s.command === command.addNotification && s.connection === 1).length, before = subscriptions();

    plc.downloadInPlace();

    await adapter.said(adsMessages.newProgram);
    assertMatchesPlc(await statesOf(bridge, bridge.jointStates.length + 20));
    // The adapter must look up the variables first, because they may have other addresses, and the PLC uses the handles of the old ones again.
    assert.equal(subscriptions(), before);
  });

  it('Adapter_AnotherClientOfThisMachineConnects_ReportsThatThePlcAcceptsOneConnection', async t => {
    const { bridge, adapter, port } = await cell(t, { server: { isSole: true } });
    await statesOf(bridge);

    const other = connect(port, '127.0.0.1').on('error', () => {});
    t.after(() => other.destroy());

    await adapter.said(`waiting: ${adsMessages.ended('127.0.0.1', '192.168.0.10.1.1')}`);
  });

  it('Adapter_PlcInConfigMode_ReportsTheModeUntilRunMode', async t => {
    const plc = youBot({ cycleMs: 5 });
    plc.systemState = state.config;
    const { bridge, adapter } = await cell(t, { plc });

    await adapter.said(`waiting: ${adsMessages.notRunning(NET_ID, 'Config')}`);
    plc.systemState = state.run;

    await statesOf(bridge);
    await clockOf(bridge);
    plc.systemState = state.config;
    await adapter.said(adsMessages.stopped(NET_ID, 'Config'));
  });

  it('Adapter_PlcRestarted_ReadsAgain', async t => {
    const { plc, server, bridge, adapter, port } = await cell(t);
    await statesOf(bridge);

    await server.close();
    await adapter.said(like(adsMessages.noRouter('127.0.0.1', ANY, ANY)));
    const again = new AdsServer(plc);
    t.after(() => again.close());
    await again.listen(port);

    const count = bridge.jointStates.length;
    await statesOf(bridge, count + 5);
    await until(() => Number(bridge.state?.reconnects) > 0, () => JSON.stringify(bridge.state));
  });

  it('Adapter_ConnectionLost_DeletesTheNotificationsOfTheFormerConnection', async t => {
    const { server, bridge } = await cell(t);
    await statesOf(bridge);

    // The client has two notifications of its own, and one may be reading the clock. The two of a former connection stay, because their values do not
    // change, so that the PLC does not send them.
    for (let lost = 1; lost <= 3; lost++) {
      const before = Number(bridge.state.reconnects);
      server.drop();
      await until(() => Number(bridge.state.reconnects) > before && bridge.state.state === 'connected', () => JSON.stringify(bridge.state));
      const most = 8 + 2 * Number(bridge.state.reconnects);
      await until(() => server.notifications <= most, () => `${server.notifications} notifications instead of ${most}`);
    }

    const count = bridge.jointStates.length;
    assertMatchesPlc((await statesOf(bridge, count + 20)).slice(count));
  });

  it('Client_Disconnect_DeletesAllNotificationsAtOnce', async t => {
    const server = new AdsServer(youBot()), port = await server.listen();
    t.after(() => server.close());
    const client = new ReadOnlyClient({ host: '127.0.0.1', tcpPort: port, netId: NET_ID, port: 851 }, { netId: '192.168.0.10.1.1', port: 32905 });
    await client.connect();
    const { indexGroup, indexOffset, size } = await client.getSymbol('GVL.aJoints[0]');
    for (let i = 0; i < 5; i++) await client.subscribe({ target: { indexGroup, indexOffset, size }, callback: () => {} });
    // No deletion is confirmed before all have arrived.
    const { notifications } = server, waiting = [];
    client.settings.timeoutDelay = 1e9;
    server.respond = (sent, send) => {
      if (sent === command.deleteNotification) waiting.push(send);
      else send();
      if (waiting.length === notifications) for (const each of waiting) each();
    };

    const disconnected = client.disconnect();

    await until(() => server.notifications === 0, () => `${server.notifications} notifications`);
    await disconnected;
  });

  it('Adapter_PlcStopsAnswering_ReportsItAndReadsAgain', async t => {
    const { server, bridge, adapter } = await cell(t);
    await statesOf(bridge);

    server.silent = true;
    await adapter.said('waiting: ');
    server.silent = false;

    const count = bridge.jointStates.length;
    await statesOf(bridge, count + 5);
  });

  it('Adapter_InvalidFrames_ContinuesToRun', async t => {
    VirtualTime.ofProcess(t);
    const random = seeded(4711), connections = [];
    const server = createServer(socket => {
      connections.push(socket.on('error', () => {}));
      socket.on('data', () => {
        const length = Math.floor(random() * 300), bytes = Buffer.alloc(6 + length);
        for (let i = 0; i < bytes.length; i++) bytes[i] = Math.floor(random() * 256);
        // Most messages have a valid header with the adapter's address, followed by random content. In the others the header is random, too.
        if (connections.length % 4 > 0) bytes.writeUInt16LE(0, 0);
        if (connections.length % 5 > 0) bytes.writeUInt32LE(length, 2);
        if (length > 32) Buffer.from([192, 168, 0, 10, 1, 1, 0x89, 0x80]).copy(bytes, 6);
        if (length > 32) bytes.writeUInt16LE([8, 9, 2, 6][connections.length % 4], 22);
        socket.write(bytes);
      });
    }).listen(0, '127.0.0.1');
    await once(server, 'listening');
    t.after(() => connections.concat(server).forEach(each => (each.destroy ?? each.close).call(each)));
    const bridge = await RosbridgeDouble.start(t);
    const adapter = start(t, [temporaryFile('ads.yaml', configuration({ port: server.address().port, url: bridge.url }))]);

    await until(() => connections.length >= 4, () => adapter.err);
    await until(() => bridge.state?.state === 'waiting', () => JSON.stringify(bridge.state));
    assert.deepEqual(bridge.jointStates, []);
    assert.equal(adapter.status, undefined);
  });

  it('Adapter_NoRoute_ExplainsHowToAddARoute', async t => {
    const { adapter } = await cell(t, { server: { routes: ['10.0.0.1.1.1'] } });

    await adapter.said(adsMessages.noAnswer('127.0.0.1', '192.168.0.10.1.1'));
  });

  for (const [name, joints, said] of [
    ['UnknownSymbol', '  - joint: a\n    symbol: MAIN.fAxs1\n', symbolMessages.unknown('line 11', 'MAIN.fAxs1', ['MAIN.fAxis1', 'MAIN.fAxis2'])],
    ['WholeArray', '  - joint: a\n    symbol: GVL.aJoints\n', symbolMessages.unusable('line 11', 'GVL.aJoints', 'ARRAY [0..4] OF LREAL', symbolMessages.array('GVL.aJoints[0]'))],
    ['TextSymbol', '  - joint: a\n    symbol: MAIN.sName\n', symbolMessages.unusable('line 11', 'MAIN.sName', 'STRING', symbolMessages.notNumber)],
  ])
    it(`Adapter_${name}_NamesTheLine`, async t => {
      const { adapter } = await cell(t, { joints });

      await adapter.said('line 11');
      assert.ok(adapter.err.includes(said), adapter.err);
    });

  for (const [name, stampOf, reason] of [
    ['Zero', () => 0n, 'stamp-missing'],
    ['Frozen', () => 134_000_000_000_000_000n, 'stamp-not-newer'],
  ])
    it(`Adapter_${name}TimeStamp_RefusesTheValueWithAReason`, async t => {
      const { bridge } = await cell(t, { plc: youBot({ cycleMs: 5, stampOf }) });

      await until(() => Number(bridge.state?.[`refused/${reason}`]) > 10, () => JSON.stringify(bridge.state));
      assert.ok(bridge.jointStates.length <= 5, 'at most one for each joint');
    });

  it('Adapter_Terminated_DeletesItsNotifications', async t => {
    const { server, bridge, adapter } = await cell(t, { launch: startProcess });
    await statesOf(bridge);

    assert.equal(await adapter.stop(), 0);

    assert.ok(server.seen.filter(s => s.command === command.deleteNotification).length >= 5);
  });
});

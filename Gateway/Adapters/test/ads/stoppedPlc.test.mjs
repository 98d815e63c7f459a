// Tests how an adapter continues when the program of a PLC stops and starts.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { until } from '../program.mjs';
import { cell, jointIs, statesOf } from './cell.mjs';
import { command, state } from './frames.mjs';
import { Plc } from './plc.mjs';
import { PlcSymbol } from './symbols.mjs';
import { variables } from './youbot.mjs';

const { adsMessages } = messages;

describe('a stopped PLC', () => {
  it('Adapter_PlcStoppedAndStarted_ReportsTheStopThenReadsAgain', async t => {
    const { plc, bridge, adapter } = await cell(t);
    await statesOf(bridge);

    plc.plcState = state.stop;
    await adapter.said(`waiting: ${adsMessages.programState('Stop')}`);
    // The diagnostics arrive after the last positions, because they use the same connection.
    const refused = () => Number(bridge.state?.['refused/plc-stopped'] ?? 0);
    const first = await until(refused, 'refusals'), count = bridge.jointStates.length;
    await until(() => refused() > first, 'more refusals');
    assert.equal(bridge.jointStates.length, count);
    assert.equal((await bridge.call('/nowpose/plant_time/cell')).result, false);
    assert.match(bridge.joint('arm_joint_1').state, /fault|refused/);
    assert.ok(bridge.status.message.includes('state Stop'), bridge.status.message);

    plc.plcState = state.run;
    await statesOf(bridge, count + 5);
    assert.equal((await until(() => bridge.state?.state === 'connected' && bridge.state, 'diagnostics')).kind, 'ads');
  });

  // The PLC sends no notification when its program starts again, because the value has not changed since.
  it('Adapter_ValueChangesWhileThePlcIsStopped_IsPublishedAfterTheStart', async t => {
    let value = 1.5;
    const plc = new Plc([...variables(), new PlcSymbol('MAIN.fStill', 'LREAL', () => value)], { cycleMs: 5 });
    const { bridge } = await cell(t, { plc, more: '  on_change: true\n', joints: '  - { joint: still, symbol: MAIN.fStill }\n' });
    await jointIs(bridge, 'still', 'rest');

    plc.plcState = state.stop;
    await until(() => bridge.state?.state === 'waiting', () => JSON.stringify(bridge.state));
    value = 0.5;
    await jointIs(bridge, 'still', 'refused');
    plc.plcState = state.run;

    await jointIs(bridge, 'still', 'rest');
    assert.deepEqual(bridge.jointStates.at(-1).position, [0.5]);
  });

  // After the first start, the adapter subscribes again to the symbol, whose value has changed.
  it('Adapter_PlcStopsAgainDuringASubscription_PublishesTheValueAfterTheNextStart', async t => {
    let value = 1.5;
    const plc = new Plc([...variables(), new PlcSymbol('MAIN.fStill', 'LREAL', () => value)], { cycleMs: 5 });
    const { bridge, server } = await cell(t, { plc, more: '  on_change: true\n', joints: '  - { joint: still, symbol: MAIN.fStill }\n' });
    const isIn = expected => until(() => bridge.state?.state === expected, () => JSON.stringify(bridge.state));
    const refused = () => Number(bridge.state?.['refused/plc-stopped'] ?? 0), isPublished = () => bridge.jointStates.some(s => s.position[0] === 0.5);
    await jointIs(bridge, 'still', 'rest');
    plc.plcState = state.stop;
    await isIn('waiting');
    value = 0.5;
    await jointIs(bridge, 'still', 'refused');
    const before = refused();
    server.respond = async (sent, send, data) => {
      // The notifications of the clock have the cycle time 0.
      if (sent === command.addNotification && data.readUInt32LE(20) > 0) {
        await isIn('connected');
        plc.plcState = state.stop;
        await isIn('waiting');
      }
      send();
    };

    plc.plcState = state.run;
    await until(() => refused() > before, () => JSON.stringify(bridge.state));

    assert.deepEqual([isPublished(), bridge.joint('still').state], [false, 'refused']);
    server.respond = (_, send) => send();
    plc.plcState = state.run;
    await until(isPublished, () => JSON.stringify(bridge.state));
  });

  it('Adapter_PlcStartedWhileTheAdapterEnds_DoesNotReadAgain', async t => {
    const { plc, server, adapter } = await cell(t);
    await adapter.said('] connected');
    plc.plcState = state.stop;
    await adapter.said(`waiting: ${adsMessages.programState('Stop')}`);

    // The PLC does not respond to the deletions of the notifications, which continue, so the adapter waits.
    server.silent = true;
    const stopped = adapter.stop();
    plc.plcState = state.run;
    await stopped;

    assert.equal(adapter.err.split('] connected').length - 1, 1, adapter.err);
  });
});

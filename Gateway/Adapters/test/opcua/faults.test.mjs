import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { adapters, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { adapterFor, OPEN, serverFor } from './plant.mjs';
import { freePort } from '../freePort.mjs';
import { ControlClock, YoubotServer } from './server.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { clockMessages, opcuaMessages } = messages;

const JOINTS = [{ joint: 'a', node: 'ns=1;s=arm_joint_1' }];

describe('faults', () => {
  let server;
  before(async () => { server = await new YoubotServer().start(); });
  after(() => server.stop());

  it('Adapter_PlantKilledAndRestarted_ReadsAgain', async t => {
    const first = await serverFor(t);
    const { bridge, state, states, run } = await adapterFor(t, first, OPEN, JOINTS);
    await states(5);

    await first.stop();
    const { reason } = await state(s => s.state === 'waiting');
    const { result, values } = await bridge.call('/nowpose/plant_time/cell');
    const before = bridge.jointStates.length;
    await serverFor(t, { port: first.port });
    await states(before + 5);

    assert.equal(result, false);
    assert.equal(values, clockMessages.notConnected);
    assert.match(reason, /\S/);
    // On a busy machine, the first connection to the new server can fail.
    const { reconnects } = await state(s => s.state === 'connected');
    assert.ok(Number(reconnects) >= 1, reconnects);
    // The adapter writes one line for each change of state, not for each attempt.
    const changes = () => run.err.split('\n').filter(line => /\] (connected|waiting)/.test(line)).map(line => line.replace(/^.*?\] /, ''));
    await until(() => changes().filter(line => line === 'connected').length === Number(reconnects) + 1, () => `${reconnects} reconnections: ${run.err}`);
    assert.ok(changes().every((line, i, all) => line !== all[i - 1]), run.err);
  });

  it('Adapter_GatewayKilledAndRestarted_SendsTopicsClockAndSamplesAgain', async t => {
    const old = await RosbridgeDouble.start(t), { port } = old;
    const { states, state } = await adapterFor(t, server, OPEN, JOINTS, { bridge: old });
    await states(5);
    await state(s => s.state === 'connected');

    old.stop();
    const fresh = await RosbridgeDouble.start(t, { port });
    await until(() => fresh.jointStates.length >= 5, 'joint states at the new gateway');

    assert.equal((await fresh.call('/nowpose/plant_time/cell')).result, true);
    // The adapter has dropped its oldest samples, so the new gateway does not receive all earlier samples.
    const [oldest] = fresh.jointStates;
    assert.ok(server.clock.now - nanoseconds(oldest.header.stamp) < 20_000_000_000n);
    const topics = fresh.heard.filter(m => m.op === 'advertise').map(m => m.topic);
    assert.ok(topics.includes('/joint_states') && topics.includes('/nowpose/diagnostics'));
  });

  it('Adapter_PlantFrozen_DisconnectsAndReadsAgain', { skip: process.platform === 'win32' }, async t => {
    const port = await freePort();
    const child = spawn(process.execPath, [join(adapters, 'test', 'opcua', 'main.mjs'), '--port', String(port), '--security', 'none'],
      { stdio: ['ignore', 'pipe', 'inherit'] });
    const ended = once(child, 'close');
    // The plant deletes its temporary folder when it ends normally.
    t.after(async () => {
      child.kill('SIGCONT');
      child.kill('SIGTERM');
      await ended;
    });
    await once(child.stdout, 'data');
    const { bridge, state, states } = await adapterFor(t, { endpoint: `opc.tcp://127.0.0.1:${port}` }, OPEN, JOINTS, { isAlone: false });
    await states(5);

    child.kill('SIGSTOP');
    const { reason } = await state(s => s.state === 'waiting' || s.state === 'connecting');
    child.kill('SIGCONT');
    const before = bridge.jointStates.length;

    // Whichever of the adapter's requests was open when the plant froze ends first.
    const possible = [opcuaMessages.silent(ANY), opcuaMessages.notReadable(ANY), clockMessages.notReadable(ANY), 'connection'].map(text => like(`${text}`));
    assert.ok(reason === undefined || possible.some(pattern => pattern.test(reason)), reason);
    await states(before + 5);
  });

  it('Clock_StopsAndContinues_IsUnavailableMeanwhileWithoutDisconnection', async t => {
    const own = await serverFor(t, { clock: new ControlClock({ offsetMs: 3_600_000 }) }), { bridge, state, states } = await adapterFor(t, own, OPEN, JOINTS);
    await states(5);
    const readClock = () => bridge.call('/nowpose/plant_time/cell');

    own.isStopped = true;
    await until(async () => (await readClock()).values === clockMessages.stopped, 'the report of the stopped clock');
    // The adapter reads the clock and sends its diagnostics once a second.
    const looks = bridge.published('/nowpose/diagnostics').length + 4;
    await until(() => bridge.published('/nowpose/diagnostics').length > looks, 'further diagnostics');
    const { state: meanwhile, reconnects } = bridge.state;
    own.isStopped = false;

    await until(async () => (await readClock()).result, 'the clock');
    assert.deepEqual([meanwhile, reconnects], ['connected', '0']);
    await state(s => s.reconnects === '0' && s.state === 'connected');
  });

  it('Adapter_PlantStopsWithItsClock_StaysConnectedAndReadsAgain', async t => {
    const { bridge, state, states } = await adapterFor(t, server, OPEN, JOINTS);
    await states(5);
    t.after(() => { server.isStopped = false; });

    server.isStopped = true;
    const { state: meanwhile, reconnects } = await state(s => s['joint/a']?.startsWith('fault'));

    assert.deepEqual([meanwhile, reconnects], ['connected', '0']);
    server.isStopped = false;
    await states(bridge.jointStates.length + 3);
    assert.ok(bridge.jointStates.every(s => Math.abs(s.position[0] - YoubotServer.truth(0, nanoseconds(s.header.stamp))) < 1e-12));
  });
});

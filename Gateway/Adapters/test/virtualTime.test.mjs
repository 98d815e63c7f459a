// Tests the virtual time of the other tests: which timers end, and when a wait ends although no time passes.
import assert from 'node:assert/strict';
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { describe, it } from 'node:test';
import { moment, VirtualTime } from './virtualTime.mjs';

const activeTimers = () => process.getActiveResourcesInfo().filter(name => name === 'Timeout').length;

describe('virtual time', () => {
  it('SetTimeout_SeveralTimers_EndInTheOrderOfTheirTimes', async t => {
    VirtualTime.ofProcess(t);
    const ended = [], began = performance.now();

    setTimeout(() => ended.push('later'), 2e9);
    setTimeout(() => ended.push('sooner'), 1e9);
    await new Promise(resolve => setTimeout(resolve, 3e9));

    assert.deepEqual(ended, ['sooner', 'later']);
    assert.ok(performance.now() - began >= 3e9);
  });

  it('ClearTimeout_VirtualTimer_OnlyThisTimerDoesNotEnd', async t => {
    VirtualTime.ofProcess(t);
    const ended = [], cleared = setTimeout(() => ended.push('cleared'), 5);
    setTimeout(() => ended.push('other'), 5);

    clearTimeout(cleared);
    await new Promise(resolve => setTimeout(resolve, 10));

    assert.deepEqual(ended, ['other']);
  });

  it('ClearTimeout_TimerThatBeganInRealTime_Ends', t => {
    const began = setTimeout(() => {}, 60_000);
    VirtualTime.ofProcess(t);
    const before = activeTimers();

    clearTimeout(began);

    assert.equal(activeTimers(), before - 1);
  });

  it('Moment_NoWorkInProgress_EndsBeforeTheNextTimerAndLeavesNoTimer', async t => {
    VirtualTime.ofProcess(t);
    const before = activeTimers();
    let hasEnded = false;
    setTimeout(() => { hasEnded = true; }, 5);

    await moment();

    assert.equal(hasEnded, false);
    assert.ok(activeTimers() <= before, `${activeTimers()} timers instead of ${before}`);
  });

  // The adapters use no sockets for datagrams, so virtual time counts one as work in progress. The test takes the real second of the limit.
  it('Moment_WorkThatDoesNotEnd_EndsWhileTheTimeStandsStill', { timeout: 60_000 }, async t => {
    const socket = createSocket('udp4').bind(0, '127.0.0.1');
    t.after(() => socket.close());
    await once(socket, 'listening');
    VirtualTime.ofProcess(t);
    let hasEnded = false;
    setTimeout(() => { hasEnded = true; }, 5);

    await moment();

    assert.equal(hasEnded, false);
  });
});

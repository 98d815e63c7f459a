// Tests in virtual time how often the nodes and the clock of a server are read, and which server counts as silent.
import assert from 'node:assert/strict';
import { it, mock } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';

const { opcuaMessages } = messages;
const { ServerSilence } = await parts('opcua/serverSilence');

const PASSED_MS = 6000, STEP_MS = 10;

for (const [name, intervalMs, hasSilent, expected] of [
  ['AllNodesChangeOften', 20, false, [12, 12]],
  ['SomeNodesChangeOften', 20, true, [12, 12]],
  ['AllNodesChangeEverySecond', 1000, false, [12, 12]],
  // In each second, the checks begin 60 ms after the notification.
  ['SomeNodesChangeEverySecond', 1000, true, [84, 100]],
  ['NoNodeChanges', Infinity, true, [84, 100]],
])
  it(`Checks_${name}_HaveTheRightInterval`, async t => {
    let now = 0, end, looks = 0;
    const ended = new Promise(resolve => { end = resolve; });
    mock.timers.enable({ apis: ['setTimeout'] });
    mock.method(performance, 'now', () => now);
    t.after(() => {
      mock.timers.reset();
      mock.restoreAll();
    });
    const silence = new ServerSilence(), clock = { read: async () => ({ received: 1n, sent: 1n }) };

    const detected = silence.detect(clock, 1000, ended, () => hasSilent, async () => { looks++; });
    for (; now < PASSED_MS; now += STEP_MS) {
      silence.alive();
      if (now % intervalMs === 0) silence.valued();
      mock.timers.tick(STEP_MS);
      await new Promise(setImmediate);
    }
    end();
    mock.timers.tick(100);
    await detected;

    assert.ok(looks >= expected[0] - 2 && looks <= expected[1] + 2, `${looks} checks`);
  });

it('Server_OnlyKeepAliveMessagesForTenMinutes_IsNotSilent', async t => {
  let now = 0, reason = null;
  mock.timers.enable({ apis: ['setTimeout'] });
  mock.method(performance, 'now', () => now);
  t.after(() => {
    mock.timers.reset();
    mock.restoreAll();
  });
  const silence = new ServerSilence(), clock = { read: async () => ({ received: 1n, sent: 1n }) };

  void silence.detect(clock, 1000, new Promise(() => {}), () => false, async () => {}).then(text => { reason = text; });
  const pass = async endMs => {
    for (; now < endMs; now += 100) {
      mock.timers.tick(100);
      await new Promise(setImmediate);
    }
  };
  for (let second = 1; second <= 600; second++) {
    await pass(1000 * second);
    silence.alive();
  }

  assert.equal(reason, null);
  await pass(606_000);
  assert.equal(reason, opcuaMessages.silent(5));
});

import assert from 'node:assert/strict';
import { it } from 'node:test';
import { AdsServer } from './ads/server.mjs';
import { youBot } from './ads/youbot.mjs';
import { RefusingBroker } from './broker/refusingBroker.mjs';
import { SyncServer } from './broker/syncServer.mjs';
import { freePort } from './freePort.mjs';
import { Robot } from './ros/robot.mjs';
import { RosbridgeDouble } from './rosbridge.mjs';
import { RtdeRobot } from './rtde/robot.mjs';

it('FreePort_CalledRepeatedly_ReturnsDifferentPorts', async () => {
  const found = new Set();

  for (let i = 0; i < 400; i++) found.add(await freePort());

  assert.equal(found.size, 400);
});

const DOUBLES = {
  RosbridgeDouble: async t => (await RosbridgeDouble.start(t)).port,
  Robot: async t => (await Robot.start(t)).port,
  SyncServer: async t => (await SyncServer.start(t)).port,
  RefusingBroker: async t => Number(new URL((await RefusingBroker.start(t)).url).port),
  RtdeRobot: async t => (await new RtdeRobot().listen(t)).port,
  AdsServer: async t => {
    const server = new AdsServer(youBot());
    t.after(() => server.close());
    return server.listen();
  },
};

for (const [name, start] of Object.entries(DOUBLES))
  it(`${name}_Started_HasAPortThatTheSystemAssignsToNoConnection`, async t => {
    // Tests stop these servers and start them again. Meanwhile, another process could get a port that the system has assigned.
    assert.ok(await start(t) < 32_768);
  });

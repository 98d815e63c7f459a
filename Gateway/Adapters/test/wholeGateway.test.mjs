// Tests adapters together with the real gateway, which selects the clock of the headsets.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import WebSocket from 'ws';
import { until } from './program.mjs';
import { missing, start } from './ros/gateway.mjs';
import { Robot } from './ros/robot.mjs';
import { temporaryFile } from './temporary.mjs';


const plant = (robot, more = '') =>
  temporaryFile('ros.yaml', `plant:\n  kind: ros\n  name: robot\n  endpoint: ${robot.url}\n  topics: { robot_description: false }\n${more}`);

/** Subscribes like a headset, and returns a list to which the received messages are added. */
async function listen(t, address) {
  const socket = new WebSocket(address), heard = [];
  t.after(() => socket.terminate());
  socket.on('message', data => heard.push(JSON.parse(data)));
  await new Promise((resolve, reject) => socket.once('open', resolve).once('error', reject));
  socket.send(JSON.stringify({ op: 'subscribe', topic: '/joint_states', type: 'sensor_msgs/msg/JointState' }));
  return heard;
}

/** Sends positions until one arrives. Returns the time stamp of this position in the message of the robot and in the message that arrived. */
async function passed(robot, heard) {
  const sent = new Map();
  let position = 0;
  const arrived = await until(() => {
    const now = robot.now?.() ?? BigInt(Date.now()) * 1_000_000n, stamp = now - now % 1000n;
    sent.set(++position, stamp);
    robot.jointState(stamp, ['a'], [position]);
    return heard.find(m => m.op === 'publish')?.msg;
  }, 'a joint state');
  const { sec, nanosec } = arrived.header.stamp;
  return [sent.get(arrived.position[0]), BigInt(sec) * 1_000_000_000n + BigInt(nanosec)];
}

describe('clock of a gateway', { concurrency: 2, skip: missing }, () => {
  for (const [name, more, options] of [['ClockFalse', '  clock: false\n', {}], ['WithoutRosapi', '', { now: null }]])
    it(`Ros_${name}_ForwardsPositionsOnTheGatewaysOwnClock`, async t => {
      const robot = await Robot.start(t, options), heard = await listen(t, await start(t, ['--plant', plant(robot, more)]));

      const [sent, arrived] = await passed(robot, heard);

      assert.equal(arrived, sent);
    });

  it('Gateway_PlantAndBridgeToABroker_UsesTheClockOfThePlant', async t => {
    const robot = await Robot.start(t, { aheadMs: 600_000 });
    // The test does not start a broker, because it needs only an adapter that offers no clock.
    const bridge = temporaryFile('publish.yaml',
      'plant:\n  kind: broker\n  name: to-broker\n  direction: publish\n  endpoint: mqtt://127.0.0.1:9\n  topic: cell\n');
    const heard = await listen(t, await start(t, ['--plant', bridge, '--plant', plant(robot)]));

    const [sent, arrived] = await passed(robot, heard);

    // C1 must be the robot's clock, which is ten minutes ahead. With another clock the time stamp would be different or refused.
    assert.equal(arrived, sent);
  });
});

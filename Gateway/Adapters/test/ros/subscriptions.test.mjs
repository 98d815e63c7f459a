// Tests the subscriptions to topics of which no message arrives.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { WebSocket } from 'ws';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { cell, states } from './cell.mjs';
import { Robot } from './robot.mjs';

const { rosMessages } = messages;
const { renewing } = await parts('ros/subscriptionRenewals');

describe('subscriptions of ros', () => {
  it('Subscriptions_PublishersOfRos2StartLater_ReceiveTheirMessages', async t => {
    const { robot, bridge } = await cell(t), publishing = setInterval(() => robot.jointState(robot.now(), ['a'], [1], [], { isBestEffort: true }), 50);
    t.after(() => clearInterval(publishing));

    robot.publish('/robot_description', { data: '<robot name="r"/>' }, { isLatched: true });

    await until(() => bridge.published('/robot_description').length > 0, () => JSON.stringify(bridge.state));
    await states(bridge);
  });

  it('Subscriptions_TopicHasAMessage_AreNotReplaced', async t => {
    const { robot } = await cell(t), subscribed = topic => robot.heard.filter(m => m.op === 'subscribe' && m.topic === topic).length;

    robot.jointState(robot.now(), ['a'], [1]);
    await until(() => subscribed('/robot_description') > 1, 'the repeated subscription');

    assert.equal(subscribed('/joint_states'), 1);
  });

  it('Subscriptions_Ros1_AreNotReplaced', async t => {
    const { robot, bridge } = await cell(t, { ros: 1 });

    // The notice appears with the second repetition.
    await until(() => bridge.state?.notice === rosMessages.noDescription('/robot_description'), () => JSON.stringify(bridge.state));

    assert.deepEqual(robot.heard.filter(({ op }) => op === 'unsubscribe'), []);
  });

  for (const [name, ros, others, expected] of [['FirstClient', 2, 0, 'live'], ['LaterClient', 2, 1, 'missing'], ['LaterClientOfRos1', 1, 1, 'live']])
    it(`Subscriptions_TwoPublishersOfTfStatic_TheSecondFrameOfA${name}Is${expected}`, async t => {
      const robot = await Robot.start(t, { ros });
      for (const frame of ['rack', 'table'])
        robot.publish('/tf_static', { transforms: [{
          header: { stamp: robot.time(robot.now()), frame_id: 'world' }, child_frame_id: frame,
          transform: { translation: { x: 1, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } },
        }] }, { isLatched: true, publisher: frame });
      for (let i = 0; i < others; i++) {
        const other = new WebSocket(robot.url);
        t.after(() => other.terminate());
        other.on('open', () => other.send(JSON.stringify({ op: 'subscribe', topic: '/tf_static', type: 'tf2_msgs/TFMessage' })));
        await until(() => robot.isHeardBy('/tf_static'), 'the subscription of the other client');
      }
      const { bridge } = await cell(t, { robot }, { rest: 'frames: [{ frame: rack }, { frame: table }]\n' });

      await until(() => bridge.state?.['frame/rack']?.startsWith('live'), () => JSON.stringify(bridge.state));

      await until(() => bridge.state['frame/table'].startsWith(expected), () => JSON.stringify(bridge.state));
    });

  it('Subscriptions_LongConnection_AreReplacedRarely', async () => {
    const ending = new AbortController(), times = [], seconds = [];
    let now = 0;

    await renewing(ending.signal, ms => {
      times.push(ms);
      seconds.push(now / 1000);
    }, async ms => {
      now += ms;
      if (now > 1_300_000) ending.abort();
    });

    assert.deepEqual(seconds, [5, 10, 20, 40, 80, 160, 320, 620, 920, 1220]);
    assert.deepEqual(times, seconds.map(s => 1000 * s));
  });
});

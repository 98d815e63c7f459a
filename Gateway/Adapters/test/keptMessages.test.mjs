// Tests the repetition of messages that a gateway has refused.
import { describe, it } from 'node:test';
import assert from 'node:assert/strict';
import { newLink, runLink } from './links.mjs';
import { parts } from './parts.mjs';
import { until } from './program.mjs';
import { RosbridgeDouble } from './rosbridge.mjs';
import { VirtualTime } from './virtualTime.mjs';

/** The set-points of a robot without a namespace and of one with a namespace. */
const PLANS = ['/joint_trajectory', '/arm1/joint_trajectory'];

const { KeptMessages, SetPoints } = await parts('gateway/keptMessages', 'ros/setPoints');

describe('kept messages', () => {
  it('StationaryFrameOrSetPoints_RefusedByTheGateway_AreSentAgainUntilAccepted', async t => {
    const time = VirtualTime.ofProcess(t), bridge = await RosbridgeDouble.start(t), refusals = [];
    const link = newLink(bridge.url, { refused: status => refusals.push(status) });
    for (const key of ['fixture', 'rail']) link.publishKept('/tf_static', { key }, key);
    for (const topic of PLANS) link.publishKept(topic, {});
    link.publishKept('/robot_description', { data: '<robot/>' });
    link.forgetKept('rail');
    runLink(t, link);
    const sent = () => bridge.published('/tf_static').length;
    await until(() => sent() === 1 && bridge.published('/robot_description').length === 1, 'the first messages');

    for (let i = 1; i <= 2; i++) {
      bridge.send({ op: 'status', level: 'error', msg: 'publish /tf_static dropped: frame fixture belongs to another source (FrameTaken)' });
      await until(() => refusals.length === i, 'the refusal');
      await until(() => sent() === i + 1, 'the next attempt');
    }
    const refuse = async (topic, reason) => {
      const before = refusals.length;
      bridge.send({ op: 'status', level: 'error', msg: `publish ${topic} dropped: rule (${reason})` });
      await until(() => refusals.length > before, 'the refusal');
    };
    await refuse(PLANS[0], 'JointTaken');
    await refuse(PLANS[1], 'Unsynchronised');
    await time.until(time.now + 60_000_000_000n);
    link.publish('/last', {});
    await until(() => bridge.published('/last').length === 1, 'a later message');

    assert.deepEqual([sent(), bridge.published('/robot_description').length], [3, 1]);
    // Only a gateway that is still measuring the clock accepts the same set-points later.
    assert.deepEqual(PLANS.map(topic => bridge.published(topic).length), [1, 2]);
  });

  it('SetPoints_RefusedAndThenReplaced_AreNotSentAgain', () => {
    const queue = { pull: (_, next) => { queue.next = next; } }, kept = new KeptMessages(queue);
    kept.set('a', PLANS[0], 'first');
    kept.refused(`publish ${PLANS[0]} dropped: rule (Unsynchronised)`);

    kept.set('a', PLANS[0], 'second');
    const sent = [queue.next(), queue.next()];
    kept.repeatRefused();

    assert.deepEqual([...sent, queue.next()], ['second', null, null]);
  });

  it('SetPoints_SourceDisconnected_AreNoLongerKept', () => {
    const kept = new Map(), clock = { isSettled: true };
    const setPoints = new SetPoints(clock, { publishKept: (topic, msg) => kept.set(topic, msg), forgetKept: topic => kept.delete(topic) });
    setPoints.add('', { plan: 1 });
    clock.isSettled = false;
    setPoints.add('arm1', { plan: 2 });
    assert.deepEqual([...kept.keys()], [PLANS[0]]);

    setPoints.forget();
    clock.isSettled = true;
    setPoints.check();

    assert.deepEqual([...kept.keys()], []);
  });
});

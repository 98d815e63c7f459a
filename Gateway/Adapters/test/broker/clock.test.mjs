import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { bridge, clockOf, halls, publish, served, state } from './halls.mjs';
import { missing, Mosquitto } from './mosquitto.mjs';
import { SyncServer } from './syncServer.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { syncMessages } = messages;

describe('clock of a gateway behind a broker', { skip: missing, concurrency: 3 }, () => {
  it('Clock_OfThePlantsGateway_IsForwardedWithItsErrorBound', async t => {
    const { far, sync } = await halls(t);
    Object.assign(sync, { aheadNs: -3_600_000_000_000n, boundUs: 250, resolutionNs: 1_000_000 });

    for (let i = 0; i < 5; i++) {
      await served(far);
      const before = sync.now(), { values } = await far.call('/nowpose/plant_time/hall'), after = sync.now();
      const received = nanoseconds(values.received), sent = nanoseconds(values.sent);
      assert.ok(received >= before && sent >= received && sent <= after);
      assert.deepEqual([values.error_bound_ns, values.resolution_ns, values.synchronised], [250_000, 1_000_000, true]);
    }
    sync.isSynchronised = false;
    assert.equal((await far.call('/nowpose/plant_time/hall')).values.synchronised, false);
  });

  it('Clock_PlantsGatewayRestarted_IsRequestedAgain', async t => {
    const { far, sync, subscriber } = await halls(t);
    await served(far);

    await sync.stop();
    await subscriber.said('cannot be read');
    assert.equal((await far.call('/nowpose/plant_time/hall')).result, false);
    await sync.listen(sync.port);

    await served(far);
  });

  it('Clock_NeverRead_BridgeIsWaitingWithTheReasonAndForwardsNothingUntilItIsRead', async t => {
    const [near, far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t)]);
    await sync.stop();
    bridge(t, 'publish', near, broker);
    await until(() => near.heard.some(m => m.op === 'subscribe' && m.topic === '/signals'), 'the subscription');
    publish(near, '/signals', { header: state(sync.now()).header, name: ['closed'], value: [1] });

    const subscriber = bridge(t, 'subscribe', far, broker, clockOf(sync)), place = `127.0.0.1:${sync.port}`;

    const reason = like(syncMessages.timeUnknown(place, syncMessages.notReachable(place, ANY)));
    await until(() => reason.test(far.state?.reason), () => JSON.stringify(far.state));
    assert.equal(far.state.state, 'waiting');
    assert.doesNotMatch(far.state['signal/closed'] ?? '', /^live/);
    await sync.listen(sync.port);
    await until(() => far.state?.state === 'connected' && far.state['signal/closed']?.startsWith('live'), () => JSON.stringify(far.state) + subscriber.err);
    await until(() => far.published('/signals').length > 0, 'the signal');
  });

  it('Clock_NotKnownYet_SetPointsWaitForIt', async t => {
    const { near, broker, sync } = await halls(t);
    const points = [{ positions: [1], velocities: [], accelerations: [], time_from_start: { sec: 1, nanosec: 0 } }];
    publish(near, '/joint_trajectory', { header: state(sync.now()).header, joint_names: ['a'], points });
    publish(near, '/robot_description', { data: '<robot name="r"/>' });

    const far = await RosbridgeDouble.start(t);
    bridge(t, 'subscribe', far, broker, clockOf(sync));

    await until(() => far.published('/joint_trajectory').length > 0, 'the set-points');
    const topics = far.heard.flatMap(({ op, topic }) => (op === 'advertise_service' ? [op] : op === 'publish' ? [topic] : []));
    assert.ok(topics.indexOf('/joint_trajectory') > topics.indexOf('advertise_service'), `${topics}`);
    assert.ok(topics.includes('advertise_service'), `${topics}`);
  });

  it('Clock_TokenConfigured_IsRequestedWithTheToken', async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t, { token: 'secret-of-a' })]);
    const right = temporaryFile('token', 'secret-of-a\n'), wrong = temporaryFile('token', 'another-one\n');
    bridge(t, 'subscribe', far, broker, clockOf(sync, `, token_file: "${right}"`));
    await served(far);

    const refused = bridge(t, 'subscribe', await RosbridgeDouble.start(t), broker, clockOf(sync, `, token_file: "${wrong}"`));

    await refused.said('refuses the token');
    assert.doesNotMatch(refused.err, /another-one/);
  });
});

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { bridge, clockOf, halls, jointStatus, publish, secondsAgo, served, state } from './halls.mjs';
import { missing } from './mosquitto.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { brokerMessages, configurationMessages } = messages;

const transform = (stamp, child, x, parent = 'world') => ({
  header: { stamp, frame_id: parent }, child_frame_id: child, transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } },
});
const values = double => Object.fromEntries(double.published('/signals').flatMap(({ header, name, value }) => name.map((one, i) => [one, [value[i], nanoseconds(header.stamp)]])));

describe('objects over a broker', { skip: missing, concurrency: 3 }, () => {
  it('Bridges_ObjectsAndSignals_KeepTheirTimeStamps', async t => {
    const { near, far, sync, broker } = await halls(t);
    const at = sync.now(), { stamp } = state(at).header;

    publish(near, '/tf', { transforms: [transform(stamp, 'part', 1)] });
    publish(near, '/tf_static', { transforms: [transform(stamp, 'table', 2), transform(stamp, 'a/b+c#', 3)] });
    publish(near, '/signals', { header: { stamp, frame_id: '' }, name: ['closed', 'belt/speed'], value: [1, 0.25] });

    await until(() => far.published('/tf').length > 0 && far.published('/tf_static').length === 2 && Object.keys(values(far)).length === 2, 'all');
    assert.deepEqual(far.published('/tf')[0].transforms, [transform(stamp, 'part', 1)]);
    assert.deepEqual(values(far), { closed: [1, at], 'belt/speed': [0.25, at] });
    const stationary = far.published('/tf_static').map(({ transforms }) => [transforms[0].child_frame_id, transforms[0].transform.translation.x]);
    assert.deepEqual(stationary.sort(), [['a/b+c#', 3], ['table', 2]]);

    const later = await RosbridgeDouble.start(t);
    bridge(t, 'subscribe', later, broker, clockOf(sync));
    await served(later);

    await until(() => later.published('/tf_static').length >= 2 && Object.keys(values(later)).length === 2, 'the retained ones, later');
    assert.deepEqual(values(later), values(far));
    assert.deepEqual(later.published('/tf'), []);
  });

  it('Signal_NotCurrentAtThePlantsGateway_IsAFaultWithItsReason', async t => {
    const { near, far, sync } = await halls(t);
    publish(near, '/signals', { header: state(sync.now()).header, name: ['closed'], value: [1] });
    await until(() => far.state?.['signal/closed']?.startsWith('live'), () => JSON.stringify(far.state));

    const at = sync.now();
    publish(near, '/nowpose/signal_status', jointStatus(at, { closed: `stale ${secondsAgo(at, 5)} its source cell has ended` }));

    await until(() => far.state?.['signal/closed']?.includes('its source cell has ended'), () => JSON.stringify(far.state));
    assert.match(far.state['signal/closed'], /^fault /);
    publish(near, '/nowpose/signal_status', jointStatus(sync.now(), {}));
    await until(() => far.state?.['signal/closed']?.startsWith('live'), () => JSON.stringify(far.state));
  });

  it('Signal_PlantsGatewayRestartedWithoutItsSource_IsInFaultAndNoLongerRetained', async t => {
    const { near, far, sync, broker } = await halls(t);
    const send = (gateway, name) => publish(gateway, '/signals', { header: state(sync.now()).header, name, value: name.map(() => 1) });
    send(near, ['closed', 'running']);
    await until(() => ['closed', 'running'].every(name => far.state?.[`signal/${name}`]?.startsWith('live')), () => JSON.stringify(far.state));

    near.stop();
    const again = await RosbridgeDouble.start(t, { port: near.port });
    await until(() => again.heard.some(m => m.topic === '/nowpose/signal_status'), 'the subscriptions');
    publish(again, '/nowpose/signal_status', jointStatus(0n, {}));
    send(again, ['running']);

    await until(() => far.state?.state === 'connected' && far.state['signal/running']?.startsWith('live'), () => JSON.stringify(far.state));
    await until(() => far.state['signal/closed'].endsWith(brokerMessages.noSignal), () => JSON.stringify(far.state));
    assert.match(far.state['signal/closed'], /^fault /);
    const later = await RosbridgeDouble.start(t);
    bridge(t, 'subscribe', later, broker, clockOf(sync));
    await served(later);
    await until(() => 'running' in values(later), 'the retained signal');
    assert.deepEqual(Object.keys(values(later)), ['running']);
  });

  it('Bridges_RobotsInNamespaces_AreForwardedSeparately', async t => {
    const { near, far, sync } = await halls(t, { namespaces: ['arm1', 'arm2'] });

    for (const [robot, x] of [['/arm1', 1], ['/arm2', 2], ['', 3]]) publish(near, `${robot}/joint_states`, state(sync.now(), ['a'], [x]));
    publish(near, '/arm2/robot_description', { data: '<robot name="second"/>' });

    await until(() => ['/arm1', '/arm2', ''].every(robot => far.published(`${robot}/joint_states`).length >= 1), () => JSON.stringify(far.state));
    assert.deepEqual(['/arm1', '/arm2', ''].map(robot => far.published(`${robot}/joint_states`)[0].position[0]), [1, 2, 3]);
    await until(() => far.published('/arm2/robot_description').length === 1, 'the description');
    await until(() => ['arm1/a', 'arm2/a', 'a'].every(name => far.joint(name)?.state === 'live'), () => JSON.stringify(far.state));
    const at = sync.now();
    publish(near, '/nowpose/joint_status', jointStatus(at, { 'arm2/a': `fault ${secondsAgo(at, 3)} gone` }));
    await until(() => far.joint('arm2/a').state === 'fault', () => JSON.stringify(far.state));
    assert.deepEqual(['arm1/a', 'a'].map(name => far.joint(name).state), ['live', 'live']);
  });

  it('Check_NamespaceListedTwice_NamesItsLine', () => assert.match(wrongIn(temporaryFile('broker.yaml',
    'plant:\n  kind: broker\n  direction: publish\n  endpoint: mqtt://127.0.0.1\n  topic: a\n  namespaces: [arm1, arm1]\n'))[0],
  like(`line 6: plant.namespaces[1]: ${configurationMessages.valueTwice('arm1', ANY)}`)));
});

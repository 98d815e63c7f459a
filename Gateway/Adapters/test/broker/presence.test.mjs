// Tests how a publishing bridge announces itself, and how the other bridge uses its presence. No installed broker is needed.
import assert from 'node:assert/strict';
import { it } from 'node:test';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { bridge, clockOf, jointStatus, keepTrust, served, state, TOPIC } from './halls.mjs';
import { RefusingBroker } from './refusingBroker.mjs';
import { SyncServer } from './syncServer.mjs';
import { messages } from '../messages.mjs';

const { brokerMessages } = messages;
const { BrokerLink } = await parts('broker/brokerLink');

it('Publisher_Connected_AnnouncesItAfterItsRetainedMessagesAndRepeatedly', async t => {
  const time = VirtualTime.ofProcess(t), broker = await RefusingBroker.start(t), ending = new AbortController();
  t.after(() => ending.abort());
  broker.refuses = () => false;
  const settings = { broker: { endpoint: broker.url, user: null, authority: null, userCertificate: null }, topic: TOPIC, direction: 'publish' };
  const link = new BrokerLink(settings, 'hall', [], { opened: () => {}, away: () => {}, heard: () => {}, malformed: () => {} });
  for (const topic of ['signals/closed', 'tf_static/table']) link.publishRetained(topic, '{}');
  link.isGatewayOpen = true;

  const began = time.now, running = link.run(ending.signal);

  await until(() => broker.heard.length >= 5, () => `${broker.heard}`);
  assert.deepEqual(broker.heard.map(topic => topic.slice(TOPIC.length + 1)), ['signals/closed', 'tf_static/table', 'alive', 'alive', 'alive']);
  // A receiver waits for 6 s.
  assert.ok(time.now - began < 5_000_000_000n, `${time.now - began} ns`);
  ending.abort();
  await running;
});

// A broker that was off, or that is cut off from a broker that forwards its messages, has the presence and the values of a bridge that may be away.
for (const [name, confirm] of [
  ['PresenceRepeated', socket => RefusingBroker.publish(socket, `${TOPIC}/alive`, 'true')],
  ['MessageArrives', socket => RefusingBroker.publish(socket, `${TOPIC}/joint_states`, JSON.stringify(state(10n)))],
])
  it(`Subscriber_OnlyRetainedPresence_IsWaitingUntil${name}`, async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RefusingBroker.start(t), SyncServer.start(t)]);
    keepTrust(t);
    broker.refuses = () => false;
    const answered = new Promise(resolve => {
      broker.answered = (topic, socket) => topic === `${TOPIC}/alive` && resolve(socket);
    });
    bridge(t, 'subscribe', far, broker, clockOf(sync));
    const socket = await answered;
    await served(far);
    const retain = (topic, payload) => RefusingBroker.publish(socket, `${TOPIC}/${topic}`, payload, { isRetained: true });

    retain('joint_status', JSON.stringify(jointStatus(10n, { a: 'rest 0 no change is reported' })));
    retain('alive', 'true');

    // The messages of a connection keep their order.
    retain('robot_description', '[]');
    await until(() => far.state?.['refused/malformed'] === '1', () => JSON.stringify(far.state));
    assert.deepEqual([far.state.state, far.state.reason], ['waiting', brokerMessages.noPublisher(TOPIC)]);
    confirm(socket);
    await until(() => far.state?.state === 'connected' && far.joint('a')?.state === 'rest', () => JSON.stringify(far.state));
  });

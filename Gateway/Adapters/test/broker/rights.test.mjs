// Tests what a bridge reports if the broker does not accept its subscriptions. No installed broker is needed.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { bridge, clockOf, TOPIC } from './halls.mjs';
import { RefusingBroker } from './refusingBroker.mjs';
import { SyncServer } from './syncServer.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { brokerMessages } = messages;
const { AdapterStatus, Log, MqttLink, publish } = await parts('gateway/status', 'log', 'mqtt/link', 'broker/publish');

describe('rights on a broker', () => {
  it('Publisher_MayNotRead_IsConnectedWithANoticeThatIsLoggedOnce', async t => {
    const broker = await RefusingBroker.start(t), ending = new AbortController(), lines = [];
    const status = new AdapterStatus('broker', new Log('plant/hall', [], line => lines.push(line), () => {}));
    t.after(() => ending.abort());
    const settings = { broker: { endpoint: broker.url, user: null, authority: null }, topic: TOPIC, direction: 'publish', namespaces: [''] };
    const gateway = { isOpen: true, watch: () => {}, subscribe: () => {} }, configuration = { plant: { name: 'hall' } };

    void publish({ configuration, gateway, status, stopping: ending.signal }, settings);

    const notice = brokerMessages.notReadable(TOPIC);
    await until(() => broker.refusals === 3 && status.level === 1 && status.values().notice === notice, () => JSON.stringify(status.values()));
    assert.deepEqual([status.state, lines.filter(line => line.includes(notice)).length], ['connected', 1]);
  });

  it('Publisher_MayNotPublish_IsWaitingWithTheReasonUntilItsMessagesAreAccepted', async t => {
    const broker = await RefusingBroker.start(t), ending = new AbortController(), listeners = {};
    const status = new AdapterStatus('broker', new Log('plant/hall', [], () => {}, () => {}));
    t.after(() => ending.abort());
    const settings = { broker: { endpoint: broker.url, user: null, authority: null }, topic: TOPIC, direction: 'publish', namespaces: [''] };
    const gateway = { isOpen: true, watch: () => {}, subscribe: (topic, listen) => { listeners[topic] = listen; } };
    broker.refuses = () => false;
    broker.refusesMessage = topic => topic === `${TOPIC}/robot_description`;

    void publish({ configuration: { plant: { name: 'hall' } }, gateway, status, stopping: ending.signal }, settings);

    await until(() => status.state === 'connected', () => JSON.stringify(status.values()));
    listeners['/robot_description']({ data: '<robot/>' });
    await until(() => status.state === 'waiting', () => JSON.stringify(status.values()));
    assert.match(status.values().reason, like(brokerMessages.publicationRefused(`${TOPIC}/robot_description`, ANY)));
    broker.refusesMessage = () => false;
    listeners['/robot_description']({ data: '<robot/>' });
    await until(() => status.state === 'connected', () => JSON.stringify(status.values()));
  });

  it('Subscriber_MayNotReadJointStates_IsNotConnectedAlthoughThePublisherIsPresent', async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RefusingBroker.start(t), SyncServer.start(t)]);
    broker.refuses = topic => topic === `${TOPIC}/joint_states`;
    const answered = new Promise(resolve => {
      broker.answered = (topic, socket) => topic === `${TOPIC}/alive` && resolve(socket);
    });

    const refusal = like(brokerMessages.subscriptionRefused(`${TOPIC}/joint_states`, ANY));
    await bridge(t, 'subscribe', far, broker, clockOf(sync)).said(refusal);
    const socket = await answered;
    RefusingBroker.publish(socket, `${TOPIC}/alive`, 'true');
    // Shows that the presence before it was processed.
    RefusingBroker.publish(socket, `${TOPIC}/joint_status`, 'x');

    await until(() => far.state?.['refused/malformed'] !== undefined, () => JSON.stringify(far.state));
    assert.equal(far.state.state, 'waiting');
    assert.match(far.state.reason, refusal);
  });

  for (const [name, end] of [['IsReset', socket => socket.resetAndDestroy()], ['IsEndedByTheClient', RefusingBroker.violate]])
    it(`Subscription_Connection${name}BeforeTheResponse_IsNotReportedAsRefused`, async t => {
      const broker = await RefusingBroker.start(t), ending = new AbortController(), refusals = [], reasons = [];
      broker.refuses = () => null;
      broker.answered = (_, socket) => end(socket);
      t.after(() => ending.abort());
      const link = new MqttLink({ endpoint: broker.url, user: null, authority: null }, 'hall', ['a'], {
        opened: () => {}, away: reason => reasons.push(reason), refused: topic => refusals.push(topic), heard: () => {}, malformed: () => {},
      });

      void link.run(ending.signal);

      await until(() => reasons.length > 0, 'the end of the connection');
      assert.deepEqual(refusals, []);
      if (name === 'IsReset') assert.equal(reasons[0], brokerMessages.closed);
    });
});

// Tests what a bridge reports if the broker does not accept its subscriptions or its messages. No installed broker is needed.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { bridge, clockOf, jointStatus, keepTrust, state, TOPIC } from './halls.mjs';
import { RefusingBroker } from './refusingBroker.mjs';
import { SyncServer } from './syncServer.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { brokerMessages } = messages;
const { AdapterStatus, Log, MqttLink, publish } = await parts('gateway/status', 'log', 'mqtt/link', 'broker/publish');

/** Interval in ms at which a bridge sends refused messages again. */
const REPETITION_MS = 10_000;

const refusalOf = topic => like(brokerMessages.publicationRefused(`${TOPIC}/${topic}`, ANY));

/** Calls the functions of all intervals at which refused messages and subscriptions are repeated. */
const repeat = ({ calls }) => calls.filter(call => call.arguments[1] === REPETITION_MS).forEach(call => call.arguments[0]());

/** Starts a publishing bridge with a broker that accepts its subscriptions, and waits until it has sent its presence. */
async function publisher(t) {
  const broker = await RefusingBroker.start(t);
  broker.refuses = () => false;
  const bridge = publisherWith(t, broker);
  await bridge.reached('connected');
  await until(() => broker.heard.length > 0, 'the presence');
  return { broker, ...bridge };
}

function publisherWith(t, broker) {
  const ending = new AbortController(), listeners = {}, watchers = [], lines = [];
  const status = new AdapterStatus('broker', new Log('plant/hall', [], line => lines.push(line), () => {}));
  const settings = { broker: { endpoint: broker.url, user: null, authority: null, userCertificate: null }, topic: TOPIC, direction: 'publish', namespaces: [''] };
  const gateway = {
    isOpen: true, watch: watcher => watchers.push(watcher), subscribe: (topic, listen) => { listeners[topic] = listen; },
  };
  const running = publish({ configuration: { plant: { name: 'hall' } }, gateway, status, stopping: ending.signal }, settings);
  const stop = () => {
    ending.abort();
    return running;
  };
  t.after(stop);
  return {
    status, lines, stop,
    hear: (topic, message) => listeners[topic](message),
    gatewayOpened: () => watchers.forEach(watcher => watcher.opened()),
    /** Waits for a state and, unless it is null, a reason. */
    reached: (expected, reason = null) => until(
      () => status.state === expected && (reason === null || reason.test(status.values().reason)), () => JSON.stringify(status.values())),
  };
}

describe('rights on a broker', () => {
  it('Publisher_MayNotRead_IsConnectedWithANoticeThatIsLoggedOnce', async t => {
    const broker = await RefusingBroker.start(t);

    const { status, lines } = publisherWith(t, broker);

    const notice = brokerMessages.notReadable(TOPIC);
    await until(() => broker.refusals === 3 && status.level === 1 && status.values().notice === notice, () => JSON.stringify(status.values()));
    assert.deepEqual([status.state, lines.filter(line => line.includes(notice)).length], ['connected', 1]);
  });

  it('Publisher_RightToReadIsGivenLater_NoticeEnds', async t => {
    const broker = await RefusingBroker.start(t), { mock } = t.mock.method(globalThis, 'setInterval');
    const { status } = publisherWith(t, broker);
    await until(() => broker.refusals === 3 && status.level === 1, () => JSON.stringify(status.values()));

    broker.refuses = () => false;
    repeat(mock);

    await until(() => status.level === 0, () => JSON.stringify(status.values()));
    assert.equal(status.values().notice, undefined);
  });

  it('Publisher_MayNotPublish_IsWaitingWithTheReasonUntilItsMessagesAreAccepted', async t => {
    const { broker, hear, reached } = await publisher(t);
    broker.refusesMessage = topic => topic === `${TOPIC}/robot_description`;

    hear('/robot_description', { data: '<robot/>' });

    await reached('waiting', refusalOf('robot_description'));
    broker.refusesMessage = () => false;
    hear('/robot_description', { data: '<robot/>' });
    await reached('connected');
  });

  it('Publisher_RightsAreCorrected_SendsItsRefusedMessagesAndItsPresenceAgain', async t => {
    const { broker, hear, reached } = await publisher(t), description = `${TOPIC}/robot_description`, status = `${TOPIC}/joint_status`;
    // Excludes the presence, which the bridge also repeats by itself.
    const others = () => broker.heard.filter(topic => topic !== `${TOPIC}/alive`);
    const sent = count => until(() => others().length === count && !broker.heard.at(-1).endsWith('/robot_description'), () => broker.heard.join());
    broker.refusesMessage = topic => topic === description;
    // The bridge is already connected, so that the interval of its pings is a real one.
    t.mock.timers.enable({ apis: ['setInterval'] });
    hear('/robot_description', { data: '<robot/>' });
    hear('/nowpose/joint_status', {});
    await reached('waiting');
    await sent(2);
    broker.heard.length = 0;

    t.mock.timers.tick(REPETITION_MS);
    await sent(1);
    broker.refusesMessage = () => false;
    t.mock.timers.tick(REPETITION_MS);
    await reached('connected');
    await sent(2);
    t.mock.timers.tick(REPETITION_MS);
    hear('/nowpose/joint_status', {});
    await until(() => broker.heard.at(-1) === status, () => broker.heard.join());

    t.mock.timers.reset();
    assert.deepEqual(others(), [description, description, status]);
    broker.heard.forEach((topic, i) => assert.ok(topic !== description || broker.heard[i + 1] === `${TOPIC}/alive`, broker.heard.join()));
  });

  it('Publisher_SeveralTopicsRefused_NamesTheFirstThatIsStillRefused', async t => {
    const { broker, hear, reached } = await publisher(t);
    broker.refusesMessage = () => true;
    hear('/robot_description', { data: '<robot/>' });
    hear('/nowpose/joint_status', {});
    await reached('waiting', refusalOf('robot_description'));

    broker.refusesMessage = topic => topic === `${TOPIC}/joint_status`;
    hear('/robot_description', { data: '<robot/>' });

    await reached('waiting', refusalOf('joint_status'));
  });

  it('Publisher_RefusedRemoval_IsNotReported', async t => {
    const { broker, hear, reached, gatewayOpened } = await publisher(t);
    // Accepts the presence, which a bridge repeats every 2 s: its refusal would be reported after a pause of this process.
    broker.refusesMessage = topic => topic !== `${TOPIC}/alive`;
    hear('/signals', { header: { stamp: { sec: 1, nanosec: 0 } }, name: ['s'], value: [1] });
    await reached('waiting', refusalOf('signals/s'));

    gatewayOpened();
    await reached('connected');
    hear('/robot_description', { data: '<robot/>' });
    await reached('waiting', refusalOf('robot_description'));
  });

  it('Publisher_DisconnectedWhileItsMessagesAreRefused_CountsOneReconnection', async t => {
    const { broker, status, hear, reached } = await publisher(t);
    broker.refusesMessage = () => true;
    hear('/robot_description', { data: '<robot/>' });
    await reached('waiting', refusalOf('robot_description'));

    broker.stop();

    await reached('waiting', like(brokerMessages.refuses(broker.url)));
    assert.equal(status.values().reconnects, '1');
  });

  for (const [name, end] of [['Disconnected', ({ broker }) => broker.stop()], ['Stopped', ({ stop }) => stop()]])
    it(`Publisher_${name}WhileItsMessagesAreRefused_SendsThemNoLonger`, async t => {
      const { mock: begun } = t.mock.method(globalThis, 'setInterval'), { mock: ended } = t.mock.method(globalThis, 'clearInterval');
      const run = await publisher(t);
      run.broker.refusesMessage = () => true;
      run.hear('/robot_description', { data: '<robot/>' });
      await run.reached('waiting', refusalOf('robot_description'));
      const timers = begun.calls.filter(call => call.arguments[1] === REPETITION_MS).map(call => call.result);

      await end(run);

      await until(() => timers.every(timer => ended.calls.some(call => call.arguments[0] === timer)), 'the end of the interval');
      assert.equal(timers.length, 1);
    });

  for (const [name, announcing] of [['Before', 'joint_status'], ['After', 'alive']])
    it(`Subscriber_MayNotReadJointStatesAnnounced${name}TheRefusal_IsWaitingAndAppliesWhatArrives`, async t => {
      const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RefusingBroker.start(t), SyncServer.start(t)]);
      const refusal = like(brokerMessages.subscriptionRefused(`${TOPIC}/joint_states`, ANY)), signal = { name: ['s'], value: [1] };
      broker.refuses = topic => topic === `${TOPIC}/joint_states`;
      const answered = new Promise(resolve => {
        broker.answered = (topic, socket) => {
          if (topic === `${TOPIC}/${announcing}`) RefusingBroker.publish(socket, `${TOPIC}/alive`, 'true');
          if (topic === `${TOPIC}/alive`) resolve(socket);
        };
      });

      const { said } = bridge(t, 'subscribe', far, broker, clockOf(sync));
      const socket = await answered;
      await said(refusal);
      RefusingBroker.publish(socket, `${TOPIC}/joint_status`, JSON.stringify(jointStatus(10n, { a: 'missing 0 no such node' })));
      RefusingBroker.publish(socket, `${TOPIC}/signals/s`, JSON.stringify({ header: state(10n).header, ...signal }));

      await until(() => far.joint('a')?.state === 'missing' && far.state['signal/s']?.startsWith('live'), () => JSON.stringify(far.state));
      assert.deepEqual([far.state.state, far.state.reconnects], ['waiting', '0']);
      assert.match(far.state.reason, refusal);
    });

  it('Subscriber_PresenceNotRepeated_IsWaitingUntilThePublisherReturns', async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RefusingBroker.start(t), SyncServer.start(t)]);
    // The test ends the trust in the presence.
    const timers = keepTrust(t), { mock: ended } = t.mock.method(globalThis, 'clearTimeout');
    broker.refuses = () => false;
    const subscribed = [], answered = new Promise(resolve => {
      broker.answered = (topic, socket) => subscribed.push(topic) && topic === `${TOPIC}/alive` && resolve(socket);
    });
    bridge(t, 'subscribe', far, broker, clockOf(sync));
    const socket = await answered, { length } = subscribed;
    const reached = (name, expected) => until(() => far.state?.[name]?.startsWith(expected), () => JSON.stringify(far.state));
    const send = (topic, sent, isRetained = true) => RefusingBroker.publish(socket, `${TOPIC}/${topic}`, JSON.stringify(sent), { isRetained });
    const reports = jointStatus(10n, { a: 'rest 0 no change is reported' }), { header } = state(10n);
    const sendValues = value => [['joint_status', reports], ['signals/s', { header, name: ['s'], value: [value] }]].forEach(one => send(...one));
    sendValues(1);
    send('alive', true, false);
    await reached('state', 'connected');
    await reached('signal/s', 'live');

    timers()[0].arguments[0]();

    await reached('reason', brokerMessages.bridgeSilent(6));
    assert.deepEqual([far.state.state, far.joint('a').state, far.state['signal/s'].split(' ')[0]], ['waiting', 'fault', 'fault']);
    // After a failure between two brokers, the broker still has the old values, and sends them only to a new subscription.
    broker.answered = topic => subscribed.push(topic) && topic === `${TOPIC}/signals/+` && sendValues(1);
    send('alive', true, false);
    await reached('state', 'connected');
    await until(() => far.state['signal/s'].endsWith(brokerMessages.noSignal), () => JSON.stringify(far.state));
    assert.deepEqual([subscribed.length, far.joint('a').state], [length, 'fault']);
    sendValues(2);
    await reached('joint/a', 'rest');
    await reached('signal/s', 'live');
    send('alive', true, false);
    await until(() => ended.calls.some(call => call.arguments[0] === timers()[1].result), 'the confirmation');
    assert.equal(timers().length, 3);

    // If another broker forwards the messages, and the connection between the brokers fails, no will arrives.
    timers()[2].arguments[0]();

    await reached('reason', brokerMessages.bridgeSilent(6));
    assert.deepEqual([far.state.state, far.joint('a').state], ['waiting', 'fault']);
  });

  it('Subscriber_RightToReadIsGivenLater_SubscribesAgainAndIsConnected', async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RefusingBroker.start(t), SyncServer.start(t)]), subscribed = [];
    const { mock } = t.mock.method(globalThis, 'setInterval'), refused = [`${TOPIC}/joint_states`, `${TOPIC}/alive`];
    broker.refuses = topic => refused.includes(topic);
    broker.answered = (topic, socket) => {
      subscribed.push(topic);
      if (topic === `${TOPIC}/alive` && !broker.refuses(topic)) RefusingBroker.publish(socket, topic, 'true');
    };
    bridge(t, 'subscribe', far, broker, clockOf(sync));
    const reached = (name, expected) => until(() => far.state?.[name]?.startsWith(expected), () => JSON.stringify(far.state));
    await reached('reason', `the broker refuses the subscription to ${refused[0]}`);
    await until(() => subscribed.includes(refused[1]), () => subscribed.join());

    const [states] = refused.splice(0, 1);
    repeat(mock);
    await reached('reason', `the broker refuses the subscription to ${refused[0]}`);
    subscribed.length = 0;
    const [alive] = refused.splice(0, 1);
    repeat(mock);

    await reached('state', 'connected');
    assert.deepEqual([states, subscribed], [`${TOPIC}/joint_states`, [alive]]);
  });

  it('Subscriber_MayNotReadJointStatesAndPublisherReturns_IsWaitingBecauseOfTheRefusal', async t => {
    const [far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RefusingBroker.start(t), SyncServer.start(t)]);
    broker.refuses = topic => topic === `${TOPIC}/joint_states`;
    const answered = new Promise(resolve => {
      broker.answered = (topic, socket) => topic === `${TOPIC}/alive` && resolve(socket);
    });
    const refusal = like(brokerMessages.subscriptionRefused(`${TOPIC}/joint_states`, ANY));
    const { said } = bridge(t, 'subscribe', far, broker, clockOf(sync)), socket = await answered;
    await said(refusal);

    RefusingBroker.publish(socket, `${TOPIC}/alive`, 'false');
    await until(() => far.state?.reason === brokerMessages.bridgeAway, () => JSON.stringify(far.state));
    RefusingBroker.publish(socket, `${TOPIC}/alive`, 'true');

    await until(() => refusal.test(far.state?.reason), () => JSON.stringify(far.state));
    assert.equal(far.state.state, 'waiting');
  });

  for (const [name, end] of [['IsReset', socket => socket.resetAndDestroy()], ['IsEndedByTheClient', RefusingBroker.violate]])
    it(`Subscription_Connection${name}BeforeTheResponse_IsNotReportedAsRefused`, async t => {
      const broker = await RefusingBroker.start(t), ending = new AbortController(), refusals = [], reasons = [];
      broker.refuses = () => null;
      broker.answered = (_, socket) => end(socket);
      t.after(() => ending.abort());
      const link = new MqttLink({ endpoint: broker.url, user: null, authority: null, userCertificate: null }, 'hall', ['a'], {
        opened: () => {}, away: reason => reasons.push(reason), refused: topic => refusals.push(topic), heard: () => {}, malformed: () => {},
      });

      void link.run(ending.signal);

      await until(() => reasons.length > 0, 'the end of the connection');
      assert.deepEqual(refusals, []);
      if (name === 'IsReset') assert.equal(reasons[0], brokerMessages.closed);
    });
});

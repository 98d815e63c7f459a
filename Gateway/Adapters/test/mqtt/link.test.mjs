// Tests how an MQTT link, and the adapter with it, connects, subscribes and ends with a broker that refuses something or does not respond.
// No installed broker is needed.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { RefusingBroker } from '../broker/refusingBroker.mjs';
import { ANY, like, messages } from '../messages.mjs';
import { parts } from '../parts.mjs';
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { clockAhead, configuration } from './cell.mjs';

const { brokerMessages, mqttMessages } = messages;
const { MqttLink } = await parts('mqtt/link');

const USER = { name: 'hall', password: 'of-the-hall' };

/** Interval in ms at which a link repeats refused subscriptions, and time for its goodbye. */
const REPETITION_MS = 10_000, GOODBYE_MS = 500;

/** Calls the functions of all intervals at which refused subscriptions are repeated. */
const repeat = ({ calls }) => calls.filter(call => call.arguments[1] === REPETITION_MS).forEach(call => call.arguments[0]());

/** Starts a link. `heard` has the calls of its events, as lists of the name and the arguments. */
async function linkTo(t, broker, topics = [], { user = null, options, leaving } = {}) {
  const ending = new AbortController(), heard = [];
  const events = Object.fromEntries(['opened', 'away', 'refused', 'subscriptionRefused', 'heard', 'malformed'].map(name => [name, (...all) => heard.push([name, ...all])]));
  const link = new MqttLink({ endpoint: broker.url, user, authority: null, userCertificate: null }, 'hall', topics, { ...events, leaving: () => leaving?.(link) }, options);
  const cell = { heard, isEnded: false, stop: () => ending.abort(), named: name => heard.filter(([one]) => one === name) };
  void link.run(ending.signal).then(() => { cell.isEnded = true; });
  t.after(cell.stop);
  return cell;
}

describe('mqtt link', () => {
  for (const [name, user, code, minMs] of [
    ['WrongPassword', USER, 134, 24_000], ['NotAuthorised', USER, 135, 24_000], ['WithoutUser', null, 135, 160], ['OtherRefusal', USER, 136, 160],
  ])
    it(`Login_${name}_NextAttemptIsAfterAtLeast${minMs}ms`, async t => {
      const broker = await RefusingBroker.start(t), { mock } = t.mock.method(globalThis, 'setTimeout');
      broker.connectCode = code;
      const cell = await linkTo(t, broker, [], { user });

      await until(() => cell.named('away').length > 0, 'the refusal');

      const [[, reason]] = cell.named('away'), { loginRefused, anonymousRefused, refusesWith } = brokerMessages;
      const expected = code === 136 ? refusesWith(broker.url, ANY) : (user === null ? anonymousRefused : loginRefused)(broker.url);
      assert.match(reason, like(expected));
      // The delay varies by 20 %.
      await until(() => mock.calls.some(({ arguments: [, ms] }) => ms >= minMs && ms <= 1.5 * minMs), 'the delay');
    });

  it('Subscription_RefusedThenAccepted_IsRepeatedUntilItIsAccepted', async t => {
    const broker = await RefusingBroker.start(t), { mock } = t.mock.method(globalThis, 'setInterval'), asked = [];
    broker.refuses = topic => topic === 'b';
    broker.answered = topic => asked.push(topic);
    const cell = await linkTo(t, broker, ['a', 'b']);
    const isRefused = () => cell.named('subscriptionRefused').at(-1)?.[1] ?? null;
    await until(() => isRefused() !== null && asked.length === 2, () => JSON.stringify(cell.heard));

    repeat(mock);
    await until(() => cell.named('refused').length === 2, () => JSON.stringify(cell.heard));
    broker.refuses = () => false;
    repeat(mock);
    await until(() => isRefused() === null, () => JSON.stringify(cell.heard));

    assert.deepEqual(asked, ['a', 'b', 'b', 'b']);
    assert.deepEqual([...new Set(cell.named('refused').map(([, topic]) => topic))], ['b']);
  });

  it('Adapter_SubscriptionRefusedThenAccepted_ItsValuesWaitForAMessage', async t => {
    const [broker, bridge] = await Promise.all([RefusingBroker.start(t), RosbridgeDouble.start(t, { now: clockAhead(0) })]);
    const { mock } = t.mock.method(globalThis, 'setInterval'), rest = 'joints: [{ joint: a, topic: b }]\nsignals: [{ signal: s, topic: b }]\n';
    start(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, broker.url, { rest }))]);
    const reached = reason => until(
      () => bridge.joint('a')?.reason.startsWith(reason) && bridge.state['signal/s']?.includes(reason), () => JSON.stringify(bridge.state));
    await reached('the broker refuses the subscription to b');

    broker.refuses = () => false;
    repeat(mock);

    await reached(mqttMessages.accepted('b'));
    assert.deepEqual([bridge.joint('a').state, bridge.state['reason/a']], ['missing', 'not-connected']);
  });

  // A broker may send a message before its response to the subscription.
  for (const [name, payload, reason] of [['Retained', '{"x":1}', mqttMessages.retained], ['Malformed', '{', mqttMessages.notJson('b')]])
    it(`Adapter_${name}MessageBeforeTheAcceptance_KeepsItsReason`, async t => {
      const [broker, bridge] = await Promise.all([RefusingBroker.start(t), RosbridgeDouble.start(t, { now: clockAhead(0) })]);
      const { mock } = t.mock.method(globalThis, 'setInterval'), topics = ['b', 'next'];
      const rest = `joints: [${topics.map(topic => `{ joint: ${topic}, topic: ${topic}, field: x }`)}]\n`;
      const reached = (joint, expected) => until(() => bridge.joint(joint)?.reason.startsWith(expected), () => JSON.stringify(bridge.state));
      let connection;
      broker.refuses = topic => topic === 'b';
      broker.answered = (_, socket) => connection = socket;
      start(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, broker.url, { rest }))]);
      await reached('b', 'the broker refuses the subscription to b');

      broker.refuses = topic => RefusingBroker.publish(connection, topic, payload, { isRetained: true });
      broker.answered = () => RefusingBroker.publish(connection, 'next', '[');
      repeat(mock);

      await reached('next', mqttMessages.notJson('next'));
      assert.equal(bridge.joint('b').reason, reason);
    });

  it('Link_StoppedWhileTheBrokerDoesNotRespond_EndsAfterTheGoodbye', async t => {
    const broker = await RefusingBroker.start(t), { mock } = t.mock.method(globalThis, 'setTimeout');
    // Without pings, nothing else ends the connection.
    const cell = await linkTo(t, broker, [], { options: { keepalive: 0 }, leaving: link => link.client.publish('alive', 'false', { qos: 1 }) });
    await until(() => cell.named('opened').length > 0, 'the connection');
    broker.isSilent = true;

    cell.stop();
    mock.calls.find(call => call.arguments[1] === GOODBYE_MS).arguments[0]();

    await until(() => cell.isEnded, 'the end');
  });
});

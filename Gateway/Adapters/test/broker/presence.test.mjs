// Tests in virtual time how a publishing bridge announces itself. No installed broker is needed.
import assert from 'node:assert/strict';
import { it } from 'node:test';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { TOPIC } from './halls.mjs';
import { RefusingBroker } from './refusingBroker.mjs';

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

// Tests what a bridge reports if the broker refuses its subscriptions. No installed broker is needed.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { until } from '../program.mjs';
import { TOPIC } from './halls.mjs';
import { RefusingBroker } from './refusingBroker.mjs';
import { messages } from '../messages.mjs';

const { brokerMessages } = messages;
const { AdapterStatus, Log, publish } = await parts('gateway/status', 'log', 'broker/publish');

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
});

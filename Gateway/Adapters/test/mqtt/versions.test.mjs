// Tests brokers without MQTT 5.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { changes, clockAhead, configuration } from './cell.mjs';
import { startOlderBroker } from './olderBroker.mjs';

describe('versions of MQTT', () => {
  for (const code of [1, 132])
    it(`Broker_RefusesMqtt5WithCode${code}_IsReadWithMqtt311`, async t => {
      const broker = await startOlderBroker(t, 'cell/closed', 'true', code), bridge = await RosbridgeDouble.start(t, { now: clockAhead(0) });

      const run = start(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, broker.url, { rest: 'signals:\n  - { signal: closed, topic: cell/closed }\n' }))]);

      await until(() => changes(bridge, 'closed').some(([value]) => value === 1), () => run.err);
      await until(() => bridge.state?.state === 'connected', () => JSON.stringify(bridge.state));
      assert.deepEqual(broker.versions, [5, 4]);
      assert.ok(!run.err.includes('waiting'), run.err);
    });
});

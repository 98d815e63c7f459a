// Tests brokers without MQTT 5.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { changes, clockAhead, configuration } from './cell.mjs';
import { startOlderBroker } from './olderBroker.mjs';

const { brokerMessages } = messages;

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

  it('Broker_SendsAnEndlessPacketWithMqtt311_IsDisconnectedWithAReason', async t => {
    const broker = await startOlderBroker(t, 'cell/closed', '', 1, socket => {
      // The header announces 256 MiB.
      socket.write(Buffer.of(0x30, 0xff, 0xff, 0xff, 0x7f));
      const send = () => { while (!socket.destroyed && socket.write(Buffer.alloc(65536))); };
      socket.on('drain', send);
      send();
    });
    const bridge = await RosbridgeDouble.start(t, { now: clockAhead(0) });

    const run = start(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, broker.url, { rest: 'signals:\n  - { signal: closed, topic: cell/closed }\n' }))]);

    await until(() => run.err.includes(brokerMessages.packetTooLong(1088)), () => run.err);
    await until(() => broker.sent().length >= 2, () => 'the adapter connects again');
    assert.ok(Math.max(...broker.sent()) < 64 * 1024 * 1024, `${broker.sent()} bytes`);
  });
});

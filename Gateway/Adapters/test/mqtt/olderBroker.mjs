// A broker without MQTT 5, which has one retained message.
import { createServer } from 'node:net';

const CONNECT = 1, SUBSCRIBE = 8, PING = 12, MQTT_3_1_1 = 4, UNACCEPTABLE_VERSION = 1;

const text = value => Buffer.concat([Buffer.of(0, value.length), Buffer.from(value)]);

/**
 * Starts the broker, which refuses MQTT 5 with the code `refusal`. Resolves with its address, the protocol versions of all connections, and the number
 * of bytes that it has sent on each connection that subscribed.
 * @param publish Sends what follows a subscription; the retained message by default.
 */
export async function startOlderBroker(test, topic, message, refusal = UNACCEPTABLE_VERSION, publish = null) {
  const sockets = new Set(), subscribed = [], versions = [];
  const server = createServer(socket => {
    sockets.add(socket.on('error', () => {}));
    let received = Buffer.alloc(0);
    socket.on('data', data => {
      received = Buffer.concat([received, data]);
      // The packets of this test are shorter than 128 bytes, so their length is one byte.
      for (; received.length >= 2 && received.length >= 2 + received[1]; received = received.subarray(2 + received[1]))
        take(socket, received[0] >> 4, received.subarray(2, 2 + received[1]));
    });
  });
  function take(socket, type, body) {
    // The version follows the name of the protocol, MQTT.
    if (type === CONNECT) versions.push(body[6]);
    if (type === CONNECT && body[6] !== MQTT_3_1_1) return socket.end(Buffer.of(0x20, 2, 0, refusal));
    if (type === CONNECT) socket.write(Buffer.of(0x20, 2, 0, 0));
    if (type === PING) socket.write(Buffer.of(0xd0, 0));
    if (type !== SUBSCRIBE) return;
    socket.write(Buffer.of(0x90, 3, body[0], body[1], 1));
    subscribed.push(socket);
    if (publish !== null) return publish(socket);
    const publication = Buffer.concat([text(topic), Buffer.from(message)]);
    socket.write(Buffer.concat([Buffer.of(0x31, publication.length), publication]));
  }
  await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
  test.after(() => {
    for (const socket of sockets) socket.destroy();
    server.close();
  });
  return { url: `mqtt://127.0.0.1:${server.address().port}`, versions, sent: () => subscribed.map(({ bytesWritten }) => bytesWritten) };
}

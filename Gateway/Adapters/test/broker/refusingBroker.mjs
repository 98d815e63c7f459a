// A broker that accepts each connection and refuses subscriptions or messages.
import { createServer } from 'node:net';
import { freePort } from '../freePort.mjs';

const CONNECT = 1, PUBLISH = 3, SUBSCRIBE = 8, PING = 12, NOT_AUTHORISED = 0x87;
const connack = code => Buffer.of(0x20, 3, 0, code, 0), PONG = Buffer.of(0xd0, 0);

export class RefusingBroker {
  refusals = 0;
  /** Returns whether the subscription to a topic is refused; null for no response. */
  refuses = () => true;
  /** Returns whether a message on a topic is refused. */
  refusesMessage = () => false;
  /** Reason code of the response to a connection; 0 accepts it. */
  connectCode = 0;
  /** While true, the broker reads packets but does not respond to them. */
  isSilent = false;
  /** Called with the topic and the connection after each subscription, and after the response unless there is none. */
  answered = () => {};
  /** Topics of all messages. */
  heard = [];

  static async start(test) {
    const broker = new RefusingBroker(), sockets = new Set(), port = await freePort();
    const server = createServer(socket => {
      sockets.add(socket);
      broker.#serve(socket);
    });
    await new Promise(resolve => server.listen(port, '127.0.0.1', resolve));
    broker.stop = () => {
      for (const socket of sockets) socket.destroy();
      server.close();
    };
    test.after(broker.stop);
    broker.url = `mqtt://127.0.0.1:${port}`;
    return broker;
  }

  #serve(socket) {
    let received = Buffer.alloc(0);
    socket.on('error', () => {});
    socket.on('data', data => {
      received = Buffer.concat([received, data]);
      // The packets of this test are shorter than 128 bytes, so their length is one byte.
      while (received.length >= 2 && received.length >= 2 + received[1]) {
        const type = received[0] >> 4, body = received.subarray(2, 2 + received[1]);
        received = received.subarray(2 + received[1]);
        if (this.isSilent) continue;
        if (type === CONNECT) socket.write(connack(this.connectCode));
        if (type === PUBLISH) {
          const end = 2 + body.readUInt16BE(0), topic = body.subarray(2, end).toString();
          socket.write(Buffer.of(0x40, 3, body[end], body[end + 1], this.refusesMessage(topic) ? NOT_AUTHORISED : 0));
          this.heard.push(topic);
        }
        if (type === PING) socket.write(PONG);
        if (type === SUBSCRIBE) this.#answer(socket, body.subarray(0, 2), body.subarray(5, 5 + body.readUInt16BE(3)).toString());
      }
    });
  }

  #answer(socket, id, topic) {
    const isRefused = this.refuses(topic);
    if (isRefused === null) return void this.answered(topic, socket);
    socket.write(Buffer.of(0x90, 4, ...id, 0, isRefused ? NOT_AUTHORISED : 0));
    if (isRefused) this.refusals++;
    this.answered(topic, socket);
  }

  /** Sends a message of up to 16 kB. */
  static publish(socket, topic, payload, { isRetained = false } = {}) {
    const body = Buffer.concat([Buffer.of(0, topic.length), Buffer.from(topic), Buffer.of(0), Buffer.from(payload)]);
    const length = body.length < 128 ? [body.length] : [128 + body.length % 128, body.length >> 7];
    socket.write(Buffer.concat([Buffer.of(isRetained ? 0x31 : 0x30, ...length), body]));
  }

  /** Sends a second CONNACK, after which a client ends the connection at once. */
  static violate(socket) {
    socket.write(connack(0));
  }
}

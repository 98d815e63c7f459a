// A broker that accepts each connection and refuses each subscription.
import { createServer } from 'node:net';

const CONNECT = 1, SUBSCRIBE = 8, NOT_AUTHORISED = 0x87;

export class RefusingBroker {
  refusals = 0;

  static async start(test) {
    const broker = new RefusingBroker(), sockets = new Set();
    const server = createServer(socket => {
      sockets.add(socket);
      broker.#serve(socket);
    });
    await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
    test.after(() => {
      for (const socket of sockets) socket.destroy();
      server.close();
    });
    broker.url = `mqtt://127.0.0.1:${server.address().port}`;
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
        if (type === CONNECT) socket.write(Buffer.of(0x20, 3, 0, 0, 0));
        if (type !== SUBSCRIBE) continue;
        socket.write(Buffer.of(0x90, 4, body[0], body[1], 0, NOT_AUTHORISED));
        this.refusals++;
      }
    });
  }
}

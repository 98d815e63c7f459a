// Simulates the sync port of a gateway as specified in the protocol: requests and replies of 48 bytes, preceded by a token if one is required.
import { once } from 'node:events';
import { createServer } from 'node:net';
import { freePort } from '../freePort.mjs';

const magic = 0x434e5953;

export class SyncServer {
  /** Time of the simulated clock minus that of this machine's clock, in ns. The next three fields contain the clock quality that the port reports. */
  aheadNs = 0n;
  boundUs = 0;
  resolutionNs = 0;
  isSynchronised = true;
  isSilent = false;
  exchanges = 0;
  /** Changes the replies to time requests before they are sent. */
  distort = () => {};
  #sockets = new Set();

  static async start(test, { token } = {}) {
    const server = new SyncServer();
    server.token = token;
    await server.listen();
    test.after(() => server.stop());
    return server;
  }

  now() {
    return BigInt(Math.round((performance.timeOrigin + performance.now()) * 1e6)) + this.aheadNs;
  }

  async listen(port) {
    this.port = port ?? await freePort();
    this.server = createServer(socket => this.#serve(socket)).listen(this.port, '127.0.0.1');
    await once(this.server, 'listening');
  }

  stop() {
    for (const socket of this.#sockets) socket.destroy();
    return new Promise(resolve => this.server.close(resolve));
  }

  #serve(socket) {
    let bytes = Buffer.alloc(0), isIn = this.token === undefined;
    this.#sockets.add(socket);
    socket.on('close', () => this.#sockets.delete(socket));
    socket.on('error', () => {});
    socket.on('data', part => {
      bytes = Buffer.concat([bytes, part]);
      while (bytes.length >= 48) {
        const received = this.now();
        if (bytes.readUInt32LE(0) !== magic || bytes.readUInt8(4) !== 1) return void socket.destroy();
        const kind = bytes.readUInt8(5), length = kind === 0x10 ? 50 + bytes.readUInt16LE(48) : 48;
        if (bytes.length < length) return;
        const frame = bytes.subarray(0, 48);
        if (kind === 0x10) {
          isIn = bytes.toString('utf8', 50, length) === this.token;
          this.#answer(socket, frame, 0x11, isIn ? 1 : 0, 0n);
        } else if (!isIn || kind !== 1) {
          return void socket.destroy();
        } else if (!this.isSilent) {
          this.exchanges++;
          this.#answer(socket, frame, 2, this.isSynchronised ? 0 : 1, received);
        }
        bytes = bytes.subarray(length);
      }
    });
  }

  #answer(socket, frame, kind, flags, received) {
    const reply = Buffer.from(frame);
    reply.writeUInt8(kind, 5);
    reply.writeUInt16LE(flags, 6);
    if (kind === 2) {
      reply.writeUInt32LE(this.boundUs, 12);
      reply.writeUInt32LE(this.resolutionNs, 40);
      reply.writeBigInt64LE(received, 24);
      reply.writeBigInt64LE(this.now(), 32);
    }
    if (kind === 2) this.distort(reply);
    socket.write(reply);
  }
}

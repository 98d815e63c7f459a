// Serves ADS clients over TCP like the runtime of a TwinCAT PLC (port 851) and its system service (port 10000).
import { once } from 'node:events';
import { createServer } from 'node:net';
import {
  answer, command, error, FrameReader, group, netIdBytes, parseAms, readResult, result, tcpCommand, tcpFrame, words,
} from './frames.mjs';
import { freePort } from '../freePort.mjs';
import { Notifications } from './notifications.mjs';
import { symbolEntry } from './symbols.mjs';

export const runtimePort = 851;
const systemPort = 10000;

export class AdsServer {
  #server = createServer(socket => this.#serve(socket));
  #sockets = new Set();
  /** The notifications of each AMS address. They stay if the connection ends, and continue on the next connection from the address. */
  #notifications = new Map();
  #downloaded = () => this.#notifications.forEach(each => each.invalidate());
  #handles = new Map();
  #nextPort = 32905;
  #connections = 0;

  /**
   * `routes` are the AMS Net Ids of the accepted senders. The server closes the connection of any other sender, like TwinCAT without a route. `isSole`
   * means that a new connection ends the previous ones, like a TwinCAT router does with the connections of one machine.
   * `maxNotifications` is the maximum number of notifications per AMS address.
   */
  constructor(plc, { netId = '5.24.12.7.1.1', routes, isSole = false, maxNotifications = Infinity } = {}) {
    this.plc = plc;
    this.isSole = isSole;
    this.maxNotifications = maxNotifications;
    this.netId = netId;
    this.routes = routes;
    /** All received requests, with the numbers of their connections. */
    this.seen = [];
    /** While true, the server reads requests but does not respond to them. */
    this.silent = false;
    /** Sends the response to a command. A test may replace it to send responses later; it also gets the data of the request. */
    this.respond = (_, send) => send();
    plc.downloaded.add(this.#downloaded);
  }

  async listen(port, host = '127.0.0.1') {
    this.#server.listen(port ?? await freePort(), host);
    await once(this.#server, 'listening');
    return this.#server.address().port;
  }

  get notifications() {
    return [...this.#notifications.values()].reduce((sum, { count }) => sum + count, 0);
  }

  /** Returns the times of the samples of a variable that each packet contains. Leaves out packets without a sample of the variable. */
  packetsOf(symbol) {
    const packets = [...this.#notifications.values()].flatMap(({ sent }) => sent);
    return packets.map(samples => samples.filter(({ offset }) => offset === symbol.offset).map(({ time }) => time)).filter(times => times.length > 0);
  }

  /** Closes all connections without a message, like an unplugged cable. */
  drop() {
    for (const socket of this.#sockets) socket.destroy();
  }

  /** Ends without a message, like a power failure. */
  async close() {
    this.plc.downloaded.delete(this.#downloaded);
    this.drop();
    for (const each of this.#notifications.values()) each.close();
    if (this.#server.listening) await new Promise(resolve => this.#server.close(resolve));
  }

  #serve(socket) {
    const reader = new FrameReader();
    if (this.isSole) this.drop();
    const number = ++this.#connections;
    this.#sockets.add(socket);
    socket.setNoDelay(true);
    socket.on('error', () => {});
    socket.on('close', () => this.#sockets.delete(socket));
    socket.on('data', bytes => {
      try {
        for (const frame of reader.read(bytes)) this.#take(frame, number, socket);
      } catch {
        socket.destroy();
      }
    });
  }

  #take({ kind, data }, number, socket) {
    if (this.silent) return;
    if (kind === tcpCommand.openPort) {
      const port = Buffer.alloc(2);
      port.writeUInt16LE(data.readUInt16LE(0) || this.#nextPort++);
      socket.write(tcpFrame(tcpCommand.openPort, Buffer.concat([netIdBytes('127.0.0.1.1.1'), port])));
    } else if (kind === tcpCommand.closePort) {
      socket.end();
    } else if (kind === tcpCommand.ads) {
      const asked = parseAms(data);
      if (this.routes && !this.routes.includes(asked.source.netId)) return void socket.destroy();
      const code = this.#unreachable(asked.target);
      const reply = code ? Buffer.alloc(0) : this.#reply(asked, this.#notificationsOf(asked.source, socket), number);
      this.respond(asked.command, () => socket.write(answer(asked, reply, code)), asked.data);
    }
  }

  /** Returns the notifications of an AMS address, which the PLC sends to its newest connection. */
  #notificationsOf({ netId, port }, socket) {
    const address = `${netId}:${port}`, found = this.#notifications.get(address) ?? new Notifications(this.plc);
    found.send = frame => socket.write(frame);
    this.#notifications.set(address, found);
    return found;
  }

  #unreachable({ netId, port }) {
    if (netId !== this.netId && netId !== '127.0.0.1.1.1') return error.targetMachine;
    if (port === systemPort || port === runtimePort && this.plc.systemState === 5) return 0;
    return error.targetPort;
  }

  #reply(asked, notifications, connection) {
    const { data } = asked;
    const [indexGroup, indexOffset, length] = [0, 4, 8].map(at => data.length >= at + 4 ? data.readUInt32LE(at) : 0);
    this.seen.push({ command: asked.command, group: indexGroup, port: asked.target.port, connection });
    switch (asked.command) {
      case command.readDeviceInfo:
        return Buffer.concat([result(0), Buffer.from([3, 1]), Buffer.from(new Uint16Array([4024]).buffer), Buffer.from('Plc30 App'.padEnd(16, '\0'))]);
      case command.readState:
        return Buffer.concat([result(0), this.#states(asked.target.port)]);
      case command.read:
        return given(this.#read(asked.target.port, indexGroup, indexOffset, length));
      case command.readWrite:
        return given(this.#readWrite(indexGroup, indexOffset, data.subarray(16)));
      case command.addNotification: {
        const [transmission, maxDelay, cycleTime] = [12, 16, 20].map(at => data.readUInt32LE(at));
        const place = this.#place(indexGroup, indexOffset);
        const first = this.plc.read(place.indexGroup, place.indexOffset, length);
        if (typeof first === 'number') return result(first);
        if (notifications.count >= this.maxNotifications) return result(error.noMemory);
        return words(0, notifications.add(asked.source, asked.target, { ...place, length, transmission, maxDelay, cycleTime }));
      }
      case command.deleteNotification:
        return result(notifications.remove(indexGroup) ? 0 : error.invalidHandle);
      case command.write:
        return result(indexGroup === group.releaseHandle && this.#handles.delete(data.readUInt32LE(12)) ? 0 : error.invalidAccess);
      default:
        return result(error.serviceNotSupported);
    }
  }

  #states(port) {
    const bytes = Buffer.alloc(4);
    bytes.writeUInt16LE(port === systemPort ? this.plc.systemState : this.plc.plcState);
    return bytes;
  }

  #read(port, indexGroup, indexOffset, length) {
    if (port === systemPort && indexGroup === group.systemState)
      return Buffer.concat([this.#states(port), Buffer.from([7, 0, 3, 1, 0xb8, 0x0f, 2, 0, 0, 0, 0, 0])]).subarray(0, length);
    const place = this.#place(indexGroup, indexOffset);
    return this.plc.read(place.indexGroup, place.indexOffset, length);
  }

  /** Converts a handle to the memory address of its variable; returns any other address unchanged. */
  #place(indexGroup, indexOffset) {
    const symbol = indexGroup === group.valueByHandle ? this.#handles.get(indexOffset) : undefined;
    return symbol ? { indexGroup: group.memory, indexOffset: symbol.offset } : { indexGroup, indexOffset };
  }

  #readWrite(indexGroup, indexOffset, written) {
    if (indexGroup === group.sumRead) return this.#sumRead(indexOffset, written);
    const name = written.toString('latin1').replace(/\0.*$/s, '');
    const symbol = this.plc.find(name);
    if (!symbol) return error.symbolNotFound;
    switch (indexGroup) {
      case group.handleByName: {
        const handle = 0x10000 + this.#handles.size;
        this.#handles.set(handle, symbol);
        return words(handle);
      }
      case group.valueByName: return symbol.image(this.plc.cycleTime());
      case group.infoByName: return words(group.memory, symbol.offset, symbol.size);
      case group.infoByNameEx: return symbolEntry(symbol, group.memory);
      default: return error.invalidGroup;
    }
  }

  /** Reads several variables, given by group, offset and length. Returns all results, then all data, padded to the requested lengths. */
  #sumRead(count, written) {
    const asked = [...Array(count).keys()].map(i => [0, 4, 8].map(at => written.readUInt32LE(12 * i + at)));
    const time = this.plc.cycleTime();
    const read = asked.map(([indexGroup, indexOffset, length]) => {
      const place = this.#place(indexGroup, indexOffset);
      return this.plc.read(place.indexGroup, place.indexOffset, length, time);
    });
    const results = read.map(r => typeof r === 'number' ? r : 0);
    return Buffer.concat([words(...results), ...read.map((r, i) => typeof r === 'number' ? Buffer.alloc(asked[i][2]) : r)]);
  }
}

const given = read => typeof read === 'number' ? words(read, 0) : readResult(read);

// Simulates the RTDE server of a controller with selectable faults, without the code of the adapter.
import { createServer } from 'node:net';
import { freePort } from '../freePort.mjs';
import { byte, doubles, int, packageOf } from './bytes.mjs';

const TYPES = {
  timestamp: 'DOUBLE', actual_q: 'VECTOR6D', actual_qd: 'VECTOR6D', target_q: 'VECTOR6D', target_qd: 'VECTOR6D', runtime_state: 'UINT32',
  robot_mode: 'INT32', safety_mode: 'INT32', safety_status_bits: 'UINT32', actual_digital_output_bits: 'UINT64', actual_TCP_pose: 'VECTOR6D',
  tool_output_voltage: 'INT32',
};

const RUNNING = 7, PLAYING = 2, NORMAL = 1;

/** Time in s by which the arm lags behind the commanded positions. */
export const LAG_S = 0.006;

/** Returns the angle of a joint in rad at a given time of the controller's clock in s. */
export const angle = (joint, seconds) => 0.3 * joint + 0.4 * Math.sin((0.9 + 0.1 * joint) * seconds);

export class RtdeRobot {
  /** Types of the received requests, as characters. */
  requests = [];
  frequencies = [];
  recipes = [];
  state = { runtime: PLAYING, mode: RUNNING, safety: NORMAL, bits: 1 };
  outputBits = 0;
  toolPose = [0, 0, 0, 0, 0, 0];
  /** Fields that this controller does not have. `types` contains fields whose type differs from the guide. */
  missing = [];
  types = {};
  /** Version of the controller; null if the controller does not respond to the request for the version. */
  version = [5, 11, 1, 108318];
  accepts = 2;
  isAnsweringWhileStreaming = true;
  /** The controller loses each package whose number is a multiple of this value. */
  losesEach = Infinity;
  sendsHalf = false;
  stands = false;
  #sockets = new Set();
  #server = null;
  #timer = null;
  #zero = performance.now() / 1000 - 100;

  constructor({ rateHz = 125, ...options } = {}) {
    this.rateHz = rateHz;
    Object.assign(this, options);
  }

  async listen(test, port) {
    this.port = port ?? await freePort();
    this.#server = createServer(socket => this.#serve(socket));
    await new Promise(resolve => this.#server.listen(this.port, '127.0.0.1', resolve));
    test.after(() => this.stop());
    return this;
  }

  get now() { return performance.now() / 1000 - this.#zero; }

  /** Sets the clock to zero. */
  restart() { this.#zero = performance.now() / 1000; }

  drop() { for (const socket of this.#sockets) socket.destroy(); }

  send(bytes) { for (const socket of this.#sockets) socket.write(bytes); }

  stop() {
    clearInterval(this.#timer);
    this.drop();
    this.#server.close();
  }

  #serve(socket) {
    this.#sockets.add(socket);
    socket.setNoDelay(true);
    socket.on('error', () => {}).on('close', () => this.#sockets.delete(socket));
    this.onConnection?.(socket);
    if (this.isMute) return;
    let rest = Buffer.alloc(0), isStreaming = false, fields = [];
    socket.on('data', bytes => {
      rest = Buffer.concat([rest, bytes]);
      while (rest.length >= 3 && rest.length >= rest.readUInt16BE(0)) {
        const size = rest.readUInt16BE(0), type = String.fromCharCode(rest[2]), payload = rest.subarray(3, size);
        rest = rest.subarray(size);
        this.requests.push(type);
        if (type === 'V') socket.write(packageOf('V', byte(payload.readUInt16BE(0) <= this.accepts ? 1 : 0)));
        if (type === 'v' && this.version !== null && (!isStreaming || this.isAnsweringWhileStreaming)) socket.write(packageOf('v', ...this.version.map(int)));
        if (type === 'O') {
          this.frequencies.push(payload.readDoubleBE(0));
          fields = payload.toString('ascii', 8).split(',');
          this.recipes.push(fields);
          const types = fields.map(field => this.missing.includes(field) ? 'NOT_FOUND' : this.types[field] ?? TYPES[field] ?? 'NOT_FOUND');
          socket.write(packageOf('O', byte(1), types.join(',')));
        }
        if (type === 'S') {
          socket.write(packageOf('S', byte(1)));
          isStreaming = true;
          this.#stream(socket, fields);
        }
      }
    });
  }

  #stream(socket, fields) {
    let last = Math.floor(this.now * this.rateHz), count = 0;
    const timer = setInterval(() => {
      const cycle = Math.floor(this.now * this.rateHz);
      if (cycle === last) return;
      last = cycle;
      if (++count % this.losesEach === 0) return;
      // Time of the current control cycle. An e-Series has 500 cycles a second and sends the package within the cycle.
      const time = Math.floor(this.now * 500) / 500, bytes = packageOf('U', byte(1), ...fields.map(field => this.#value(field, time)));
      socket.write(this.sendsHalf ? bytes.subarray(0, bytes.length >> 1) : bytes);
      if (this.sendsHalf) clearInterval(timer);
    }, 1);
    socket.on('close', () => clearInterval(timer));
  }

  #value(field, time) {
    const six = of => doubles(...[0, 1, 2, 3, 4, 5].map(of)), h = 1e-5;
    switch (field) {
      case 'timestamp': return doubles(time);
      case 'actual_q': return six(i => angle(i, this.stands ? 0 : time));
      case 'actual_qd': return six(i => (angle(i, time + h) - angle(i, time - h)) / (2 * h));
      case 'target_qd': return six(i => (angle(i, time + LAG_S + h) - angle(i, time + LAG_S - h)) / (2 * h));
      case 'target_q': return six(i => angle(i, time + LAG_S));
      case 'actual_digital_output_bits': return Buffer.concat([int(0), int(this.outputBits)]);
      case 'actual_TCP_pose': return doubles(...this.toolPose);
      case 'tool_output_voltage': return int(24);
      case 'runtime_state': return int(this.state.runtime);
      case 'robot_mode': return int(this.state.mode);
      case 'safety_mode': return int(this.state.safety);
      case 'safety_status_bits': return int(this.state.bits);
      default: throw new Error(`no field ${field}`);
    }
  }
}

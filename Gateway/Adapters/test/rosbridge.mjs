// Simulates the gateway, to test the messages that an adapter sends.
import { createServer as createSecureServer } from 'node:https';
import { WebSocketServer } from 'ws';
import { freePort } from './freePort.mjs';
import { until } from './program.mjs';

export class RosbridgeDouble {
  /** All received messages, parsed. */
  heard = [];
  headers = [];
  #server = null;
  #http = null;
  #calls = 0;

  /**
   * @param tls Key and certificate for wss; null for ws.
   * @param token Token that a client must send; otherwise it receives the status `refusal`.
   * @param now Returns the time of the gateway's control clock in ns; null simulates a gateway that does not respond to requests for the time.
   */
  static async start(test, { port, tls = null, token = null, refusal = 401, now = null } = {}) {
    const double = new RosbridgeDouble();
    double.port = port ?? await freePort();
    const verifyClient = ({ req }, done) => {
      double.headers.push(req.headers);
      done(token === null || req.headers.authorization === `Bearer ${token}`, refusal, 'Refused');
    };
    double.#http = tls && createSecureServer(tls);
    double.#server = new WebSocketServer(tls ? { server: double.#http, verifyClient } : { host: '127.0.0.1', port: double.port, verifyClient });
    double.#server.on('connection', socket => {
      socket.on('message', data => {
        const message = JSON.parse(data.toString());
        double.heard.push(message);
        if (now !== null && message.service === '/rosapi/get_time' && message.op === 'call_service')
          socket.send(JSON.stringify({ op: 'service_response', id: message.id, service: message.service, result: true, values: { time: rosTime(now()) } }));
      });
      socket.on('error', () => {});
    });
    double.#http?.listen(double.port, '127.0.0.1');
    const listening = double.#http ?? double.#server;
    await new Promise((resolve, reject) => listening.once('listening', resolve).once('error', reject));
    double.url = `${tls ? 'wss' : 'ws'}://127.0.0.1:${double.port}`;
    test.after(() => double.stop());
    return double;
  }

  get clients() { return [...this.#server.clients]; }

  send(message) {
    for (const client of this.clients) client.send(JSON.stringify(message));
  }

  stop() {
    for (const client of this.clients) client.terminate();
    this.#server.close();
    this.#http?.close();
  }

  published(topic) { return this.heard.filter(m => m.op === 'publish' && m.topic === topic).map(m => m.msg); }

  get jointStates() { return this.published('/joint_states'); }

  /** Values of the newest diagnostics by their keys. */
  get state() {
    const status = this.published('/nowpose/diagnostics').at(-1)?.status[0];
    return status && Object.fromEntries(status.values.map(({ key, value }) => [key, value]));
  }

  /** The newest DiagnosticStatus. */
  get status() { return this.published('/nowpose/diagnostics').at(-1)?.status[0]; }

  /** Returns the state of a joint in the newest diagnostics, with its start (Unix time in seconds) and reason. */
  joint(name) {
    const [, state, since, reason = ''] = /^(\w+) (\d+\.\d{3})(?: (.*))?$/.exec(this.state?.[`joint/${name}`] ?? '') ?? [];
    return state === undefined ? undefined : { state, since: Number(since), reason };
  }

  /** Calls a service of the adapter and returns the response. */
  async call(service) {
    const id = `call-${++this.#calls}`;
    await until(() => this.heard.some(m => m.op === 'advertise_service' && m.service === service), `${service} to be offered`);
    this.send({ op: 'call_service', id, service, args: {} });
    return until(() => this.heard.find(m => m.op === 'service_response' && m.id === id), `a response of ${service}`);
  }
}

const rosTime = time => ({ sec: Number(time / 1_000_000_000n), nanosec: Number(time % 1_000_000_000n) });
export const nanoseconds = ({ sec, nanosec }) => BigInt(sec) * 1_000_000_000n + BigInt(nanosec);

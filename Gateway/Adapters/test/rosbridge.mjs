// The gateway's side of the wire, for tests of what an adapter sends to it.
import { createServer as createSecureServer } from 'node:https';
import { WebSocketServer } from 'ws';
import { until } from './program.mjs';

export class RosbridgeDouble {
  /** Every message that came, parsed. */
  heard = [];
  headers = [];
  #server = null;
  #http = null;
  #calls = 0;

  /** @param tls A key and certificate for wss. @param token Required token; clients without it get 401. */
  static async start(test, { port = 0, tls = null, token = null } = {}) {
    const double = new RosbridgeDouble();
    const verifyClient = ({ req }, done) => {
      double.headers.push(req.headers);
      done(token === null || req.headers.authorization === `Bearer ${token}`, 401, 'Unauthorized');
    };
    double.#http = tls && createSecureServer(tls);
    double.#server = new WebSocketServer(tls ? { server: double.#http, verifyClient } : { host: '127.0.0.1', port, verifyClient });
    double.#server.on('connection', socket => {
      socket.on('message', data => double.heard.push(JSON.parse(data.toString())));
      socket.on('error', () => {});
    });
    double.#http?.listen(port, '127.0.0.1');
    const listening = double.#http ?? double.#server;
    await new Promise((resolve, reject) => listening.once('listening', resolve).once('error', reject));
    double.port = listening.address().port;
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

  /** The key/values of the newest diagnostics. */
  get state() {
    const status = this.published('/nowpose/diagnostics').at(-1)?.status[0];
    return status && Object.fromEntries(status.values.map(({ key, value }) => [key, value]));
  }

  /** The newest DiagnosticStatus without its values. */
  get status() { return this.published('/nowpose/diagnostics').at(-1)?.status[0]; }

  /** State, Unix time in seconds and reason that the newest diagnostics have of a joint. */
  joint(name) {
    const [, state, since, reason = ''] = /^(\w+) (\d+\.\d{3})(?: (.*))?$/.exec(this.state?.[`joint/${name}`] ?? '') ?? [];
    return state === undefined ? undefined : { state, since: Number(since), reason };
  }

  /** Asks a service and gives the response. */
  async call(service) {
    const id = `call-${++this.#calls}`;
    await until(() => this.heard.some(m => m.op === 'advertise_service' && m.service === service), `${service} to be offered`);
    this.send({ op: 'call_service', id, service, args: {} });
    return until(() => this.heard.find(m => m.op === 'service_response' && m.id === id), `an answer of ${service}`);
  }
}

export const nanoseconds = ({ sec, nanosec }) => BigInt(sec) * 1_000_000_000n + BigInt(nanosec);

// Simulates the rosbridge of a robot with ROS 1 or ROS 2, which differ in their formats and in the requests that they refuse.
import { once } from 'node:events';
import { WebSocketServer } from 'ws';
import { freePort } from '../freePort.mjs';

/**
 * Converts a message to JSON as rosbridge does. A number that is not finite is null, but in an array of fixed length, which is a Float64Array here,
 * Python writes it as NaN, Infinity or -Infinity.
 */
const json = message => JSON.stringify(
  message, (_, value) => value instanceof Float64Array ? Array.from(value, number => Number.isFinite(number) ? number : `\0${number}`) : value,
).replace(/"\\u0000(-?\w+)"/g, '$1');

const pair = (nanoseconds, names) => ({ [names[0]]: Number(nanoseconds / 1_000_000_000n), [names[1]]: Number(nanoseconds % 1_000_000_000n) });

export class Robot {
  /** All received messages. */
  heard = [];
  /** Last message of each latched topic, by its publisher. */
  latched = new Map();
  /** Topics with a best-effort publisher. */
  #bestEffort = new Set();
  /** Whether rosapi ends during each call. The rosbridge of ROS 2 then reads no further message of the client that has called it. */
  endsDuringCalls = false;
  /** Whether a call has destroyed the state of rosbridge (rosbridge_suite, PR 1255). Every call then fails until rosbridge restarts. */
  isCapsuleLost = false;
  #sockets = new Set();
  #started = performance.now();

  /**
  * `ros` is the ROS version, 1 or 2. `aheadMs` is the time of the robot's clock minus that of this machine's clock. `now` replaces the
  * robot's clock; null simulates a robot without rosapi. `namespace` is that of the nodes rosbridge and rosapi; empty if they have none.
  */
  constructor({ ros = 2, aheadMs = 0, now, namespace = '' } = {}) {
    this.ros = ros;
    this.namespace = namespace;
    const start = BigInt(Math.round((Date.now() + aheadMs) * 1e6));
    this.now = now === undefined ? () => start + BigInt(Math.round((performance.now() - this.#started) * 1e6)) : now;
  }

  static async start(test, options = {}) {
    const robot = new Robot(options);
    await robot.listen(options.port);
    test.after(() => robot.stop());
    return robot;
  }

  async listen(port) {
    this.port = port ?? await freePort();
    this.server = new WebSocketServer({ host: '127.0.0.1', port: this.port });
    this.server.on('connection', socket => this.#serve(socket));
    await once(this.server, 'listening');
    this.url = `ws://127.0.0.1:${this.port}`;
  }

  stop() {
    for (const { socket } of this.#sockets) socket.terminate();
    return new Promise(resolve => this.server.close(resolve));
  }

  #serve(socket) {
    const client = { socket, topics: new Map(), isBlocked: false };
    this.#sockets.add(client);
    socket.on('close', () => this.#sockets.delete(client));
    socket.on('error', () => {});
    socket.on('message', data => this.#take(client, JSON.parse(data)));
  }

  #take(client, message) {
    if (client.isBlocked) return;
    this.heard.push(message);
    const send = answer => client.socket.send(json(answer));
    if (message.op === 'subscribe') {
      // As in ros_loader.py, ROS 1 accepts only package/Name, and ROS 2 also accepts package/msg/Name.
      const parts = message.type?.split('/').length;
      if (parts !== undefined && parts !== 2 && (this.ros === 1 || parts !== 3))
        return send({ op: 'status', level: 'error', msg: `subscribe: Unable to import ${message.type}`, id: message.id });
      const isFirst = !this.isHeardBy(message.topic);
      client.topics.set(message.topic, this.#bestEffort.has(message.topic) ? 'best effort' : 'reliable');
      // The rosbridge of ROS 2 ends the temporary subscription for a later client after its first message (subscribers.py, _new_sub_callback).
      const kept = [...this.latched.get(message.topic)?.values() ?? []];
      for (const msg of isFirst || this.ros === 1 ? kept : kept.slice(0, 1)) send({ op: 'publish', topic: message.topic, msg });
    } else if (message.op === 'unsubscribe') {
      client.topics.delete(message.topic);
    } else if (message.op === 'call_service' && this.endsDuringCalls) {
      client.isBlocked = this.ros === 2;
    } else if (message.op === 'call_service') {
      const service = message.service.startsWith('/') ? message.service : `${this.#prefix}/${message.service}`;
      const isKnown = service === `${this.#prefix}/rosapi/get_time` && this.now !== null;
      const missing = isKnown ? null : `Service ${service} does not exist`;
      const problem = this.isCapsuleLost ? "Object of type 'NoneType' is not an instance of 'capsule'" : missing;
      const values = problem ?? { time: this.time(this.now()) };
      send({ op: 'service_response', id: message.id, service: message.service, result: problem === null, values });
    }
  }

  get #prefix() { return this.namespace === '' ? '' : `/${this.namespace}`; }

  /** Returns a time in the format of this ROS version. */
  time(nanoseconds) {
    return pair(nanoseconds, this.ros === 1 ? ['secs', 'nsecs'] : ['sec', 'nanosec']);
  }

  /**
   * Publishes a message. With ROS 2, the rosbridge selects the quality of service of a subscription when it creates it, from the publishers that exist
   * at this time (subscribers.py). A subscription from before the publisher therefore receives neither the first message of a latched topic, which is
   * published before the two have found each other, nor any message of a best-effort publisher.
   * @param publisher Name of the node. A topic may have several publishers, such as /tf_static.
   */
  publish(topic, msg, { isLatched = false, isBestEffort = false, publisher = '' } = {}) {
    const isFirst = isLatched && this.latched.get(topic)?.has(publisher) !== true;
    if (isLatched) this.latched.set(topic, new Map([...this.latched.get(topic) ?? [], [publisher, msg]]));
    if (isBestEffort) this.#bestEffort.add(topic);
    const isReceived = quality => quality !== undefined && (this.ros === 1 || !isFirst && (!isBestEffort || quality === 'best effort'));
    for (const { socket, topics } of this.#sockets) if (isReceived(topics.get(topic))) socket.send(json({ op: 'publish', topic, msg }));
  }

  /** Sends a text to all clients, which need not be a valid message. */
  sendText(text) {
    for (const { socket } of this.#sockets) socket.send(text);
  }

  jointState(stamp, name, position, velocity = [], options = {}) {
    const header = { ...(this.ros === 1 ? { seq: 1 } : {}), stamp: this.time(stamp), frame_id: '' };
    this.publish('/joint_states', { header, name, position, velocity, effort: name.map(() => null) }, options);
  }

  isHeardBy(topic) {
    return [...this.#sockets].some(({ topics }) => topics.has(topic));
  }
}

// A fake gateway with a swinging robot and two headsets. It provides only the data that the operations page requests.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { once } from 'node:events';

const html = name => readFileSync(new URL(`../dist/${name}.html`, import.meta.url));
const pages = { '/operations': html('operations'), '/pair': html('pairing') };
const urdf = readFileSync(new URL('../../Packages/com.nowpose.mril/Runtime/Robots/youbot.urdf', import.meta.url), 'utf8');
export const JOINTS = [1, 2, 3, 4, 5].map(i => `arm_joint_${i}`);

/** Interval of the samples. An interpolated tool position then errs by at most 0.3 mm, and a page receives half as many messages as with 50 ms. */
const TICK_MS = 100;

const REST = [2.9, 2, -1.5, 1.7, 2.9];

/** Joint positions in which the whole arm is above its base. */
export const UPRIGHT = [2.95, 1.13, -2.55, 1.79, 2.9];

/** Joint positions at a control time. */
export const swing = (t, rest = REST) => rest.map((position, i) => position + (i === 0 ? 0.5 * Math.sin(t) : 0));

const stamp = t => ({ sec: Math.floor(t), nanosec: Math.floor((t % 1) * 1e9) });
const jointState = (topic, t, positions, frame = '', names = JOINTS) => JSON.stringify(
  { op: 'publish', topic, msg: { header: { stamp: stamp(t), frame_id: frame }, name: names, position: positions, velocity: [], effort: [] } });

const transforms = (t, frames, topic = '/tf') => JSON.stringify({ op: 'publish', topic, msg: { transforms: frames.map(([parent, child, [x, y, z]]) => ({
  header: { stamp: stamp(t), frame_id: parent }, child_frame_id: child,
  transform: { translation: { x, y, z }, rotation: { x: 0, y: 0, z: 0, w: 1 } },
})) } });

/** Creates a text frame as a server sends it, without a mask. */
function frame(text) {
  const payload = Buffer.from(text);
  const head = payload.length < 126 ? Buffer.from([0x81, payload.length])
    : payload.length < 65536 ? Buffer.from([0x81, 126, payload.length >> 8, payload.length & 255])
      : Buffer.concat([Buffer.from([0x81, 127, 0, 0, 0, 0]), Buffer.from([payload.length >> 24, payload.length >> 16, payload.length >> 8, payload.length].map(b => b & 255))]);
  return Buffer.concat([head, payload]);
}

/** Returns the contents of the masked text frames that a browser sent. Each frame must be small and complete. */
function* textsOf(data) {
  for (let at = 0; at + 6 <= data.length;) {
    const opcode = data[at] & 15;
    let length = data[at + 1] & 127, body = at + 2;
    if (length === 126) { length = data.readUInt16BE(at + 2); body += 2; }
    const mask = data.subarray(body, body + 4), payload = data.subarray(body + 4, body + 4 + length);
    if (opcode === 1) yield Buffer.from(payload.map((byte, i) => byte ^ mask[i % 4])).toString();
    at = body + 4 + length;
  }
}

export class FakeGateway {
  static #listening = null;

  /** Starts a gateway. Only one gateway of the process may run, because all have the same address: Chromium compiles a script once per address. */
  static async start() {
    const self = new FakeGateway();
    self.server = await (FakeGateway.#listening ??= FakeGateway.#listen());
    self.server.on('request', (request, response) => self.answer(request, response));
    self.server.on('upgrade', (request, socket) => self.upgrade(request, socket));
    self.timer = setInterval(() => self.tick(), TICK_MS);
    return self;
  }

  static async #listen() {
    const server = createServer().listen(0, '127.0.0.1').unref();
    await once(server, 'listening');
    return server;
  }

  /** The robot description; null for a cell without a robot. */
  urdf = urdf;
  sockets = new Map();
  posts = [];
  recordings = [{ name: 'press-1.jsonl', bytes: 2_500_000, changed_utc: '2026-11-20T12:00:00.000Z' }];
  connects = 0;
  /** Subscriptions of the page, by topic. */
  subscriptions = new Map();
  /** Whether the gateway refuses WebSockets, like one with too many connections. */
  isFull = false;
  /** Whether the gateway leaves requests for WebSockets without a response, like a firewall that drops them. */
  isDeaf = false;
  /** Speed factor of the joints' swing; 0 for a robot at rest. */
  pace = 1;
  /** Positions about which the joints swing. */
  rest = REST;
  /** Sets of joints. Each message contains one of them, in turn. */
  sets = [JOINTS];
  /** Angle between the pose that "left door" displays and the true pose, rad; null if the headset does not report it. */
  turned = 0.1;
  /** Number of intervals of the samples between two reports of a headset. */
  reportEvery = 1;
  /** Namespace of the robot that "left door" displays; empty for the robot without a namespace. */
  displayedRobot = '';
  token = null;
  isSilent = false;
  /** Whether joint positions and poses are published. Only the view of the robot needs them, and each message takes processor time. */
  isPublishing = true;

  /** Position of the moving base of the robot; null if no pose of the base is published. */
  base = null;

  /** Namespaces of further robots. */
  robots = [];
  /** Names of stationary objects. Each subscriber receives their poses once. */
  stationary = [];
  /** Parents of objects by name; `world` for the others. */
  parents = {};
  /** Positions of moving objects by name. Their poses are published while they are in this list. */
  moving = {};
  /** Promise that delays the response with the pairing code. */
  codeIsLate = null;
  began = Date.now();
  ticks = 0;

  get address() { return `http://127.0.0.1:${this.server.address().port}/operations`; }
  get now() { return 1000 + (Date.now() - this.began) / 1000; }

  state = {
    cell: 'Press 3', host: 'cell-pc', version: '0.2.0', status: { level: 'ok', text: '5 joints live, 2 headsets' }, uptime_s: 12,
    clock: { source: 'press', state: 'synchronised', estimated_error_us: 35, error_bound_us: 120, skew_ppm: 3.1, rtt_ms: 1.2, resolution_us: 1000, steps: 0 },
    plant_clocks: [
      { name: 'press', connected: true, is_control_clock: true, state: 'synchronised', offset_to_control_ms: 0, skew_ppm: 0, rtt_ms: 1.2, estimated_error_us: 35, error_bound_us: 120, resolution_us: 1000, exchanges: 60, failures: 0 },
      { name: 'press_ads', connected: true, is_control_clock: false, state: 'synchronised', offset_to_control_ms: 12.5, skew_ppm: 4.2, rtt_ms: 0.8, estimated_error_us: 25, error_bound_us: 90, resolution_us: 100, exchanges: 60, failures: 2, last_failure: 'no response within 2 s' },
    ],
    adapters: [
      { name: 'press', seen_s_ago: 0.4, kind: 'opcua', state: 'connected', endpoint: 'opc.tcp://plc:4840', security: 'SignAndEncrypt, Basic256Sha256', samples: 1200, refused: 0, reconnects: 0, sampling_ms: 10 },
      { name: 'belt', seen_s_ago: 0.4, kind: 'ads', state: 'refused', reason: 'the router does not know this machine', samples: 0, refused: 3, reconnects: 7 },
    ],
    sources: [{ joints: JOINTS, rate_hz: 20, age_ms: { p50: 71, p95: 104 } }],
    frames: [
      { name: 'fixture', parent: 'world', source: 'gateway', state: 'stationary', age_s: null },
      { name: 'workpiece_1', parent: 'tool_centre_point', source: 'gateway', state: 'live', age_s: 0.08 },
    ],
    signals: [{ name: 'gripper_closed', value: 1, source: 'gateway', state: 'live', age_s: 2.4 }],
    joints: JOINTS.map(name => ({ name, source: 'press', state: 'live', since_utc: new Date(Date.now() - 60_000).toISOString(), age_s: 0.071, rate_hz: 20, reason: '' })),
    events: [],
    headsets: [
      { name: 'left door', seen_s_ago: 0.3, state: 'synchronised', pose: 'current', current_share: 0.987, rtt_ms: 3.2, error_bound_us: 410, l_app_ms: 82, l_visu_ms: 40, render_ms: 11, range: 'inside', error_mm_hold: 31, error_mm: 2.1, reduction: 0.932, samples: 900, dropped: 1, budget_ms: { plant: 71, gateway: 0.3, network: 1.6, queue: 9.1, render: 11, display: 29 } },
      { name: 'right door', seen_s_ago: 8, state: 'holdover', rtt_ms: 45, error_bound_us: 9000, l_app_ms: 140, l_visu_ms: 40, render_ms: 31, range: 'outside', error_mm_hold: 60, error_mm: 30, reduction: 0.5, samples: 400, dropped: 12, budget_ms: { plant: 71, gateway: 0.3, network: 22.5, queue: 46, render: 31, display: 9 } },
    ],
    forward_ms: { p50: 0.3, p99: 1.9 },
    connections: { sync: { open: 2, accepted: 5, closures: {} }, websocket: { open: 3, accepted: 9, closures: {} } },
    drops: { NotFinite: 2 },
    recording: { can: true, on: false, lines: 0, bytes: 0, lost: 0 },
    pairs_headsets: true,
    role: 'operator',
  };

  stop() {
    clearInterval(this.timer);
    for (const socket of this.sockets.keys()) socket.destroy();
    this.server.removeAllListeners('request').removeAllListeners('upgrade').closeAllConnections();
  }

  /** Neither sends nor receives on the present WebSockets and leaves them open, like a network that has lost the end of a connection. */
  loseSockets() {
    for (const socket of this.sockets.keys()) socket.removeAllListeners('data');
    this.sockets.clear();
  }

  /** Closes all WebSockets, like a gateway that restarts. */
  hangUp() {
    for (const socket of this.sockets.keys()) socket.destroy();
  }

  send(topic, text) {
    for (const [socket, topics] of this.sockets) if (topics.has(topic)) socket.write(frame(text));
  }

  /** Sends another robot description to all subscribers. */
  describe(urdf) {
    this.send('/robot_description', JSON.stringify({ op: 'publish', topic: '/robot_description', msg: { data: urdf } }));
  }

  tick() {
    if (this.isSilent || !this.isPublishing) return;
    const t = this.now - 0.07, names = this.sets[this.ticks++ % this.sets.length], truth = swing(this.pace * t, this.rest);
    if (names) this.send('/joint_states', jointState('/joint_states', t, names.map(name => truth[JOINTS.indexOf(name)]), '', names));
    if (this.base) this.send('/tf', transforms(t, [['world', 'arm_link_0', this.base]]));
    const moving = Object.entries(this.moving).map(([name, at]) => [this.parents[name] ?? 'world', name, at]);
    if (moving.length > 0) this.send('/tf', transforms(t, moving));
    for (const robot of this.robots) this.send(`/${robot}/joint_states`, jointState(`/${robot}/joint_states`, t, truth, '', JOINTS));
    for (const [name, turned] of [['left door', this.turned], ['right door', 1]]) {
      if (turned === null || this.ticks % this.reportEvery !== 0) continue;
      const light = this.now + 0.04, [first, ...rest] = swing(this.pace * light, this.rest);
      this.send('/nowpose/displayed', jointState('/nowpose/displayed', light, [first + turned, ...rest], name,
        JOINTS.map(joint => (name === 'left door' && this.displayedRobot ? `${this.displayedRobot}/${joint}` : joint))));
    }
  }

  async answer(request, response) {
    let body = '';
    for await (const part of request) body += part;
    const path = request.url, post = request.method === 'POST' ? JSON.parse(body || '{}') : null;
    if (post) this.posts.push([path, post]);
    const reply = (status, value) => {
      const isText = typeof value === 'string';
      response.writeHead(status, { 'Content-Type': isText ? 'text/plain' : 'application/json' });
      response.end(isText ? value : JSON.stringify(value));
    };
    if (pages[path]) return response.writeHead(200, { 'Content-Type': 'text/html' }).end(pages[path]);
    if (path === '/operations/login') {
      if (post.token !== this.token) return reply(401, 'not a token of this gateway');
      response.setHeader('Set-Cookie', 'nowpose=abc; Path=/; HttpOnly; SameSite=Strict');
      return reply(200, { role: 'operator' });
    }
    if (this.token && !request.headers.cookie?.includes('nowpose=abc'))
      return reply(401, "the bearer token is missing or unknown; send a token of the gateway's token file, or pair again");
    if (this.isSilent) return request.destroy();
    if (path === '/operations/state') return reply(200, { ...this.state, control_time_s: this.now, is_logged_in: this.token !== null });
    if (path === '/operations/recordings') return reply(200, this.recordings);
    if (path.startsWith('/operations/recordings/')) return reply(200, 'a recording');
    if (path.startsWith('/operations/events')) return reply(200, 'id,kind');
    if (path === '/operations/logout') {
      response.setHeader('Set-Cookie', 'nowpose=; Path=/; Max-Age=0');
      return reply(200, {});
    }
    if (path === '/operations/recording') {
      this.state.recording = { can: true, on: post.on === 'true', file: 'press-3.jsonl', lines: 12, bytes: 3400, lost: 0 };
      return reply(200, this.state.recording);
    }
    if (path === '/pair/code') await this.codeIsLate;
    if (path === '/pair/code') return reply(200, { text: 'nowpose:token/1?t=AAAAAAAAAAAAAAAAAAAAAA&x=1', left_s: 290, key: 'AB' });
    if (path === '/pair/cell' && 'begin' in post) return reply(200, { name: 'Press 3', hosts: ['cell-pc'], has_pin: false });
    if (path === '/pair/cell') return reply(200, { text: 'nowpose:cell/1' });
    return reply(404, 'nothing');
  }

  upgrade(request, socket) {
    this.connects++;
    if (this.isDeaf) return socket.on('error', () => socket.destroy());
    if (this.isFull) return socket.end('HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\n\r\n');
    const accept = createHash('sha1').update(request.headers['sec-websocket-key'] + '258EAFA5-E914-47DA-95CA-C5AB0DC85B11').digest('base64');
    if (this.token && !request.headers.cookie?.includes('nowpose=abc')) return socket.end('HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n');
    socket.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${accept}\r\n\r\n`);
    this.sockets.set(socket, new Set());
    socket.on('data', data => { for (const text of textsOf(data)) this.hear(socket, JSON.parse(text)); });
    socket.on('close', () => this.sockets.delete(socket));
    socket.on('error', () => socket.destroy());
  }

  hear(socket, { op, topic, ...options }) {
    if (op === 'call_service')
      return socket.write(frame(JSON.stringify({ op: 'service_response', service: options.service, values: {}, result: true })));
    if (op === 'unsubscribe') return this.sockets.get(socket).delete(topic);
    if (op !== 'subscribe') throw new Error(`the page ${op}s`);
    this.sockets.get(socket).add(topic);
    this.subscriptions.set(topic, options);
    if (this.urdf && topic.endsWith('/robot_description')) socket.write(frame(JSON.stringify({ op: 'publish', topic, msg: { data: this.urdf } })));
    if (topic !== '/tf_static') return;
    for (const name of this.stationary) socket.write(frame(transforms(0, [[this.parents[name] ?? 'world', name, [0.3, 0, 0]]], topic)));
  }
}

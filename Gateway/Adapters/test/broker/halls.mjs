// Connects two gateways through a broker and two bridges, and creates the messages that they forward.
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { Mosquitto } from './mosquitto.mjs';
import { SyncServer } from './syncServer.mjs';

export const TOPIC = 'nowpose/cell';
/** Time after which a receiving bridge no longer trusts a presence that is not repeated, ms. */
const TRUST_MS = 6000;

export function bridge(t, direction, gateway, broker, more = '', { env, launch = start } = {}) {
  const path = temporaryFile(`${direction}.yaml`, `gateway: { url: "${gateway.url}" }
plant:
  kind: broker
  name: hall
  direction: ${direction}
  endpoint: ${broker.url ?? broker}
  topic: ${TOPIC}
${more}`);
  return launch(t, [path], { env });
}

export const clockOf = ({ port }, more = '') => `  clock: { host: 127.0.0.1, port: ${port}${more} }\n`;

/** Starts two gateways, one with the plant (`near`) and one without (`far`), and connects them through a broker and two bridges, which `launch` starts. */
export async function halls(t, { more = '', namespaces = [], launch } = {}) {
  const robots = namespaces.length === 0 ? '' : `  namespaces: [${namespaces.join(', ')}]\n`;
  const [near, far, broker, sync] = await Promise.all([RosbridgeDouble.start(t), RosbridgeDouble.start(t), Mosquitto.start(t), SyncServer.start(t)]);
  const publisher = bridge(t, 'publish', near, broker, robots, { launch });
  const subscriber = bridge(t, 'subscribe', far, broker, clockOf(sync) + robots + more, { launch });
  await until(() => near.heard.filter(m => m.op === 'subscribe').length === 9 + 3 * namespaces.length, () => publisher.err);
  await until(() => far.state?.state === 'connected', () => subscriber.err);
  // The subscribing bridge forwards no message before the clock of the time stamps is known.
  await served(far);
  return { near, far, broker, sync, publisher, subscriber };
}

/**
 * Prevents the end of the trust in the presence of the publishing bridge, however long the test takes. Returns a function that gets the calls of
 * setTimeout for this end.
 */
export function keepTrust(t) {
  const { setTimeout: begin } = globalThis;
  const { mock } = t.mock.method(globalThis, 'setTimeout', (then, ms, ...rest) => begin(then, ms === TRUST_MS ? 1e9 : ms, ...rest));
  return () => mock.calls.filter(call => call.arguments[1] === TRUST_MS);
}

export const state = (stamp, name = ['a'], position = [1]) => ({
  header: { stamp: { sec: Number(stamp / 1_000_000_000n), nanosec: Number(stamp % 1_000_000_000n) }, frame_id: '' },
  name, position, velocity: [], effort: [],
});
export const publish = (double, topic, msg) => double.send({ op: 'publish', topic, msg });
/** Returns a list of joints that are not live, like the list that a gateway publishes on /nowpose/joint_status. */
export const jointStatus = (stamp, values) => ({
  header: state(stamp).header,
  status: [{ level: 2, name: 'joints', message: '', hardware_id: 'gateway', values: Object.entries(values).map(([key, value]) => ({ key, value })) }],
});
export const secondsAgo = (stamp, seconds) => (Number(stamp) / 1e9 - seconds).toFixed(3);
/** Waits until a bridge serves the clock of the plant's gateway. */
export const served = (double, service = '/nowpose/plant_time/hall') =>
  until(async () => (await double.call(service)).result, 'the clock');

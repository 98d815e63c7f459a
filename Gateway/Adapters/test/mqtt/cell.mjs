// Connects an adapter to mosquitto and to a test double of the gateway, and creates the messages that the adapter receives.
import { connectAsync } from 'mqtt';
import { start, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { Mosquitto } from '../broker/mosquitto.mjs';

/** Returns a clock that is ahead of the system clock. */
export function clockAhead(ms) {
  const zero = BigInt(Math.round((Date.now() + ms) * 1e6)) - process.hrtime.bigint();
  return () => zero + process.hrtime.bigint();
}

export const configuration = (url, endpoint, { plant = '', rest = '' }) =>
  `gateway: { url: "${url}" }\nplant:\n  kind: mqtt\n  name: twin\n  endpoint: ${endpoint}\n${plant}${rest}`;

/** Starts a broker, a gateway with its own clock, and the adapter with `launch`. Resolves when the adapter has subscribed. */
export async function cell(t, { plant, rest, lines, prepare = async () => {}, env, launch = start, now = clockAhead(60_000) } = {}) {
  const [broker, bridge] = await Promise.all([Mosquitto.start(t, lines), RosbridgeDouble.start(t, { now })]);
  const client = await connectAsync(broker.url, { protocolVersion: 5 });
  t.after(() => client.endAsync(true));
  const send = (topic, message, more = {}) =>
    client.publishAsync(topic, typeof message === 'string' ? message : JSON.stringify(message), { qos: 1, ...more });
  await prepare({ send, now });
  const adapter = launch(t, [temporaryFile('mqtt.yaml', configuration(bridge.url, broker.url, { plant, rest }))], { env });
  await until(() => bridge.state?.state === 'connected', () => adapter.err);
  return { broker, bridge, adapter, client, now, send };
}

export const poses = (bridge, frame) =>
  bridge.published('/tf').flatMap(({ transforms }) => transforms).filter(one => one.child_frame_id === frame)
    .map(({ header, transform: { translation: { x, y, z }, rotation } }) =>
      ({ stamp: nanoseconds(header.stamp), parent: header.frame_id, position: [x, y, z], rotation: [rotation.x, rotation.y, rotation.z, rotation.w] }));

export const changes = (bridge, signal) =>
  bridge.published('/signals').flatMap(({ header, name, value }) => (name.includes(signal) ? [[value[name.indexOf(signal)], nanoseconds(header.stamp)]] : []));

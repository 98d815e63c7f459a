// Connects an adapter to a PLC that moves a youBot and to a test double of the gateway.
import assert from 'node:assert/strict';
import { start, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { AdsServer } from './server.mjs';
import { angle, youBot } from './youbot.mjs';

export const NET_ID = '5.24.12.7.1.1';

const LOCAL = '  local_net_id: 192.168.0.10.1.1\n';

export const configuration = ({ port, url, more = '', joints, local = LOCAL }) => `gateway:
  url: ${url}
plant:
  kind: ads
  name: cell
  endpoint: ads://127.0.0.1:${port}/${NET_ID}:851
${local}  plain: true
${more}joints:
${joints ?? [0, 1, 2, 3, 4].map(i => `  - joint: arm_joint_${i + 1}\n    symbol: GVL.aJoints[${i}]\n`).join('')}`;

/** Starts a PLC, a test double of the gateway, and an adapter that connects them, with `launch`. */
export async function cell(t, { plc = youBot({ cycleMs: 5 }), more, joints, local, server: options, launch = start } = {}) {
  if (launch === start) VirtualTime.ofProcess(t);
  const server = new AdsServer(plc, options), port = await server.listen();
  t.after(() => server.close());
  const bridge = await RosbridgeDouble.start(t);
  const path = temporaryFile('ads.yaml', configuration({ port, url: bridge.url, more, joints, local }));
  return { plc, server, bridge, port, path, adapter: launch(t, [path]) };
}

export const clockOf = bridge => until(async () => (await bridge.call('/nowpose/plant_time/cell')).result, 'the clock');

export const statesOf = (bridge, count = 1) => until(
  () => bridge.jointStates.length >= count && bridge.jointStates, () => `${count} joint states; ${JSON.stringify(bridge.state)}`);

/** Asserts that each message contains the positions that the joints had in the PLC at the time stamp of the message. */
export function assertMatchesPlc(states, tolerance = 1e-6) {
  for (const { header, name, position } of states)
    name.forEach((joint, i) => {
      const truth = angle(Number(joint.at(-1)) - 1, nanoseconds(header.stamp));
      assert.ok(Math.abs(position[i] - truth) < tolerance, `${joint} at ${JSON.stringify(header.stamp)}: ${position[i]}, not ${truth}`);
    });
  assert.deepEqual([...new Set(states.flatMap(s => s.name))].sort(), [1, 2, 3, 4, 5].map(i => `arm_joint_${i}`));
}

export const jointIs = (bridge, name, expected) => until(
  () => bridge.joint(name)?.state === expected && bridge.joint(name), () => `${name} ${expected}: ${JSON.stringify(bridge.state)}`);

// A controller, a gateway and the adapter between them.
import { start, until } from '../program.mjs';
import { nanoseconds, RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { RtdeRobot } from './robot.mjs';

export const ARMS = ['ur3e', 'ur5e', 'ur10e', 'ur16e', 'ur5'];
export const JOINTS = ['shoulder_pan_joint', 'shoulder_lift_joint', 'elbow_joint', 'wrist_1_joint', 'wrist_2_joint', 'wrist_3_joint'];

export const configuration = ({ url, port, host = '127.0.0.1', more = '', rest = '' }) =>
  temporaryFile('rtde.yaml', `gateway: { url: "${url}" }\nplant: { kind: rtde, name: arm, host: "${host}", port: ${port}${more} }\n${rest}`);

/** Starts a controller, a gateway, and an adapter that connects them, with `launch`. */
export async function cell(t, robot = new RtdeRobot(), { more, rest, launch = start } = {}) {
  if (launch === start) VirtualTime.ofProcess(t);
  await robot.listen(t);
  const bridge = await RosbridgeDouble.start(t);
  return { robot, bridge, adapter: launch(t, [configuration({ url: bridge.url, port: robot.port, more, rest })]) };
}

export const statesOf = (bridge, count = 1) => until(() => bridge.jointStates.length >= count && bridge.jointStates, () => `${count} joint states; ${JSON.stringify(bridge.state)}`);

export const seconds = stamp => Number(nanoseconds(stamp)) / 1e9;

/** Returns the log lines of the adapter about the state of its plant. */
export const plantLines = adapter => adapter.err.split('\n').filter(line => /\[plant\/arm\] (waiting|refused|connected)/.test(line));

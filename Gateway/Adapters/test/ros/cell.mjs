// Starts an adapter between a simulated robot and a test double of the gateway.
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { Robot } from './robot.mjs';

/** Starts a robot, a test double of the gateway, and an adapter that connects them, with `launch`. Waits until the adapter has subscribed. */
export async function cell(t, options = {}, { plant = '', rest = '', launch = start } = {}) {
  if (launch === start) VirtualTime.ofProcess(t);
  const robot = options.robot ?? await Robot.start(t, options), bridge = await RosbridgeDouble.start(t);
  const path = temporaryFile('ros.yaml', `gateway: { url: "${bridge.url}" }\nplant:\n  kind: ros\n  name: arm\n  endpoint: ${robot.url}\n${plant}${rest}`);
  const adapter = launch(t, [path]);
  await until(() => robot.isHeardBy('/joint_states') && bridge.clients.length > 0, () => adapter.err);
  // The adapter forwards no message before the clock of the time stamps is known.
  if (options.now !== null) await until(async () => (await bridge.call('/nowpose/plant_time/arm')).result, 'the clock');
  return { robot, bridge, adapter };
}

/** Waits for joint states that the gateway has received. */
export const states = (bridge, count = 1) => until(
  () => bridge.jointStates.length >= count && bridge.jointStates, () => `${count} joint states: ${JSON.stringify(bridge.state)}`);

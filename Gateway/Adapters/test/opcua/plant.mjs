// Connects an adapter to a server that moves a youBot and to a test double of the gateway.
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile, temporaryFolder } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { YoubotServer } from './server.mjs';

/** Starts a server, which is stopped at the end of the suite. */
export async function serverFor(suite, options) {
  const server = await new YoubotServer(options).start();
  suite.after(() => server.stop());
  return server;
}

// All tests of a file that need no certificate of their own share this folder, because creating a certificate takes half a second.
export const OPEN = [`security: {mode: none, i_know_this_is_open: true, folder: "${temporaryFolder()}"}`];

/** Returns the content of a configuration file. `plant` contains the lines of the plant section, and `joints` contains the entries of each joint. */
export function configuration(gateway, endpoint, plant, joints, more = '') {
  const list = joints.map(entries => `  - ${Object.entries(entries).map(([key, value]) => `${key}: ${value}`).join('\n    ')}\n`);
  return `gateway:\n  url: ${gateway}\n${more}plant:\n  kind: opcua\n  name: cell\n  endpoint: ${endpoint}\n`
    + plant.map(entry => `  ${entry}\n`).join('') + (list.length > 0 ? `joints:\n${list.join('')}` : 'joints: []\n');
}

/** Starts an adapter for a server and a test double of the gateway, with `launch`; in virtual time unless another process takes part. */
export async function adapterFor(test, server, plant, joints, { env, path, bridge, launch = start, isAlone = launch === start } = {}) {
  if (isAlone) VirtualTime.ofProcess(test);
  bridge ??= await RosbridgeDouble.start(test);
  path ??= temporaryFile('plant.yaml', configuration(bridge.url, server.endpoint, plant, joints));
  const run = launch(test, [path], { env });
  return {
    run, bridge, path,
    states: count => until(() => bridge.jointStates.length >= count && bridge.jointStates,
      () => `${count} joint states; there are ${bridge.jointStates.length}. ${run.err}`),
    state: holds => until(() => bridge.state && holds(bridge.state) && bridge.state,
      () => `a state other than ${JSON.stringify(bridge.state)}. ${run.err}`),
  };
}

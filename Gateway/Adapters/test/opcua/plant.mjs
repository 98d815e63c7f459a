// An adapter between a server that moves a youBot and a double of the gateway.
import { start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { temporaryFile, temporaryFolder } from '../temporary.mjs';
import { YoubotServer } from './server.mjs';

/** Starts the server of a test file. */
export async function serverFor(suite, options) {
  const server = await new YoubotServer(options).start();
  suite.after(() => server.stop());
  return server;
}

// Shared by all tests of a file that do not need their own certificate: creating one takes half a second.
export const OPEN = [`security: {mode: none, i_know_this_is_open: true, folder: "${temporaryFolder()}"}`];

/** Returns the text of a configuration: entries of the section plant, then of each joint. */
export function configuration(gateway, endpoint, plant, joints, more = '') {
  const list = joints.map(entries => `  - ${Object.entries(entries).map(([key, value]) => `${key}: ${value}`).join('\n    ')}\n`);
  return `gateway:\n  url: ${gateway}\n${more}plant:\n  kind: opcua\n  name: cell\n  endpoint: ${endpoint}\n`
    + plant.map(entry => `  ${entry}\n`).join('') + (list.length > 0 ? `joints:\n${list.join('')}` : 'joints: []\n');
}

/** Starts the adapter; `more` can name files of its own folder. */
export async function adapterFor(test, server, plant, joints, { env, stdin, path, bridge } = {}) {
  bridge ??= await RosbridgeDouble.start(test);
  path ??= temporaryFile('plant.yaml', configuration(bridge.url, server.endpoint, plant, joints));
  const run = start(test, [path], { env, stdin });
  return {
    run, bridge, path,
    states: count => until(() => bridge.jointStates.length >= count && bridge.jointStates,
      () => `${count} joint states; there are ${bridge.jointStates.length}. ${run.err}`),
    state: holds => until(() => bridge.state && holds(bridge.state) && bridge.state,
      () => `another state than ${JSON.stringify(bridge.state)}. ${run.err}`),
  };
}

// Runs the built gateway on free ports of this machine.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { createInterface } from 'node:readline';
import { skipWithout } from '../../../../Web/test/required.mjs';
import { adapters } from '../program.mjs';

const builds = ['Debug', 'Release'].map(kind => join(adapters, '..', 'bin', kind, 'net10.0', 'Nowpose.Gateway.dll'));

const program = builds.find(existsSync);

/** The reason why tests with the gateway are skipped; false if they run. */
export const missing = skipWithout(program !== undefined, 'the gateway is not built: dotnet build Gateway');

/** Starts the gateway and returns its WebSocket address. The gateway is stopped when the test ends. */
export async function start(test, args = []) {
  const child = spawn('dotnet', [program, 'serve', '--sync-port', '0', '--ws-port', '0', ...args], { stdio: ['ignore', 'pipe', 'inherit'] });
  const ended = new Promise(resolve => child.on('close', resolve));
  test.after(async () => {
    child.kill('SIGTERM');
    const late = setTimeout(() => child.kill('SIGKILL'), 5000);
    await ended;
    clearTimeout(late);
  });
  const lines = createInterface({ input: child.stdout });
  let output = '';
  for await (const line of lines) {
    output += line + '\n';
    const address = /wss?:\/\/[^\s/]+:\d+/.exec(line);
    if (!address) continue;
    lines.on('line', () => {});
    child.stdout.resume();
    return address[0];
  }
  throw new Error(`the gateway wrote no address:\n${output}`);
}

/** Starts one gateway for all tests of the enclosing suite. Returns a function that gets its address. */
export function startForSuite(args) {
  let address, stop;
  before(async () => { address = await start({ after: end => { stop = end; } }, args); });
  after(() => stop());
  return () => address;
}

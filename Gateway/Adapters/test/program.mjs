// Runs the program: in the process of the test, or, for tests of the process itself, as a user or the gateway does.
import { spawn } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parts } from './parts.mjs';
import { moment } from './virtualTime.mjs';

export const adapters = join(dirname(fileURLToPath(import.meta.url)), '..');
const bundle = join(adapters, 'dist', 'plant.mjs');

// Timeout of a wait. It is much longer than any event takes on a busy machine.
const PATIENCE_MS = 60_000;

/** The real time, ms, also in a test with virtual time. */
const realTime = performance.now.bind(performance);

const saidIn = run => text => until(() => (text instanceof RegExp ? text.test(run.err) : run.err.includes(text)), () => `"${text}" in:\n${run.err}`);

/**
 * Runs the program in this process, because starting a process takes most of the processor time of a short test. `out` and `err` contain its output;
 * `ended` resolves with its exit status, which is undefined while it runs. `stop` ends it, and so does the end of the test.
 */
export function start(test, args, { env = {} } = {}) {
  const ending = new AbortController(), run = { out: '', err: '', status: undefined };
  const host = {
    environment: { ...process.env, ...env }, ending,
    out: async text => { run.out += text; },
    err: text => { run.err += text; },
    listen: () => {},
  };
  run.ended = parts('program').then(async ({ run: program }) => run.status = await program(args, host));
  run.said = saidIn(run);
  run.stop = () => {
    ending.abort();
    return until(() => run.status !== undefined, () => `the end of the adapter\n${run.err}`).then(() => run.status);
  };
  test.after(() => run.stop());
  return run;
}

/** Starts the bundled program as a process. `child` is the process. The other members are those of `start`. */
export function startProcess(test, args, { env = {}, stdin = 'ignore' } = {}) {
  const child = spawn(process.execPath, [bundle, ...args], { env: { ...process.env, ...env }, stdio: [stdin, 'pipe', 'pipe'] });
  const run = { child, out: '', err: '', status: undefined };
  child.stdout.on('data', part => { run.out += part; });
  child.stderr.on('data', part => { run.err += part; });
  run.ended = new Promise(resolve => child.on('close', (status, signal) => resolve(run.status = status ?? signal)));
  run.said = saidIn(run);
  run.stop = async () => {
    child.kill('SIGTERM');
    const late = setTimeout(() => child.kill('SIGKILL'), 5000);
    await run.ended;
    clearTimeout(late);
    return run.status;
  };
  test.after(() => run.stop());
  return run;
}

/** Runs the program with --check and returns its exit status and output. */
export async function check(test, path, env, launch = start) {
  const run = launch(test, [path, '--check'], { env });
  return { status: await run.ended, out: run.out, lines: run.err.trim().split('\n') };
}

/** Waits until `holds` returns a truthy value, and returns that value. After the timeout it throws an error with the description `what`. */
export async function until(holds, what) {
  const end = realTime() + PATIENCE_MS;
  for (;;) {
    const value = await holds();
    if (value) return value;
    if (realTime() > end) throw new Error(`waited ${PATIENCE_MS} ms for ${typeof what === 'function' ? what() : what}`);
    await moment();
  }
}

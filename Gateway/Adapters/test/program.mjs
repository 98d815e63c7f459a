// Starts the bundled program as a user or the gateway does.
import { spawn } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const adapters = join(dirname(fileURLToPath(import.meta.url)), '..');
const program = join(adapters, 'dist', 'plant.mjs');

// Timeout of a wait. It is much longer than any event takes on a busy machine.
const PATIENCE_MS = 60_000;

/** Starts the program. `out` and `err` contain its output; `ended` resolves with its exit status. It is stopped when the test ends. */
export function start(test, args, { env = {}, stdin = 'ignore' } = {}) {
  const child = spawn(process.execPath, [program, ...args], { env: { ...process.env, ...env }, stdio: [stdin, 'pipe', 'pipe'] });
  const run = { child, out: '', err: '' };
  child.stdout.on('data', part => { run.out += part; });
  child.stderr.on('data', part => { run.err += part; });
  run.ended = new Promise(resolve => child.on('close', (status, signal) => resolve(status ?? signal)));
  run.said = text => until(() => (text instanceof RegExp ? text.test(run.err) : run.err.includes(text)), () => `"${text}" in:\n${run.err}`);
  test.after(async () => {
    child.kill('SIGTERM');
    const late = setTimeout(() => child.kill('SIGKILL'), 5000);
    await run.ended;
    clearTimeout(late);
  });
  return run;
}

/** Runs the program with --check and returns its exit status and output. */
export async function check(test, path, env) {
  const run = start(test, [path, '--check'], { env });
  return { status: await run.ended, out: run.out, lines: run.err.trim().split('\n') };
}

/** Waits until `holds` returns a truthy value, and returns that value. After the timeout it throws an error with the description `what`. */
export async function until(holds, what) {
  const end = performance.now() + PATIENCE_MS;
  for (;;) {
    const value = await holds();
    if (value) return value;
    if (performance.now() > end) throw new Error(`waited ${PATIENCE_MS} ms in vain for ${typeof what === 'function' ? what() : what}`);
    await new Promise(resolve => setTimeout(resolve, 10));
  }
}

// Starts the bundled program the way a person or the gateway starts it.
import { spawn } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const adapters = join(dirname(fileURLToPath(import.meta.url)), '..');
const program = join(adapters, 'dist', 'plant.mjs');

// Much longer than a busy machine needs, so only an event that never comes reaches this timeout.
const PATIENCE_MS = 60_000;

/** Starts the program. `out` and `err` hold its output, `ended` resolves with its exit status. It is stopped after the test at the latest. */
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

/** Runs --check in a process of its own and returns its exit status and output. */
export async function check(test, path, env) {
  const run = start(test, [path, '--check'], { env });
  return { status: await run.ended, out: run.out, lines: run.err.trim().split('\n') };
}

/** Waits until a condition holds. After the timeout it fails with the description `what`. */
export async function until(holds, what) {
  const end = performance.now() + PATIENCE_MS;
  for (;;) {
    const value = await holds();
    if (value) return value;
    if (performance.now() > end) throw new Error(`waited ${PATIENCE_MS} ms in vain for ${typeof what === 'function' ? what() : what}`);
    await new Promise(resolve => setTimeout(resolve, 10));
  }
}

// Starts worker processes and sends requests to them, as the command line does.
import { spawn } from 'node:child_process';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { pattern } from './pictures.mjs';

/** Path of the worker. The environment variable WORKER selects another one, for a comparison. */
const workerPath = process.env.WORKER ?? join(dirname(fileURLToPath(import.meta.url)), '..', 'dist', 'worker.mjs');

/**
 * Starts a worker. Returns its process identifier, a function that sends it a request and returns the response, and a function that ends it.
 * @param words Program that runs the worker, and its options.
 */
export function startWorker(...words) {
  const [program, ...options] = words.length > 0 ? words : ['node'];
  const child = spawn(program, [...options, workerPath], { stdio: ['pipe', 'pipe', 'inherit'] });
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  let last = Promise.resolve();
  const ask = request => {
    child.stdin.write(JSON.stringify(request) + '\n');
    last = last.then(async () => {
      const { value, done } = await lines.next();
      if (done) throw new Error(`the worker ended at ${JSON.stringify(request).slice(0, 200)}`);
      return JSON.parse(value);
    });
    return last;
  };
  ask({ pattern });
  return { pid: child.pid, ask, end: () => child.kill() };
}

/** Returns the responses of several workers to independent requests, in the order of the requests. */
export async function shareOut(requests, workers) {
  const answers = Array(requests.length);
  let next = 0;
  await Promise.all(workers.map(async ({ ask }) => {
    while (next < requests.length) {
      const at = next++;
      answers[at] = await ask(requests[at]);
    }
  }));
  return answers;
}

/** Returns the responses of two new workers to all requests. */
export async function askAll(requests) {
  const workers = [startWorker(), startWorker()];
  try {
    return await shareOut(requests, workers);
  } finally {
    for (const { end } of workers) end();
  }
}

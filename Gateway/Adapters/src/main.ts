// The program plant.mjs CONFIG.yaml [--check] reads a control system and sends its joint positions and its time to a gateway. With --version, it
// prints its version. SIGTERM and SIGINT end it, and for a child process also the end of its parent, which closes the pipe.
import { run } from './program';

const INTERRUPTED = 130;

const ending = new AbortController();
let signalStatus = 0;

function listen(): void {
  process.once('SIGTERM', () => ending.abort());
  process.once('SIGINT', () => {
    signalStatus = INTERRUPTED;
    ending.abort();
  });
  if (process.env.NOWPOSE_SUPERVISED === '1')
    process.stdin
      .on('close', () => ending.abort())
      .on('error', () => ending.abort())
      .resume();
}

void run(process.argv.slice(2), {
  environment: process.env,
  // Waits until the text is written. Otherwise, the end of the process could truncate a string longer than the pipe's buffer.
  out: text => new Promise(done => process.stdout.write(text, done)),
  err: text => void process.stderr.write(text),
  ending,
  listen,
}).then(status => process.exit(status || signalStatus));

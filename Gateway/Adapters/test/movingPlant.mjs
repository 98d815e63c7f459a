// node movingPlant.mjs opcua|ads: starts a control system that moves a youBot. Its clock is minutes ahead and runs too fast.
// Writes its address, and the time of its clock at a count of this machine's monotonic counter. From these a test can compute the
// true position of the robot. With opcua, reads commands, one per line: "stop" (in mid-motion), "bad" or "repair" with the name of a
// variable, and "rest MS"; the response is "done COMMAND", the number of the command and the Unix time in s at which the command took effect. The
// program ends when its input ends.
import { createInterface } from 'node:readline';

const AHEAD_MS = 754_321.5, PPM = 85;

const kinds = {
  async opcua() {
    const { ControlClock, YoubotServer } = await import('./opcua/server.mjs');
    const { Faults } = await import('./opcua/faults.mjs'), { Pace } = await import('./opcua/pace.mjs');
    const clock = new ControlClock({ offsetMs: AHEAD_MS, ppm: PPM });
    const server = await new YoubotServer({ clock, security: ['sign_and_encrypt'] }).start(), faults = new Faults(server), pace = new Pace();
    server.keepsStamps = true;
    server.motion = time => pace.at(time);
    return {
      endpoint: server.endpoint, thumbprint: server.own.thumbprint, now: () => clock.now,
      stop: name => faults.stop(name), bad: name => faults.bad(name), repair: name => faults.repair(name),
      rest: async ms => {
        const end = pace.rest(clock.now, BigInt(ms) * 1_000_000n);
        while (clock.now < end) await new Promise(resolve => setTimeout(resolve, 10));
      },
    };
  },
  async ads() {
    const { AdsServer, runtimePort } = await import('./ads/server.mjs');
    const { youBot } = await import('./ads/youbot.mjs');
    const plc = youBot({ aheadMs: AHEAD_MS, ppm: PPM, cycleMs: 1 }), netId = '5.24.12.7.1.1';
    const port = await new AdsServer(plc, { netId }).listen(0);
    return { endpoint: `ads://127.0.0.1:${port}/${netId}:${runtimePort}`, thumbprint: '-', now: () => plc.now() };
  },
};

const plant = await kinds[process.argv[2]]();

/** Reads counter and clock many times, and writes the pair of values that was read in the shortest time. */
function writeClock() {
  let shortest = Infinity, count = 0n, shown = 0n;
  for (let i = 0; i < 200; i++) {
    const before = process.hrtime.bigint(), now = plant.now(), after = process.hrtime.bigint();
    if (Number(after - before) >= shortest) continue;
    shortest = Number(after - before);
    count = (before + after) / 2n;
    shown = now;
  }
  console.log(`clock ${count} ${shown} ${PPM}`);
}

console.log(`endpoint ${plant.endpoint}`);
console.log(`thumbprint ${plant.thumbprint}`);
writeClock();
console.log('state serving');

const COMMANDS = ['stop', 'bad', 'repair', 'rest'];
let received = 0;

async function obey(line) {
  const [command, argument] = line.split(' ');
  if (!COMMANDS.includes(command)) throw new Error(`unknown command: ${line}`);
  const number = ++received;
  await plant[command](argument);
  console.log(`done ${command} ${number} ${Date.now() / 1000}`);
}

const lines = createInterface({ input: process.stdin });
lines.on('line', line => void obey(line));
lines.on('close', () => process.exit(0)).on('error', () => process.exit(0));

// node movingPlant.mjs opcua|ads: a youBot that moves behind a control system whose clock is minutes off and runs too fast. Tells where
// it is, and what its clock showed at a count of this machine's monotonic counter, so that a test knows where the robot truly was.
// Ends with its input.
const AHEAD_MS = 754_321.5, PPM = 85;

const kinds = {
  async opcua() {
    const { ControlClock, YoubotServer } = await import('./opcua/server.mjs');
    const clock = new ControlClock({ offsetMs: AHEAD_MS, ppm: PPM });
    const server = await new YoubotServer({ clock, security: ['sign_and_encrypt'] }).start();
    return { endpoint: server.endpoint, thumbprint: server.own.thumbprint, now: () => clock.now, step: ms => clock.step(ms) };
  },
  async ads() {
    const { AdsServer, runtimePort } = await import('./ads/server.mjs');
    const { youBot } = await import('./ads/youbot.mjs');
    const plc = youBot({ aheadMs: AHEAD_MS, ppm: PPM, cycleMs: 1 }), netId = '5.24.12.7.1.1';
    const port = await new AdsServer(plc, { netId }).listen(0);
    return { endpoint: `ads://127.0.0.1:${port}/${netId}:${runtimePort}`, thumbprint: '-', now: () => plc.now(), step: ms => plc.step(ms) };
  },
};

const plant = await kinds[process.argv[2]]();

/** The pair that was read in the shortest time of many. */
function tellClock() {
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
tellClock();
console.log('state serving');

process.stdin.on('data', text => {
  const step = /step (-?\d+)/.exec(String(text));
  if (step === null) return;
  plant.step(Number(step[1]));
  tellClock();
});
process.stdin.on('close', () => process.exit(0)).on('error', () => process.exit(0));

// npm run ads-server: starts a simulated PLC with a moving youBot on this machine, to try an adapter or another ADS client. Ctrl-C ends it.
import { parseArgs } from 'node:util';
import { AdsServer, runtimePort } from './server.mjs';
import { youBot } from './youbot.mjs';

const { values } = parseArgs({
  options: {
    port: { type: 'string', default: '48898' },
    'net-id': { type: 'string', default: '5.24.12.7.1.1' },
    'cycle-ms': { type: 'string', default: '10' },
    'ahead-ms': { type: 'string', default: '0' },
    ppm: { type: 'string', default: '0' },
  },
});

const plc = youBot({ cycleMs: Number(values['cycle-ms']), aheadMs: Number(values['ahead-ms']), ppm: Number(values.ppm) });
const port = await new AdsServer(plc, { netId: values['net-id'] }).listen(Number(values.port));
console.log(`ads://127.0.0.1:${port}/${values['net-id']}:${runtimePort}`);
console.log(plc.names.map(name => `  ${name}`).join('\n'));

// npm run opcua-server -- [options]: starts an OPC UA server with a simulated youBot that moves, to try an adapter.
import { parseArgs } from 'node:util';
import { ControlClock, YoubotServer } from './server.mjs';

const { values } = parseArgs({ options: {
  port: { type: 'string', default: '4840' },
  security: { type: 'string', default: 'sign_and_encrypt' },
  'offset-ms': { type: 'string', default: '0' },
  ppm: { type: 'string', default: '0' },
  'clock-step-us': { type: 'string', default: '0.1' },
  user: { type: 'string' },
  stamps: { type: 'string', default: 'good' },
} });

/** Valid and invalid time stamps that the server can send. */
const STAMPS = {
  good: (_, sent) => sent,
  none: (_, sent) => ({ ...sent, sourceTimestamp: new Date(Date.UTC(1601, 0, 1)), sourcePicoseconds: 0 }),
  future: (_, sent) => ({ ...sent, sourceTimestamp: new Date(sent.sourceTimestamp.getTime() + 60_000) }),
  zero: (_, sent) => ({ ...sent, sourceTimestamp: new Date(0), sourcePicoseconds: 0 }),
};

const server = new YoubotServer({
  port: Number(values.port),
  security: values.security.split(','),
  clock: new ControlClock({ offsetMs: Number(values['offset-ms']), ppm: Number(values.ppm) }),
  clockStepUs: Number(values['clock-step-us']),
  users: values.user === undefined ? null : Object.fromEntries([values.user.split(':')]),
});
server.spoil = STAMPS[values.stamps];
await server.start();
console.log(`endpoint ${server.endpoint}
thumbprint ${server.own.thumbprint}
nodes ns=1;s=arm_joint_1 … arm_joint_5 (rad), ns=1;s=positions (array of 7), ns=1;s=gripper_mm, ns=1;s=time_ns`);
for (const signal of ['SIGINT', 'SIGTERM']) process.once(signal, () => void server.stop().then(() => process.exit(0)));

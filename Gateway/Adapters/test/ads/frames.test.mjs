// Compares the frames of the simulated PLC byte for byte with frames that were written by hand from the specification. This shows that the simulated
// PLC follows the specification, and not only the behaviour of one client.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { connect } from 'node:net';
import { test } from 'node:test';
import { FrameReader, state, tcpFrame } from './frames.mjs';
import { Plc } from './plc.mjs';
import { AdsServer } from './server.mjs';
import { PlcSymbol } from './symbols.mjs';

const there = '05 18 0c 07 01 01 53 03', here = 'c0 a8 00 0a 01 01 89 80';
const bytes = hex => Buffer.from(hex.replace(/\s/g, ''), 'hex');
const text = buffer => buffer.toString('hex').replace(/..(?!$)/g, '$& ');

/** Returns a PLC whose cycle takes one day, so no value changes while a test runs. */
const still = () => new Plc([
  new PlcSymbol('MAIN.fA', 'LREAL', () => 1.5),
  new PlcSymbol('G.aB', 'INT', () => [7, -2], { count: 2, first: 1 }),
], { cycleMs: 86_400_000 });

async function served(t, plc, options) {
  const server = new AdsServer(plc, options);
  const port = await server.listen();
  const socket = connect(port, '127.0.0.1');
  await once(socket, 'connect');
  t.after(async () => {
    socket.destroy();
    await server.close();
  });
  const reader = new FrameReader(), frames = [], waiting = [];
  socket.on('data', part => {
    for (const { kind, data } of reader.read(part)) (waiting.shift() ?? (f => frames.push(f)))(text(tcpFrame(kind, data)));
  });
  const next = () => frames.length ? Promise.resolve(frames.shift()) : new Promise(resolve => waiting.push(resolve));
  return { server, socket, next, ask: hex => (socket.write(bytes(hex)), next()) };
}

const exchanges = {
  'ReadDeviceInfo': [
    `00 00 20 00 00 00 ${there} ${here} 01 00 04 00 00 00 00 00 00 00 00 00 01 00 00 00`,
    `00 00 38 00 00 00 ${here} ${there} 01 00 05 00 18 00 00 00 00 00 00 00 01 00 00 00
     00 00 00 00 03 01 b8 0f 50 6c 63 33 30 20 41 70 70 00 00 00 00 00 00 00`,
  ],
  'ReadState': [
    `00 00 20 00 00 00 ${there} ${here} 04 00 04 00 00 00 00 00 00 00 00 00 02 00 00 00`,
    `00 00 28 00 00 00 ${here} ${there} 04 00 05 00 08 00 00 00 00 00 00 00 02 00 00 00 00 00 00 00 05 00 00 00`,
  ],
  'Read of a variable by its place': [
    `00 00 2c 00 00 00 ${there} ${here} 02 00 04 00 0c 00 00 00 00 00 00 00 03 00 00 00 40 40 00 00 00 10 00 00 08 00 00 00`,
    `00 00 30 00 00 00 ${here} ${there} 02 00 05 00 10 00 00 00 00 00 00 00 03 00 00 00
     00 00 00 00 08 00 00 00 00 00 00 00 00 00 f8 3f`,
  ],
  'Read of an unknown group': [
    `00 00 2c 00 00 00 ${there} ${here} 02 00 04 00 0c 00 00 00 00 00 00 00 03 00 00 00 41 41 00 00 00 00 00 00 08 00 00 00`,
    `00 00 28 00 00 00 ${here} ${there} 02 00 05 00 08 00 00 00 00 00 00 00 03 00 00 00 02 07 00 00 00 00 00 00`,
  ],
  'Write, which is not allowed': [
    `00 00 34 00 00 00 ${there} ${here} 03 00 04 00 14 00 00 00 00 00 00 00 04 00 00 00
     40 40 00 00 00 10 00 00 08 00 00 00 00 00 00 00 00 00 00 00`,
    `00 00 24 00 00 00 ${here} ${there} 03 00 05 00 04 00 00 00 00 00 00 00 04 00 00 00 04 07 00 00`,
  ],
  'WriteControl, which is not supported': [
    `00 00 28 00 00 00 ${there} ${here} 05 00 04 00 08 00 00 00 00 00 00 00 05 00 00 00 06 00 00 00 00 00 00 00`,
    `00 00 24 00 00 00 ${here} ${there} 05 00 05 00 04 00 00 00 00 00 00 00 05 00 00 00 01 07 00 00`,
  ],
  'ReadWrite: information about a name': [
    `00 00 38 00 00 00 ${there} ${here} 09 00 04 00 18 00 00 00 00 00 00 00 06 00 00 00
     09 f0 00 00 00 00 00 00 ff ff ff ff 08 00 00 00 4d 41 49 4e 2e 66 41 00`,
    `00 00 55 00 00 00 ${here} ${there} 09 00 05 00 35 00 00 00 00 00 00 00 06 00 00 00 00 00 00 00 2d 00 00 00
     2d 00 00 00 40 40 00 00 00 10 00 00 08 00 00 00 05 00 00 00 00 00 00 00 07 00 05 00 00 00
     4d 41 49 4e 2e 66 41 00 4c 52 45 41 4c 00 00`,
  ],
  'ReadWrite: a name that is not there': [
    `00 00 32 00 00 00 ${there} ${here} 09 00 04 00 12 00 00 00 00 00 00 00 07 00 00 00
     03 f0 00 00 00 00 00 00 04 00 00 00 02 00 00 00 58 00`,
    `00 00 28 00 00 00 ${here} ${there} 09 00 05 00 08 00 00 00 00 00 00 00 07 00 00 00 10 07 00 00 00 00 00 00`,
  ],
  'ReadWrite: two values by one sum command': [
    `00 00 48 00 00 00 ${there} ${here} 09 00 04 00 28 00 00 00 00 00 00 00 08 00 00 00
     80 f0 00 00 02 00 00 00 14 00 00 00 18 00 00 00
     40 40 00 00 08 10 00 00 02 00 00 00 40 40 00 00 0a 10 00 00 02 00 00 00`,
    `00 00 34 00 00 00 ${here} ${there} 09 00 05 00 14 00 00 00 00 00 00 00 08 00 00 00
     00 00 00 00 0c 00 00 00 00 00 00 00 00 00 00 00 07 00 fe ff`,
  ],
  'another target': [
    `00 00 20 00 00 00 05 18 0c 08 01 01 53 03 ${here} 04 00 04 00 00 00 00 00 00 00 00 00 09 00 00 00`,
    `00 00 20 00 00 00 ${here} 05 18 0c 08 01 01 53 03 04 00 05 00 00 00 00 00 07 00 00 00 09 00 00 00`,
  ],
};

for (const [name, [asked, expected]] of Object.entries(exchanges))
  test(`Server_${name.replace(/\W+/g, '')}_AnswersWithTheBytesOfTheSpecification`, async t => {
    const { ask } = await served(t, still());

    assert.equal(await ask(asked), expected.replace(/\s+/g, ' '));
  });

test('Server_Notification_ContainsTimeStampsAndSamples', async t => {
  const plc = new Plc([new PlcSymbol('MAIN.fA', 'LREAL', () => 1.5)], { cycleMs: 5, stampOf: () => 0x01dd0a0b0c0d0e0fn });
  const { ask, next, server } = await served(t, plc);
  const add = `00 00 48 00 00 00 ${there} ${here} 06 00 04 00 28 00 00 00 00 00 00 00 01 00 00 00
    40 40 00 00 00 10 00 00 08 00 00 00 04 00 00 00 00 00 00 00 50 c3 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00`;

  assert.equal(await ask(add), `00 00 28 00 00 00 ${here} ${there} 06 00 05 00 08 00 00 00 00 00 00 00 01 00 00 00 00 00 00 00 01 00 00 00`);
  assert.equal(await next(), `00 00 44 00 00 00 ${here} ${there} 08 00 04 00 24 00 00 00 00 00 00 00 00 00 00 00
    20 00 00 00 01 00 00 00 0f 0e 0d 0c 0b 0a dd 01 01 00 00 00 01 00 00 00 08 00 00 00 00 00 00 00 00 00 f8 3f`.replace(/\s+/g, ' '));
  assert.equal(server.notifications, 1);
  assert.equal(
    await ask(`00 00 24 00 00 00 ${there} ${here} 07 00 04 00 04 00 00 00 00 00 00 00 02 00 00 00 01 00 00 00`),
    `00 00 24 00 00 00 ${here} ${there} 07 00 05 00 04 00 00 00 00 00 00 00 02 00 00 00 00 00 00 00`);
  assert.equal(server.notifications, 0);
});

test('Server_PortOpened_ReturnsAnAddress', async t => {
  const { ask } = await served(t, still());

  assert.equal(await ask('00 10 02 00 00 00 00 00'), '00 10 08 00 00 00 7f 00 00 01 01 01 89 80');
});

test('Server_InConfigMode_HasNoRuntime', async t => {
  const plc = still();
  const { ask } = await served(t, plc);
  plc.systemState = state.config;

  assert.equal(
    await ask(`00 00 20 00 00 00 ${there} ${here} 04 00 04 00 00 00 00 00 00 00 00 00 01 00 00 00`),
    `00 00 20 00 00 00 ${here} ${there} 04 00 05 00 00 00 00 00 06 00 00 00 01 00 00 00`);
});

test('Server_RequestOfASenderWithoutRoute_ClosesTheConnection', async t => {
  const { socket } = await served(t, still(), { routes: ['10.0.0.1.1.1'] });
  const closed = once(socket, 'close');

  socket.write(bytes(`00 00 20 00 00 00 ${there} ${here} 04 00 04 00 00 00 00 00 00 00 00 00 01 00 00 00`));

  await closed;
});

// Runs Debian's mosquitto on a port of this machine, configured like the example.
import { spawn, spawnSync } from 'node:child_process';
import { connect } from 'node:net';
import { join } from 'node:path';
import { writeFileSync } from 'node:fs';
import { skipWithout } from '../../../../Web/test/required.mjs';
import { freePort } from '../freePort.mjs';
import { until } from '../program.mjs';
import { temporaryFolder } from '../temporary.mjs';

const program = ['mosquitto', '/usr/sbin/mosquitto'].find(name => spawnSync(name, ['-h']).error === undefined);

/** The reason why tests with mosquitto are skipped on this machine; false if they run. */
export const missing = skipWithout(program !== undefined, 'mosquitto is not installed: apt-get install mosquitto');

export class Mosquitto {
  static async start(test, lines = ['allow_anonymous true']) {
    const broker = new Mosquitto();
    broker.port = await freePort();
    broker.url = `mqtt://127.0.0.1:${broker.port}`;
    broker.file = join(temporaryFolder(), 'mosquitto.conf');
    // If root starts mosquitto, it switches to another user, who cannot read the files of the test.
    const user = process.getuid?.() === 0 ? ['user root'] : [];
    writeFileSync(broker.file, [...user, `listener ${broker.port} 127.0.0.1`, ...lines, 'persistence false', 'log_dest none', ''].join('\n'));
    test.after(() => broker.stop());
    await broker.run();
    return broker;
  }

  async run() {
    this.child = spawn(program, ['-c', this.file], { stdio: 'ignore' });
    this.ended = new Promise(resolve => this.child.on('close', resolve));
    await until(() => answers(this.port), 'mosquitto');
  }

  /** Pauses the broker: it neither reads nor writes, but its connections stay open. */
  stall() { this.child.kill('SIGSTOP'); }
  resume() { this.child.kill('SIGCONT'); }

  async stop() {
    this.child.kill('SIGKILL');
    await this.ended;
  }
}

function answers(port) {
  return new Promise(resolve => {
    const socket = connect(port, '127.0.0.1', () => {
      socket.destroy();
      resolve(true);
    });
    socket.on('error', () => resolve(false));
  });
}

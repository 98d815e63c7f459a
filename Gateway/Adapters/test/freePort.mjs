import { once } from 'node:events';
import { createServer } from 'node:net';

/**
 * Finds a free port for a program that cannot choose one itself. Uses a port below 32768: from there on, the system assigns ports to connections,
 * one of which could take the port before the program listens.
 */
export async function freePort() {
  for (;;) {
    const port = 20_000 + Math.floor(Math.random() * 12_000), server = createServer();
    try {
      await once(server.listen(port, '127.0.0.1'), 'listening');
    } catch {
      continue;
    }
    await new Promise(resolve => server.close(resolve));
    return port;
  }
}

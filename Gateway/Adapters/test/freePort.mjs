import { once } from 'node:events';
import { createServer } from 'node:net';

const first = 20_000, ports = 6000;

/**
 * Finds a free port for a program that cannot choose one itself, or that stops and listens again, and reserves it for this process: two tests that
 * find the same port before one of their programs listens would use the same program. The reservation is a server that listens on another port until
 * the process ends. All ports are below 32768, where the system assigns ports to connections.
 */
export async function freePort() {
  for (;;) {
    const port = first + Math.floor(Math.random() * ports), reservation = await listening(port + ports), trial = reservation && await listening(port);
    if (trial) {
      await new Promise(resolve => trial.close(resolve));
      reservation.unref();
      return port;
    }
    reservation?.close();
  }
}

/** Returns a server that listens on a port; null if the port is taken. */
async function listening(port) {
  const server = createServer();
  try {
    await once(server.listen(port, '127.0.0.1'), 'listening');
    return server;
  } catch (error) {
    if (error.code !== 'EADDRINUSE') throw error;
    return null;
  }
}

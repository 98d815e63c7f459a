import { once } from 'node:events';
import type { Socket } from 'node:net';

/**
 * Calls a function after a time in ms, and after the data that have arrived by then: after a pause of this process, such as a snapshot of a virtual
 * machine, Node.js calls the functions of timers before it reads the sockets.
 * @returns A function that cancels the call.
 */
export function afterArrivals(ms: number, then: () => void): () => void {
  let waiting: NodeJS.Immediate | undefined;
  const timer = setTimeout(() => {
    waiting = setImmediate(then);
  }, ms);
  return () => {
    clearTimeout(timer);
    clearImmediate(waiting);
  };
}

/** Gets the address of a TCP port for messages. */
export const placeOf = ({ host, port }: { host: string; port: number }): string => (host.includes(':') ? `[${host}]:${port}` : `${host}:${port}`);

/**
 * Waits until a new socket is connected, and destroys it if it fails.
 * @param event Event after which the socket can be used.
 * @param stop Ends the wait when it is aborted.
 * @throws Error The connection failed; its code is ETIMEDOUT if nothing arrived within the given time.
 */
export async function opened<T extends Socket>(socket: T, event: 'connect' | 'secureConnect', ms: number, stop?: AbortSignal): Promise<T> {
  socket.setTimeout(ms, () => socket.destroy(Object.assign(new Error('no response'), { code: 'ETIMEDOUT' })));
  try {
    await once(socket, event, { signal: stop });
    socket.setTimeout(0);
    return socket;
  } catch (error) {
    socket.on('error', () => {}).destroy();
    throw error;
  }
}

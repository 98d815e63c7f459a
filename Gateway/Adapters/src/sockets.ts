import { once } from 'node:events';
import type { Socket } from 'node:net';

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

import type WebSocket from 'ws';

const PING_MS = 2000;

/** Number of pings without a response after which the other end counts as silent. */
const MAX_UNANSWERED = 3;

/**
 * Pings the other end of a connection every 2 s, and detects that it no longer responds, also while the connection is opened or closed. Pings are
 * counted, because the time also passes while this process is paused and sends none.
 * @param pinged Called after each ping.
 * @param silent Called with the time without a response, s.
 * @returns A function that ends the pings.
 */
export function ping(socket: WebSocket, pinged: () => void, silent: (seconds: number) => void): () => void {
  let unanswered = 0;
  const hear = (): void => {
    unanswered = 0;
  };
  socket.on('open', hear).on('ping', hear).on('pong', hear).on('message', hear);
  const check = (): void => {
    if (unanswered === MAX_UNANSWERED) return silent((MAX_UNANSWERED * PING_MS) / 1000);
    unanswered++;
    if (socket.readyState !== socket.OPEN) return;
    socket.ping();
    pinged();
  };
  // After a pause of this process, the messages that have arrived are read before setImmediate continues.
  const beat = setInterval(() => setImmediate(check), PING_MS);
  return () => clearInterval(beat);
}

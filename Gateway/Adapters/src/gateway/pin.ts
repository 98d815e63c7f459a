import { createHash, timingSafeEqual } from 'node:crypto';
import { Agent } from 'node:https';
import type { Duplex } from 'node:stream';
import { connect, type ConnectionOptions, type TLSSocket } from 'node:tls';
import { gatewayMessages } from '../messages/gateway';

/** Gets the pin of a public key: its SHA-256 in the form of RFC 7469. */
const pinOf = (publicKeyInfo: Buffer): string => `sha256/${createHash('sha256').update(publicKeyInfo).digest('base64')}`;

/**
 * Connects only to a server with the pinned key. Another server receives nothing beyond the TLS handshake.
 * @remarks Checks the key only, not the name, issuer and dates of the certificate.
 */
export class PinnedAgent extends Agent {
  constructor(readonly pin: string) {
    super({ keepAlive: false, maxCachedSessions: 0 });
  }

  // Returns undefined and passes the socket to the callback, so that the request starts only after the check.
  createConnection(options: ConnectionOptions, ready: (error: Error | null, socket?: Duplex) => void): undefined {
    const socket = connect({ ...options, rejectUnauthorized: false, minVersion: 'TLSv1.2' });
    const fail = (error: Error): void => ready(error);
    socket.once('error', fail);
    socket.once('secureConnect', () => {
      socket.off('error', fail);
      const problem = pinProblem(socket, this.pin);
      if (problem === null) return ready(null, socket);
      socket.destroy();
      ready(new Error(problem));
    });
    return undefined;
  }
}

/** Gets the reason for refusing a server without the pinned key; null if the server has this key. */
export function pinProblem(socket: TLSSocket, pin: string): string | null {
  const found = socket.getPeerX509Certificate()?.publicKey.export({ type: 'spki', format: 'der' });
  if (found === undefined) return gatewayMessages.noCertificate;
  return isSame(pinOf(found), pin) ? null : gatewayMessages.otherPin(pinOf(found));
}

const isSame = (a: string, b: string): boolean => a.length === b.length && timingSafeEqual(Buffer.from(a), Buffer.from(b));

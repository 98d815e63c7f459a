import { createHash, timingSafeEqual } from 'node:crypto';
import { Agent } from 'node:https';
import type { Duplex } from 'node:stream';
import { connect, type ConnectionOptions, type TLSSocket } from 'node:tls';
import { gatewayMessages } from '../messages/gateway';

/** Gets the pin of a public key: its SHA-256 in the form of RFC 7469. */
const pinOf = (publicKeyInfo: Buffer): string => `sha256/${createHash('sha256').update(publicKeyInfo).digest('base64')}`;

/** The error for a server that does not have the pinned key. */
export class WrongKeyError extends Error {}

/**
 * Connects only to a server with the pinned key. Another server receives nothing beyond the TLS handshake.
 * @remarks Checks the key only, not the name, issuer and dates of the certificate.
 */
class PinnedAgent extends Agent {
  constructor(
    readonly pin: string,
    readonly name: string,
  ) {
    super({ keepAlive: false, maxCachedSessions: 0 });
  }

  // Returns undefined and passes the socket to the callback, so that the request starts only after the check.
  createConnection(options: ConnectionOptions, ready: (error: Error | null, socket?: Duplex) => void): undefined {
    const socket = connect({ ...options, rejectUnauthorized: false, minVersion: 'TLSv1.2' });
    const fail = (error: Error): void => ready(error);
    socket.once('error', fail);
    socket.once('secureConnect', () => {
      socket.off('error', fail);
      const problem = pinProblem(socket, this.pin, this.name);
      if (problem === null) return ready(null, socket);
      socket.destroy();
      ready(new WrongKeyError(problem));
    });
    return undefined;
  }
}

/**
 * Creates the agent of a TLS connection.
 * @param pin The pin of the server's key; null if this machine must trust its certificate.
 * @param name Name of the server, for the message.
 */
export const agentFor = (pin: string | null, name: string): Agent =>
  pin === null ? new Agent({ keepAlive: false, minVersion: 'TLSv1.2' }) : new PinnedAgent(pin, name);

/** Gets the reason for refusing a server without the pinned key; null if the server has this key. */
export function pinProblem(socket: TLSSocket, pin: string, name = 'gateway'): string | null {
  const found = socket.getPeerX509Certificate()?.publicKey.export({ type: 'spki', format: 'der' });
  if (found === undefined) return gatewayMessages.noCertificate;
  return isSame(pinOf(found), pin) ? null : gatewayMessages.otherPin(name, pinOf(found));
}

const isSame = (a: string, b: string): boolean => a.length === b.length && timingSafeEqual(Buffer.from(a), Buffer.from(b));

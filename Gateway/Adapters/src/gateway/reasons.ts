import type { PeerCertificate } from 'node:tls';
import { isOtherName, isUnknownHost, isUntrusted } from '../connectionErrors';
import { gatewayMessages } from '../messages/gateway';
import { WrongKeyError } from './pin';

/** HTTP statuses with which a gateway refuses a token: the second one after many wrong tokens within a minute. */
const REFUSED_TOKEN = [401, 429];

/** Maximum length of a message in bytes. */
export const MAX_MESSAGE = 2 * 1024 ** 2;

const RESET = ['ECONNRESET', 'EPIPE'];

/**
 * Gets the reason why a connection failed, with the remedy.
 * @param name Name of the gateway or rosbridge.
 * @param wasOpen Whether the connection was established.
 */
export function inWords(error: Error, name: string, wasOpen: boolean): string {
  const code = (error as NodeJS.ErrnoException).code;
  if (code === 'WS_ERR_UNSUPPORTED_MESSAGE_LENGTH') return gatewayMessages.messageTooLong(name, MAX_MESSAGE / 1024 ** 2);
  if (wasOpen) return RESET.includes(code!) ? gatewayMessages.closed : error.message;
  if (code === 'ECONNREFUSED') return gatewayMessages.refuses;
  if (isUnknownHost(code)) return gatewayMessages.unknownHost(name);
  if (isOtherName(code)) {
    const { host, cert } = error as Error & { host: string; cert: PeerCertificate };
    return gatewayMessages.otherName(name, host, cert.subjectaltname ?? 'no name');
  }
  if (isUntrusted(code)) return gatewayMessages.notTrusted(name, code!);
  if (error instanceof WrongKeyError) return error.message;
  return gatewayMessages.noServer(name, code ?? error.message);
}

/** Gets the reason why a server refused a connection with this HTTP status. */
export function refusalInWords(status: number, name: string): string {
  if (name !== 'gateway') return gatewayMessages.noServer(name, `HTTP status ${status}`);
  if (status === 503) return gatewayMessages.full;
  return REFUSED_TOKEN.includes(status) ? gatewayMessages.noToken(status) : `HTTP status ${status}`;
}

import { gatewayMessages } from '../messages/gateway';

/** HTTP statuses with which a gateway refuses a token: the second one after many wrong tokens within a minute. */
const REFUSED_TOKEN = [401, 429];

/** Gets the reason why a connection failed, with the remedy. */
export function inWords(error: Error): string {
  const code = (error as NodeJS.ErrnoException).code;
  if (code === 'ECONNREFUSED') return gatewayMessages.refuses;
  if (code?.includes('CERT') || code?.includes('SELF_SIGNED') || code?.includes('UNABLE_TO')) return gatewayMessages.notTrusted(code);
  return error.message;
}

/** Gets the reason why a gateway refused a connection with this HTTP status. */
export const refusalInWords = (status: number): string =>
  REFUSED_TOKEN.includes(status) ? gatewayMessages.noToken(status) : `HTTP status ${status}`;

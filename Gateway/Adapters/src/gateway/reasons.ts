import { gatewayMessages } from '../messages/gateway';

/** Gets the reason why a connection failed, with the remedy. */
export function inWords(error: Error): string {
  const code = (error as NodeJS.ErrnoException).code;
  if (code === 'ECONNREFUSED') return gatewayMessages.refuses;
  if (code?.includes('CERT') || code?.includes('SELF_SIGNED') || code?.includes('UNABLE_TO')) return gatewayMessages.notTrusted(code);
  return error.message;
}

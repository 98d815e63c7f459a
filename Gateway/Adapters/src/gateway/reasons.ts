/** Returns why a connection failed, with what to do. */
export function inWords(error: Error): string {
  const code = (error as NodeJS.ErrnoException).code;
  if (code === 'ECONNREFUSED') return 'nothing listens there; check that it runs';
  if (code?.includes('CERT') || code?.includes('SELF_SIGNED') || code?.includes('UNABLE_TO'))
    return `its certificate is not trusted (${code}); set gateway.pin to what the gateway prints`;
  return error.message;
}

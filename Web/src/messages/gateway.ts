/** Reasons why a page has no data from its gateway. */
export const gatewayReasons = {
  noAnswer: 'the gateway does not respond',
  tokenRequired: 'the gateway requires a token',
  tokenRefused: 'the gateway refuses this token',
  refused: (reason: string) => `the gateway refuses the request: ${reason}`,
};

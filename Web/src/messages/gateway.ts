/** Reasons why a page has no data from its gateway. */
export const gatewayReasons = {
  noAnswer: 'the gateway does not respond',
  notUnderstood: 'this page cannot show the response of the gateway; reload the page',
  notFromGateway: (status: number) =>
    `the response with status ${status} is not from the gateway; open this page at the address that the gateway prints, not below another path`,
  tokenRequired: 'the gateway requires a token',
  tokenRefused: 'the gateway refuses this token',
  refused: (reason: string) => `the gateway refuses the request: ${reason}`,
};

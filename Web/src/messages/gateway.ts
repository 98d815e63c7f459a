/** Reasons why a page has no data from its gateway. */
export const gatewayReasons = {
  noAnswer: 'the gateway does not respond',
  noAnswerOrCertificate: 'the gateway does not respond, or its certificate has changed; if the gateway is running, reload the page',
  notUnderstood: 'this page cannot show the response of the gateway; reload the page',
  notFromGateway: (status: number) =>
    `the response with status ${status} is not from the gateway; open this page at the address that the gateway prints, not below another path`,
  tokenRequired: 'the gateway requires a token',
  tokenRefused: 'the gateway refuses this token',
  refused: (reason: string) => `the gateway refuses the request: ${reason}`,
};

/** Texts about the connection to a gateway, and about the versions of gateway and adapter. */
export const gatewayMessages = {
  notConnected: (name: string) => `${name} is not connected`,
  notAnswered: (service: string, seconds: number) => `${service} was not answered within ${seconds} s`,
  silent: (seconds: number) => `no message for ${seconds} s`,
  noToken: '401, the token is missing or unknown to the gateway; give the adapter a token of a source',
  measuring: (name: string) => `${name} measures this clock; it forwards positions after the measurement`,
  noService: (service: string) => `no service ${service} here`,
  refuses: 'nothing listens there; check that it runs',
  notTrusted: (code: string) => `its certificate is not trusted (${code}); set gateway.pin to what the gateway prints`,
  noCertificate: 'the gateway presented no certificate; start it with --tls or --certificate',
  otherPin: (pin: string) => `the gateway has the pin ${pin} but the configuration has another; if the gateway's key was renewed, set the pin to it`,
  versionFits: (version: string) => `the gateway's version ${version} fits`,
  otherVersion: (version: string, own: string) => `the gateway has version ${version}, this adapter has ${own}; install the same version`,
};

/** Texts about the clock of a plant. */
export const clockMessages = {
  stopped: 'the clock does not advance',
  notConnected: 'the plant is not connected',
  steps: (stepMs: number) => `its clock advances in steps of ${Math.round(stepMs)} ms`,
  coarse: (steps: string) =>
    `${steps}, too coarse for headsets; name a time that advances in smaller steps, or make the clock of the control system advance in smaller steps`,
  fineAgain: 'the resolution of its clock is sufficient again',
  noTime: (node: string) => `${node} does not contain a valid time`,
  notReadable: (reason: string) => `its clock cannot be read: ${reason}`,
};

/** Texts about the log. */
export const logMessages = {
  moreLines: (text: string, count: number, seconds: number) => `${text} (the newest of ${count} more lines within ${seconds} s)`,
};

/** Parts of the summary of a configuration. */
export const summaryMessages = {
  adsStamp: 'the stamp of ADS',
  onlyClock: 'only its clock',
  stamps: (stamp: string, samplingMs: number, publishingMs: number) =>
    `t_k is ${stamp}, sampled every ${samplingMs} ms, published every ${publishingMs} ms`,
  timeVariable: (name: string) => `the variable ${name}`,
};

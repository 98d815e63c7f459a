/** Gets the entry of the configuration with the address or the pin of a gateway or of a robot's rosbridge. */
const entryOf = (name: string, part: 'url' | 'pin'): string => {
  if (name === 'gateway') return `gateway.${part}`;
  return part === 'pin' ? 'plant.pin' : 'plant.endpoint';
};

/** Gets the remedy for a certificate that is not trusted. */
const setPin = (name: string): string => `set ${entryOf(name, 'pin')} to the pin of its key${name === 'gateway' ? ', which it prints' : ''}`;

/** Messages about the connection to a gateway or rosbridge, given by its name, and about the versions of gateway and adapter. */
export const gatewayMessages = {
  notConnected: (name: string) => `${name} is not connected`,
  notAnswered: (service: string, seconds: number) => `${service} did not respond within ${seconds} s`,
  silent: (seconds: number) => `nothing was received for ${seconds} s`,
  noToken: (status: number) =>
    `HTTP status ${status}: the token is missing or unknown to the gateway; set gateway.token_file to a token with the role source`,
  measuring: (name: string) => `${name} is measuring this clock; it forwards positions after the measurement`,
  noService: (service: string) => `this adapter has no service ${service}`,
  messageTooLong: (name: string, most: number) =>
    `the ${name} sent a message of more than ${most} MiB, which ended the connection`
    + (name === 'gateway' ? '' : '; set plant.topics.robot_description to false if it is the description, or read another topic'),
  notJson: 'a message is not a JSON object; check that the server is a rosbridge server',
  refuses: 'the connection was refused; check the port, and check that the program is running there',
  closed: 'connection closed',
  noServer: (name: string, problem: string) =>
    `no ${name} responds (${problem}); check ${entryOf(name, 'url')}: the port, and whether the server uses ws:// or wss://`,
  unknownHost: (name: string) => `the host name is unknown; correct ${entryOf(name, 'url')}`,
  notTrusted: (name: string, code: string) => `the certificate is not trusted (${code}); ${setPin(name)}`,
  /** @param names The names in the certificate, such as "DNS:cell, IP Address:10.0.0.7". */
  otherName: (name: string, host: string, names: string) =>
    `the certificate of the ${name} does not contain ${host}, but ${names}; enter one of these in ${entryOf(name, 'url')}, renew the certificate `
    + `with ${host}, or ${setPin(name)}`,
  full: 'HTTP status 503: the gateway has reached its maximum number of connections; close unneeded clients, or increase max-connections',
  noCertificate: 'the gateway sent no certificate; start it with --tls or --certificate',
  otherPin: (name: string, pin: string) =>
    `the pin of the ${name} is ${pin}, but the configuration contains another; set the pin to this value only if its key was renewed`,
  versionFits: (version: string) => `the gateway's version ${version} is compatible with this adapter`,
  otherVersion: (version: string, own: string) =>
    `the gateway has version ${version}, but this adapter has version ${own}; install the same version of both`,
};

/** Ends the message about a refusal of user and password. */
export const laterLogin =
  'the adapter tries again after about 30 s, then at intervals of up to 5 min, so that the account is not locked; restart the adapter to try at once';

/** Messages about the clock of a plant. */
export const clockMessages = {
  stopped: 'the clock does not advance',
  notConnected: 'the plant is not connected',
  steps: (stepMs: number) => `the plant's clock advances in steps of ${Math.round(stepMs)} ms`,
  coarse: (steps: string) =>
    `${steps}, which is too coarse for headsets; the steps must be below 50 ms: use another time variable, or set the clock to smaller steps`,
  fineAgain: "the resolution of the plant's clock is sufficient again",
  notReadable: (reason: string) => `the plant's clock cannot be read: ${reason}`,
};

/** Messages about the log. */
export const logMessages = {
  moreLines: (text: string, count: number, seconds: number) => `${text} (the newest of ${count} more lines within ${seconds} s)`,
};

/** Phrases from which the summary of a configuration is composed. */
export const summaryMessages = {
  adsStamp: 'the time stamp of ADS',
  onlyClock: 'only the clock is read',
  stamps: (stamp: string, samplingMs: number, publishingMs: number) =>
    `t_k is ${stamp}, sampled every ${samplingMs} ms, published every ${publishingMs} ms`,
  timeVariable: (name: string) => `the variable ${name}`,
};

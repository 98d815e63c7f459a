import { wrongValue } from './configuration';
import { laterLogin } from './gateway';

/** Error messages about a configuration of kind opcua. */
export const opcuaSettingMessages = {
  namespace: (value: unknown) => wrongValue(value, 'the namespace (ns) must be a number from 0 to 65535'),
  numericId: (value: unknown) => wrongValue(value, 'the numeric id (i) must be a number from 0 to 4294967295'),
  open: wrongValue(
    'none',
    'anyone on the network can read the data and impersonate the plant: use sign_and_encrypt, or add i_know_this_is_open: true',
  ),
  notOpen: (mode: string) => `not used with security.mode: ${mode}, because the connection is secure; remove this entry`,
  passwordAndCertificate: (name: string) =>
    `the user ${name} has a name and a certificate; keep either name and password_file or certificate and key`,
};

/** Messages about certificates and their folder. */
export const certificateMessages = {
  own: (file: string, thumbprint: string) => `own certificate ${file}, thumbprint ${thumbprint}: the server must trust it`,
  notStored: (folder: string, code: string) =>
    `certificates cannot be stored in ${folder} (${code}); give this user write access, or set plant.security.folder to another folder`,
  notFolder: (path: string) => `${path} is not a folder`,
  otherKey: (file: string, keyFile: string) =>
    `the certificate ${file} does not belong to the key ${keyFile}; delete both files, restart, and let the server trust the new certificate`,
  notTrusted: (sha1: string, sha256: string, cure: string) =>
    `the server's certificate is not trusted; its thumbprint is ${sha1} (SHA-1), ${sha256} (SHA-256). ${cure}`,
  move: (file: string, folder: string) =>
    `If this is the certificate of your server, move ${file} to ${folder}, or set plant.security.thumbprint to this thumbprint`,
  addThumbprint: (reason: string) =>
    `The certificate could not be stored (${reason}). If it is the certificate of your server, set plant.security.thumbprint to this thumbprint`,
  outOfDate: (thumbprint: string, from: string, to: string) =>
    `the server's certificate ${thumbprint} is valid only from ${from} to ${to}; renew it on the server, then trust the new certificate`,
};

const ONE_CLOCK =
  'they are from another clock than the one that headsets use: synchronise both, set plant.timestamp: server, or read the time of the source (plant.time)';

/** Messages about the connection to an OPC UA server. */
export const opcuaMessages = {
  notSecure: 'WARNING: plant.security.mode is none: the server is not authenticated, and anyone on the network can read and change its values',
  notConnected: 'the session with the server has ended',
  lost: 'the connection was lost',
  aborted: 'the server aborted the connection',
  closed: 'the connection was closed',
  ended: 'the connection ended',
  sessionClosed: 'the server closed the session',
  subscriptionEnded: 'the server ended the subscription',
  subscriptionStatus: (status: string) => `the server ended the subscription (${status})`,
  /**
   * @param lifetime Time for which the server keeps a subscription without a client, s.
   * @param silence Time without notifications after which the adapter reconnects, s.
   */
  unmodified: (reason: string, lifetime: number, silence: number) =>
    `the server does not modify its subscription (${reason}), so it keeps the subscription for ${lifetime} s after a lost connection; if it then has no `
    + `free subscription, wait for this time; if it no longer sends notifications, the adapter reconnects only after ${silence} s`,
  slow: (samplingMs: number, publishingMs: number) =>
    `the server samples every ${samplingMs} ms and sends every ${publishingMs} ms, less often than requested, so headsets show moving joints and `
    + 'objects less accurately, and with more than 100 ms mostly as held; lower the minimum sampling and publishing intervals of the server (TIA '
    + 'Portal: OPC UA > Server; Codesys: ItemMinSamplingRate below [CmpOPCUAServer] in CODESYSControl.cfg), or set plant.sampling_ms and '
    + 'plant.publishing_ms to these values',
  stampsAhead: (apartMs: number) =>
    `the source timestamps of all changes are at least ${apartMs.toFixed(1)} ms later than the server's; ${ONE_CLOCK}`,
  stampsBehind: (apartMs: number) =>
    `the source timestamps of all changes are at least ${apartMs.toFixed(1)} ms older than the server's; if this is not the age of the values, ${ONE_CLOCK}`,
  silent: (seconds: number) => `nothing was published for ${seconds} s`,
  notReadable: (reason: string) => `the nodes cannot be read: ${reason}`,
  noResponse: 'the server does not respond',
  rareTime: 'the server rarely updates CurrentTime, so its clock is read from the time stamps of its responses',
  noTimeOfAnswer: "the server's response has no time stamp",
  notAllowed: (request: string) => `${request} is not allowed; the adapter only reads`,
  noServer: (endpoint: string) => `no OPC UA server responds at ${endpoint}; check that the server is running, and check plant.endpoint`,
};

/** Reasons why a server refuses this adapter, with the remedy. */
export const opcuaRefusalMessages = {
  adapterNotValidNow: (status: string) =>
    `the adapter's certificate is not valid at the time of the server's clock (${status}); compare the clocks of server and gateway`,
  adapterNotTrusted: (status: string, file: string, thumbprint: string) =>
    `the server does not trust this adapter (${status}); accept the certificate ${file}, thumbprint ${thumbprint}, on the server`,
  user: (name: string) =>
    `the server does not accept the user ${name}; check name and password in plant.user, and the rights of this user on the server; ${laterLogin}`,
  noRight: (status: string) => `the server refuses a request after the login (${status}); give this user the right to read on the server`,
  anonymous: 'the server does not accept an anonymous user or this certificate; set plant.user to a user with read access',
  noOpenEndpoint: 'the server offers no connection without security; remove plant.security.mode',
  noPolicy: (policy: string) =>
    `the server offers no SignAndEncrypt with ${policy}; choose another plant.security.policy, or enable this policy on the server`,
  login: 'the server does not support this kind of login; use another one in plant.user: password_file, certificate and key, or no user',
  noFreeSession: 'the server has no free session or connection; close a connection of another client',
};

const TIMES =
  'set plant.time to a variable of type DateTime, Int64, UInt64 or Double; 32 bits are too few, because a whole number would wrap and a REAL is too coarse';

/** Reasons why a node cannot be read, or its value cannot be used. */
export const nodeMessages = {
  noNamespace: (place: string, node: string) => `${place}: value ${node}; the server has no such namespace`,
  namespaces: (problems: string, namespaces: string[]) => `${problems}; the namespaces of the server: ${namespaces.join(', ')}`,
  otherNamespaces: 'the server has other namespaces now',
  unknown: (place: string, node: string, status: string) =>
    `${place}: value ${node}; the server returned ${status}; look up the node id in an OPC UA browser`,
  noneReadable: (problems: string) =>
    `${problems}; no value can be read: check that the PLC publishes its variables on this server, and the rights of plant.user`,
  gone: (place: string, node: string, status: string) => `${place}: value ${node}; the server no longer has this node (${status})`,
  notMonitored: (place: string, status: string) => `${place}: the server returned ${status}`,
  missing: (node: string, status: string) => `the server has no node ${node} (${status})`,
  notReadable: (node: string, status: string) => `${node} cannot be read: ${status}`,
  noValue: 'the node has no value',
  badStatus: (status: string, description: string) => `the server returned ${status}, ${description}`,
  array: (node: string) => `${node} is an array; add index`,
  notArray: (node: string) => `${node} is not an array; remove index`,
  index: (node: string, count: number) =>
    count === 0 ? `${node} is an array without elements` : `${node} has ${count} elements; allowed: an index from 0 to ${count - 1}`,
  /** @param stated Unit that the server states. */
  otherUnit: (stated: string, unit: string, nodes: string[]) =>
    `the server states the unit ${stated} for values that are read in ${unit}; set unit: ${stated} for ${nodes.join(', ')}`,
  notTime: `the value is not a time; ${TIMES}`,
  noTime: (node: string) => `${node} does not contain a valid time; ${TIMES}`,
  noTimeOfCycle: (node: string, groupMs: string) =>
    `no value of ${node} has a time stamp within ${groupMs} ms (group_ms) of the time stamp of this value; `
    + 'if the server stamps the variables of a cycle one by one, increase group_ms',
};

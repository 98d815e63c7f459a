import { laterLogin } from './gateway';

/** Error messages about a configuration of kind broker, and the parts of its summary. */
export const brokerSettingMessages = {
  publishing: (gateway: string, endpoint: string, topic: string) => `from ${gateway} to broker ${endpoint}, topics ${topic}/…`,
  subscribing: (endpoint: string, topic: string, gateway: string, place: string) =>
    `from broker ${endpoint}, topics ${topic}/…, to ${gateway}; time from ${place}`,
  unusedClock: 'not used with direction: publish, because only the receiving bridge reads the time; remove clock',
  noClock: "missing; add the host and the sync port of the plant's gateway, because the time stamps refer to its control clock",
  tokenInClear: "a token is sent only over TLS or within this machine; add the pin of the plant's gateway, or tls: true",
};

/** Messages about the connection to a broker, and about the gateway on the broker's other side. */
export const brokerMessages = {
  notSecure:
    'the connection to the broker is neither encrypted nor authenticated (plain: true): anyone with access to its network can impersonate the plant',
  packetTooLong: (most: number) => `the broker sent a packet of more than ${most} KiB; check which client publishes it`,
  closed: 'the broker closed the connection',
  silent: (endpoint: string) => `${endpoint} does not respond; check the broker and the network`,
  subscriptionRefused: (topic: string, reason: string) =>
    `the broker refuses the subscription to ${topic}: ${reason}; check the user's rights on the broker`,
  publicationRefused: (topic: string, reason: string) =>
    `the broker refuses the messages on ${topic}: ${reason}; check the user's rights on the broker`,
  notReadable: (topic: string) =>
    `the broker refuses to let this bridge read ${topic}/…, so signals and objects of an earlier run may stay there; give its user the right to read`,
  refuses: (endpoint: string) => `${endpoint} refuses the connection; check that the broker is running, and check the port in plant.endpoint`,
  refusesWith: (endpoint: string, reason: string) => `the broker at ${endpoint} responds: ${reason}; check the broker's log and limits`,
  loginRefused: (endpoint: string) => `${endpoint} refuses the login; check plant.user, and the user's rights on the broker; ${laterLogin}`,
  anonymousRefused: (endpoint: string) => `${endpoint} refuses a login without a user; set plant.user`,
  unknownHost: (endpoint: string) => `the host name in ${endpoint} is unknown; correct plant.endpoint`,
  noMqtt5: (endpoint: string) => `${endpoint} does not support MQTT 5; enable it in the broker, or update the broker`,
  noBroker: (endpoint: string, problem: string) =>
    `no MQTT broker responds at ${endpoint} (${problem}); check plant.endpoint: the port, and whether the broker uses mqtt:// or mqtts://`,
  otherHost: (endpoint: string) =>
    `the broker's certificate is not valid for the host name in ${endpoint}; enter a name or address of the certificate in plant.endpoint`,
  notTrusted: (code: string) =>
    `the broker's certificate is not trusted (${code}); set plant.authority_file to the certificate of the authority that issued it`,
  /** @param alert TLS alert of the broker. */
  certificateRefused: (alert: string) =>
    `the broker requires a certificate of this client, or does not accept it (${alert}); set plant.user.certificate and plant.user.key to a `
    + 'certificate that the broker accepts',
  /** @param alert TLS alert of the broker. */
  handshakeRefused: (alert: string) =>
    `the broker refuses the TLS connection (${alert}); if it requires a certificate of this client, set plant.user.certificate and plant.user.key; `
    + 'if it selects its certificate by host name, enter this name in plant.endpoint, not an IP address; '
    + "otherwise, compare its TLS versions and ciphers with those of Node.js, and check the broker's log",
  noPublisher: (topic: string) => `no client publishes ${topic} on the broker yet; check that the bridge with direction: publish is running`,
  gatewayAway: "the bridge has lost the connection to the plant's gateway",
  bridgeAway: "the bridge at the plant's gateway is disconnected",
  bridgeSilent: (seconds: number) =>
    `the bridge at the plant's gateway has not confirmed its connection within ${seconds} s; check that it is running and has the version of this bridge`,
  noSignal: "the plant's gateway has no value of this signal, or it has not arrived; check its source; two brokers must exchange retained messages",
  atOtherGateway: (reason: string) => `at the plant's gateway: ${reason}`,
};

/** Error messages about a configuration of kind mqtt, and reasons for the refusal of values. */
export const mqttMessages = {
  nothingRead: 'no value is read; add joints, frames or signals',
  arrivalTime: 'the time of arrival',
  accepted: (topic: string) =>
    `the broker now accepts the subscription to ${topic}, but no value has arrived since; check that its publisher is running`,
  retained: 'only a retained message of unknown age has arrived; the value is used after the next message',
  empty: (topic: string) => `the message on ${topic} is empty, as when a retained message is deleted; publish a value`,
  notJson: (topic: string) => `the message on ${topic} is not valid JSON; publish an object, a list, a number, true or false`,
  sparkplug: (topic: string) =>
    `the message on ${topic} is not JSON: topics of Sparkplug B (spBv1.0/) have binary messages, which this adapter does not read; use a bridge that `
    + 'publishes JSON',
  noZone: (topic: string, field: string) =>
    `the time in the field ${field} of the message on ${topic} has no time zone; let the publisher add one, or set plant.time.zone to UTC or to an `
    + 'offset such as +01:00',
  zoneWithoutIso: 'not used with this unit, because a number needs no time zone; remove zone, or set unit: iso',
  noTime: (topic: string, unit: string, field: string) => `the message on ${topic} has no time with the unit ${unit} in the field ${field}`,
};

/** Reasons why a message is malformed. */
export const malformedMessages = {
  notObject: 'it is not a JSON object, or it is too long',
  noTransforms: 'it has no list of transforms',
  signal: 'its name, number or time stamp is missing',
  noStamp: 'it has no time stamp',
  noValues: 'it has no list of values',
  tooManyJoints: (count: number, most: number) => `it has ${count} joints; the maximum is ${most}`,
  entry: (text: string) => `its entry ${text} must have the name of a joint as key and STATE SINCE REASON as value`,
  noRobot: 'it has no <robot> element',
  trajectory: 'it has no joints, or one of its positions is not a number',
  forwardedTrajectory: 'it has no joint that is forwarded, or one of its positions is not a number',
  jointStates: 'its names and positions are not two lists of the same length',
};

/** Messages about the sync port of the plant's gateway. */
export const syncMessages = {
  timeUnknown: (place: string, reason: string) => `the time of ${place} cannot be read: ${reason}`,
  notYet: (place: string) => `the time of ${place} has not been read yet`,
  timeOf: (place: string) => `the time is read from ${place}`,
  closed: (place: string) => `${place} closed the connection`,
  tokenRefused: (place: string) => `${place} refuses the token; set plant.clock.token_file to a token of this gateway`,
  invalidReply: 'the sync port sent an invalid reply; check plant.clock',
  connectionClosed: 'the sync connection is closed',
  busy: 'another exchange is in progress',
  noAnswer: (seconds: number) => `the sync port did not respond within ${seconds} s`,
  notReachable: (place: string, reason: string) => `the sync port ${place} cannot be reached: ${reason}; check plant.clock`,
};

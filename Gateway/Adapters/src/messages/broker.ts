/** Errors in a configuration of the kind broker, and the parts of its summary. */
export const brokerSettingMessages = {
  publishing: (gateway: string, endpoint: string, topic: string) => `${gateway} to broker ${endpoint}, topics ${topic}/…`,
  subscribing: (endpoint: string, topic: string, gateway: string, place: string) =>
    `broker ${endpoint}, topics ${topic}/… to ${gateway}, time of ${place}`,
  unusedClock: 'not used with direction: publish; the bridge on the receiving side asks for the time',
  noClock: 'missing; add host and sync port of the gateway that has the plant, because the time stamps use its clock',
  tokenInClear: 'a token is sent only over TLS or within this machine; add the pin of the gateway that has the plant, or tls: true',
};

/** Texts about the connection to a broker, and about the gateway on its other side. */
export const brokerMessages = {
  notSecure: 'this broker is neither encrypted nor authenticated (plain: true): anyone with access to its network can imitate the plant',
  closed: 'the broker closed the connection',
  subscriptionRefused: (topic: string, reason: string) => `the broker refuses the subscription of ${topic}: ${reason}`,
  refuses: (endpoint: string) => `nothing listens at ${endpoint}; check that the broker runs`,
  loginRefused: (endpoint: string) => `${endpoint} refuses the login; check user and password_file, and the user's rights at the broker`,
  notTrusted: (code: string) => `the broker's certificate is not trusted (${code}); set authority_file to the certificate that issued it`,
  noPublisher: (topic: string) => `no client publishes ${topic} at the broker yet`,
  gatewayAway: 'the bridge has lost the gateway that has the plant',
  bridgeAway: 'the bridge of the gateway that has the plant is disconnected',
  atOtherGateway: (reason: string) => `at the gateway that has the plant: ${reason}`,
};

/** Errors in a configuration of the kind mqtt, and reasons for the refusal of values. */
export const mqttMessages = {
  nothingRead: 'no topic is read; add joints, frames or signals',
  arrivalTime: 'the time of the arrival',
  retained: 'only a retained message of unknown age has arrived; it is shown after the next message',
  notJson: (topic: string) => `the message on ${topic} is neither JSON nor a number nor true or false`,
  noTime: (topic: string, unit: string, field: string) => `the message on ${topic} has no time in ${unit} in the field ${field}`,
};

/** Reasons why a message is malformed. */
export const malformedMessages = {
  notObject: 'it is not a JSON object, or longer than allowed',
  noTransforms: 'it has no list of transforms',
  signal: 'it has no name, number or stamp',
  noStamp: 'it has no time stamp',
  noValues: 'it has no list of values',
  tooManyJoints: (count: number, most: number) => `it has ${count} joints; up to ${most} are allowed`,
  entry: (text: string) => `the entry ${text} is not a joint's name with STATE SINCE REASON`,
  noRobot: 'it has no <robot> element',
  trajectory: 'it has no joints, or a value is not a number',
  forwardedTrajectory: 'it has no forwarded joint, or a value is not a number',
  jointStates: 'names and positions are not lists of the same length',
  transform: (source: string) => `its transform from ${source} has no parent, or no finite position, or no unit quaternion`,
};

/** Texts about the sync port of the gateway that has the plant. */
export const syncMessages = {
  timeUnknown: (place: string, reason: string) => `the time of ${place} is unknown: ${reason}`,
  timeOf: (place: string) => `the time is that of ${place}`,
  closed: (place: string) => `${place} closed the connection`,
  tokenRefused: (place: string) => `${place} refuses the token; give the bridge a token of that gateway`,
  invalidReply: 'its sync port sent an invalid reply',
  connectionClosed: 'the sync connection is closed',
  busy: 'an exchange is under way',
  noAnswer: (seconds: number) => `its sync port did not answer within ${seconds} s`,
  notReachable: (place: string, reason: string) => `the sync port of ${place} cannot be reached: ${reason}`,
};

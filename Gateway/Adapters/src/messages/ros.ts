import { wrongValue } from './configuration';

/** Texts about a robot with rosbridge. */
export const rosMessages = {
  notSecure: 'this rosbridge is neither encrypted nor authenticated (plain: true): anyone with access to its network can imitate the robot',
  clockAvailable: "the robot's clock is available",
  noClock: (reason: string) => `the robot's clock is not available: ${reason}; start rosapi beside rosbridge, or set clock: false`,
  noTime: (service: string) => `${service} returns no time; with use_sim_time, start the simulation`,
  noTransforms: 'the message has no list of transforms',
  sourceAndTopic: 'the topic is of this joint only; remove source or topic',
  twoTypes: (value: unknown, line: number, type: string, topic: string) =>
    wrongValue(value, `line ${line} has ${type} for ${topic}; a topic has one type`),
  sourceTwice: (source: string) => `the robot's joint ${source} occurs twice; name each joint once`,
};

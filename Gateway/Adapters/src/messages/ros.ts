import { shown } from '../configuration/problem';
import { wrongValue } from './configuration';

/** Messages about a robot that is connected over rosbridge. */
export const rosMessages = {
  notSecure:
    'the connection to rosbridge is neither encrypted nor authenticated (plain: true): anyone with access to its network can impersonate the robot, '
    + 'and can command it, because rosbridge lets each client publish and call services; restrict rosbridge as the manual describes',
  noClock: (reason: string) => `the robot's clock is not available, so headsets may use another clock than the time stamps: ${reason}`,
  /** @param reason The reason why a call of rosapi failed. */
  callFailed: (reason: string) => {
    // A fault of rosbridge_suite before May 2026 (PR 1255): a call can destroy an object that is still used, and all later calls fail.
    if (reason.includes("'capsule'")) return `${reason}; restart rosbridge, and update rosbridge_suite`;
    return /does not exist|did not respond/.test(reason) ? `${reason}; start rosapi, or set plant.clock: false` : reason;
  },
  noTime: (service: string) => `${service} returns no time; if the robot uses use_sim_time, start the simulation`,
  noDescription: (topic: string) =>
    `no robot description has arrived on ${topic}; set robot to a URDF file, or start its publisher (in ROS 1 the description is a parameter); if `
    + 'the headsets have their own, set plant.topics.robot_description: false',
  /** @param root Name of the robot's root link in the cell. */
  baseNotListed: (source: string, parent: string, root: string) =>
    `ROS publishes the pose of the robot's base ${source} in ${parent}, but frames does not list it, so headsets draw the robot at the origin of the `
    + `cell; add { frame: ${root}, source: ${source} } to frames`,
  simulationTime: (topics: string[]) =>
    `messages on ${topics.join(', ')} have the time since the start of a simulation, but the clock of their stamps is in real time, so these `
    + 'messages are refused: the rosapi of ROS 2 returns the system time even with use_sim_time; '
    + 'start the nodes that publish them with use_sim_time: false',
  /** @param sources Names of the frames in ROS. */
  noPose: (sources: string[], isRos1: boolean) => {
    const text = `no pose of ${sources.join(', ')} has arrived on the topics tf and tf_static; correct source, or start the publisher`;
    const latched =
      'if another program uses the same rosbridge, start a second one for this adapter, because it gets only one of several latched messages';
    return isRos1 ? text : `${text}; ${latched}`;
  },
  noTransforms: 'the message has no list of transforms',
  noParent: (source: string) => `the pose from ${source} has no parent; let its publisher set header.frame_id`,
  notFinite: (field: string, source: string, value: unknown) =>
    `${field} of the pose from ${source} is ${shown(value ?? null)}; allowed: a finite number`,
  sourceAndTopic: 'source and topic are both set, but a joint with its own topic has no source; remove one of the two',
  sourceAndPosition:
    'source and position are both set, but source is the name of a frame whose whole pose arrives in one message; remove one of the two',
  noTopic: 'missing, but the pose has a field; add the topic and the type of the messages with this field',
  twoTypes: (value: unknown, line: number, type: string, topic: string) =>
    wrongValue(value, `line ${line} has the type ${type} for ${topic}; use the same type on both lines`),
  sourceTwice: (source: string) => `the robot's joint ${source} occurs twice; list each joint once`,
};

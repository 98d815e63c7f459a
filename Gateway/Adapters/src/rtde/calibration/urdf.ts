import type { DhJoint } from './primary';
import { aboutX, aboutZ, cross, dot, inverse, ofRpy, ORIGIN, plus, type Rigid, rpyOf, shift, times, type Vector } from './rigid';
import { calibrationMessages } from '../../messages/rtde';

/** The joints in the included descriptions of UR's arms, from the base to the flange. The last joint is fixed. */
const CHAIN = ['shoulder_pan_joint', 'shoulder_lift_joint', 'elbow_joint', 'wrist_1_joint', 'wrist_2_joint', 'wrist_3_joint', 'tool0_joint'];

/** Maximum difference at the tool in m that a calibration can cause. A larger difference means that the kinematics belong to another robot. */
const MAX_DIFFERENCE = 0.03;

const originOf = (joint: string): RegExp => new RegExp(`(<joint name="${joint}"[^]*?<origin) xyz="([^"]*)" rpy="([^"]*)"`);

/**
 * Replaces the kinematics in the description of a UR arm with the calibrated kinematics of one arm.
 * @returns The new description, and the maximum difference at the tool in m over several joint positions.
 * @throws Error The kinematics do not belong to the described robot.
 */
export function calibrated(urdf: string, joints: DhJoint[]): { urdf: string; difference: number } {
  const nominal = CHAIN.map(joint => poseIn(urdf, joint));
  const own = chainOf(joints, nominal);
  const difference = Math.max(...POSITIONS.map(angles => distance(toolOf(nominal, angles), toolOf(own, angles))));
  // Uses !(… <= …) instead of >, so that NaN, which the network may deliver, is also rejected.
  if (!(difference <= MAX_DIFFERENCE)) throw new Error(calibrationMessages.otherRobot(1000 * difference));
  const text = CHAIN.reduce((before, joint, i) => {
    const numbers = (vector: Vector): string => vector.map(value => value.toFixed(12)).join(' ');
    return before.replace(originOf(joint), (_, start: string) => `${start} xyz="${numbers(own[i].at)}" rpy="${numbers(rpyOf(own[i]))}"`);
  }, urdf);
  return { urdf: text, difference };
}

function poseIn(urdf: string, joint: string): Rigid {
  const [, , xyz, rpy] = originOf(joint).exec(urdf)!;
  const vector = (text: string): Vector => text.split(' ').map(Number) as unknown as Vector;
  return { ...ofRpy(vector(rpy)), at: vector(xyz) };
}

/**
 * Gets the pose of each joint relative to the previous joint, and of the flange relative to the last joint. The origin of a joint is the point on its
 * calibrated axis that is nearest to its nominal origin, so that links are drawn at their actual places. With Denavit-Hartenberg parameters alone,
 * the origins of nearly parallel axes may be metres away.
 */
function chainOf(joints: DhJoint[], nominal: Rigid[]): Rigid[] {
  let axis = ORIGIN;
  let described = ORIGIN;
  let before = ORIGIN;
  const chain = joints.map(({ theta, a, d, alpha }, i) => {
    described = times(described, nominal[i]);
    const frame = onAxis(described, axis);
    const pose = times(inverse(before), frame);
    before = frame;
    axis = times(times(times(axis, aboutZ(theta)), shift([a, 0, d])), aboutX(alpha));
    return pose;
  });
  return [...chain, times(inverse(before), axis)];
}

/** Applies the smallest displacement that puts a frame's z axis on the z axis of another frame. */
function onAxis(frame: Rigid, { z, at }: Rigid): Rigid {
  const along = dot(plus(frame.at, at, -1), z);
  // Rotates about the normal n of both axes: v + n × v + n × (n × v) / (1 + cos).
  const normal = cross(frame.z, z);
  const scale = 1 / (1 + dot(frame.z, z));
  const turn = (v: Vector): Vector => plus(plus(v, cross(normal, v)), cross(normal, cross(normal, v)), scale);
  return { x: turn(frame.x), y: turn(frame.y), z, at: plus(at, z, along) };
}

/** Joint positions for the comparison, rad. */
const POSITIONS = Array.from({ length: 32 }, (_, i) => Array.from({ length: 6 }, (__, joint) => ((joint + 1) * (i + 0.5) * 0.61803) % (2 * Math.PI)));

const toolOf = (chain: Rigid[], angles: number[]): Vector =>
  chain.reduce((pose, next, i) => times(times(pose, next), i < angles.length ? aboutZ(angles[i]) : ORIGIN), ORIGIN).at;

function distance(a: Vector, b: Vector): number {
  const apart = plus(a, b, -1);
  return Math.sqrt(dot(apart, apart));
}

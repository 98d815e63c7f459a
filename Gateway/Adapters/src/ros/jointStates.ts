import type { PlantClock } from '../clock/plantClock';
import { shown } from '../configuration/problem';
import { JOINT_STATES, jointState, topicOf } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';
import { decelerationFloor, EndOfData } from '../samples/endOfData';
import type { Silence } from '../samples/silence';
import { StampRule } from '../samples/stampRule';
import { type Nanoseconds, ofRosTime } from '../times';
import type { JointNames, OutJoint } from './jointNames';
import { malformedMessages } from '../messages/broker';
import { refusalMessages, silenceMessages } from '../messages/values';

const MAX_JOINTS = 256;

interface Publisher {
  publish(topic: string, msg: object): void;
}

interface RosJointState {
  header?: { stamp?: unknown };
  name?: unknown[];
  position?: unknown[];
  velocity?: unknown[];
  /** Not in ROS: sent by our own gateway. */
  acceleration?: unknown[];
}

/** Forwards a robot's joint states with their own stamps, for each joint with a valid position. */
export class JointStates {
  readonly #rule: StampRule;
  /** End-of-data detection by joint; at most as many as there are names. */
  readonly #ends = new Map<string, EndOfData>();
  /** Joints whose end of data was judged since their last sample. Joints that start to move later are not evidence. */
  readonly #judged = new Set<string>();

  constructor(
    readonly names: JointNames,
    oldest: Nanoseconds,
    readonly clock: Pick<PlantClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    readonly silence: Silence,
  ) {
    // A joint whose publisher is silent cannot be confirmed.
    silence.unconfirmedMs = null;
    const others = silence.endOf;
    silence.endOf = joint => others(joint) ?? (this.#hasEnded(joint) ? silenceMessages.ended : null);
    this.#rule = new StampRule(MAX_JOINTS, oldest);
  }

  pass(message: RosJointState | null): void {
    const { name, position, velocity, acceleration } = message ?? {};
    if (!Array.isArray(name) || !Array.isArray(position) || position.length !== name.length) {
      // Joints with only efforts or velocities are published with empty positions.
      if (!Array.isArray(position) || position.length > 0) this.status.refuse('malformed', 'joint states', malformedMessages.jointStates);
      return;
    }
    if (!this.clock.isSettled) return this.status.count('clock-unknown');
    const stamp = ofRosTime(message!.header?.stamp);
    const now = this.clock.now;
    const taken = name.flatMap((source, i) => {
      const out = this.names.find(source);
      return out !== undefined && this.#isUsable(out, position[i], stamp, now) ? [{ out, i }] : [];
    });
    if (taken.length === 0) return;
    this.status.sampled();
    const state = jointState(
      stamp!,
      taken.map(t => t.out.name),
      taken.map(({ out, i }) => (position[i] as number) * out.scale + out.offset),
    );
    const accelerations = derivativesOf(acceleration, name.length, taken);
    this.gateway.publish(topicOf(this.names.namespace, JOINT_STATES), {
      ...state,
      velocity: derivativesOf(velocity, name.length, taken),
      ...(accelerations.length === 0 ? {} : { acceleration: accelerations }),
    });
  }

  #isUsable({ index, joint, scale, offset, isLinear }: OutJoint, position: unknown, stamp: Nanoseconds | null, now: Nanoseconds | null): boolean {
    this.status.joints.expect(joint);
    // A NaN arrives as null.
    if (typeof position !== 'number' || !Number.isFinite(position * scale + offset)) {
      this.status.refuse('not-finite', joint, refusalMessages.notPosition(shown(position)));
      return false;
    }
    const refusal = this.#rule.judge(index, stamp, now);
    if (refusal !== null) {
      this.status.refuse(refusal.reason, joint, refusal.text);
    } else {
      this.status.accept(joint);
      this.silence.heard(joint);
      let end = this.#ends.get(joint);
      if (end === undefined) this.#ends.set(joint, (end = new EndOfData(decelerationFloor(isLinear))));
      end.add(stamp!, position * scale + offset);
      this.#judged.delete(joint);
    }
    return refusal === null;
  }

  #hasEnded(joint: string): boolean {
    if (this.#judged.has(joint)) return false;
    this.#judged.add(joint);
    const end = this.#ends.get(joint);
    const newest = end?.newest ?? null;
    const areOthersMoving = newest !== null && [...this.#ends.values()].some(other => other !== end && other.goesOnAfter(newest));
    return end !== undefined && end.verdict(0, areOthersMoving) !== null;
  }
}

/** Gets the values of the forwarded joints; null where the robot sent none, and an empty list if it sent none at all. */
function derivativesOf(values: unknown[] | undefined, length: number, taken: { out: OutJoint; i: number }[]): (number | null)[] {
  if (!Array.isArray(values) || values.length !== length) return [];
  return taken.map(({ out, i }) => {
    const value = typeof values[i] === 'number' ? (values[i] as number) * out.scale : NaN;
    return Number.isFinite(value) ? value : null;
  });
}

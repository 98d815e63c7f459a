import type { OfferedClock } from '../clock/offeredClock';
import { shown } from '../configuration/problem';
import type { Publisher } from '../gateway/link';
import { JOINT_STATES, jointState, topicOf } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';
import { type EndOfData, endOfJoint } from '../samples/endOfData';
import type { SampleSilence } from '../samples/sampleSilence';
import { StampRule } from '../samples/stampRule';
import { type Nanoseconds, NS_PER_S, ofRosTime } from '../times';
import { type JointNames, MAX_JOINTS, type OutJoint } from './jointNames';
import { malformedMessages } from '../messages/broker';
import { refusalMessages, silenceMessages } from '../messages/values';

interface RosJointState {
  header?: { stamp?: unknown };
  name?: unknown[];
  position?: unknown[];
  velocity?: unknown[];
  /** Accelerations, which only our own gateway sends. */
  acceleration?: unknown[];
}

/** Age up to which a second copy of the newest sample is normal. An older copy means that the clock of the stamps has stopped. */
const COPY: Nanoseconds = NS_PER_S;

interface JointState {
  rule: StampRule;
  /** Position of the newest sample as it arrived. */
  position: number;
  end: EndOfData;
  /** Whether the end of the data was already judged since the last sample. Later motions of other joints are not evidence. */
  isJudged: boolean;
}

/** Forwards joint states with their own stamps. Omits joints without a valid position, and those whose name occurs twice. */
export class JointStates {
  /** The joints of which a position has arrived. `names` limits their number. */
  readonly #joints = new Map<string, JointState>();

  /**
   * @param mayRest For a source that sends the newest sample of a joint at rest again, whether a joint may rest, so that its newest sample may be old; null
   * for another source.
   */
  constructor(
    readonly names: JointNames,
    readonly oldest: Nanoseconds,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    readonly silence: SampleSilence,
    readonly mayRest: ((joint: string) => boolean) | null = null,
  ) {
    // ROS does not confirm the position of a joint whose publisher is silent.
    silence.unconfirmedMs = null;
    const others = silence.endOf;
    silence.endOf = (joint, silentMs) => others(joint, silentMs) ?? (this.#hasEnded(joint, silentMs) ? silenceMessages.ended : null);
  }

  pass(message: RosJointState | null): void {
    const { name, position, velocity, acceleration } = message ?? {};
    if (!Array.isArray(name) || !Array.isArray(position) || position.length !== name.length) {
      // Ignores messages with empty positions, which contain only efforts or velocities.
      if (!Array.isArray(position) || position.length > 0) this.status.refuse('malformed', 'joint states', malformedMessages.jointStates);
      return;
    }
    if (!this.clock.isSettled) return this.status.count('clock-unknown');
    const stamp = ofRosTime(message!.header?.stamp);
    const now = this.clock.now;
    const areUnique = new Set(name).size === name.length;
    const taken = name.flatMap((source, i) => {
      const out = this.names.find(source);
      if (out === undefined && this.names.isFull) this.status.tooMany('joints', MAX_JOINTS);
      if (out !== undefined && !areUnique && name.indexOf(source) !== name.lastIndexOf(source)) {
        // The two positions may contradict each other.
        this.status.joints.expect(out.joint);
        this.status.refuse('name-twice', out.joint, refusalMessages.nameTwice(out.name));
        return [];
      }
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

  #isUsable(out: OutJoint, position: unknown, stamp: Nanoseconds | null, now: Nanoseconds | null): boolean {
    const { joint, scale, offset, isLinear, maxDeceleration } = out;
    this.status.joints.expect(joint);
    if (typeof position !== 'number' || !Number.isFinite(position * scale + offset)) {
      // rosbridge sends NaN as null. joint_state_broadcaster publishes NaN for a joint without a position.
      this.status.refuse('not-finite', joint, position === null ? refusalMessages.noPosition : refusalMessages.notPosition(shown(position)));
      return false;
    }
    let state = this.#joints.get(joint);
    if (state === undefined) {
      state = { rule: new StampRule(this.oldest), position, end: endOfJoint(isLinear, maxDeceleration), isJudged: false };
      this.#joints.set(joint, state);
    }
    if (state.rule.isNewest(stamp)) {
      if (this.mayRest !== null) return false;
      // Several nodes may publish the same sample, for example a broadcaster and a node that merges joint states.
      if (position === state.position && now !== null && now - stamp! <= COPY) {
        this.status.count('stamp-repeated');
        return false;
      }
    }
    const refusal = state.rule.judge(stamp, now, this.mayRest?.(joint) ?? false);
    if (refusal !== null) {
      this.status.refuse(refusal.reason, joint, refusal.text);
      return false;
    }
    this.status.accept(joint);
    this.silence.heard(joint);
    state.end.add(stamp!, position * scale + offset);
    state.isJudged = false;
    state.position = position;
    return true;
  }

  #hasEnded(joint: string, silentMs: number): boolean {
    const state = this.#joints.get(joint);
    if (state === undefined || silentMs < state.end.overdueMs || state.isJudged) return false;
    state.isJudged = true;
    const { newest } = state.end;
    const areOthersMoving = newest !== null && [...this.#joints.values()].some(({ end }) => end.goesOnAfter(newest));
    return state.end.verdict(0, areOthersMoving) !== null;
  }
}

/** Gets the velocities or accelerations of the forwarded joints; null for a joint without one. Empty if the robot sent none. */
function derivativesOf(values: unknown[] | undefined, length: number, taken: { out: OutJoint; i: number }[]): (number | null)[] {
  if (!Array.isArray(values) || values.length !== length) return [];
  return taken.map(({ out, i }) => {
    const value = typeof values[i] === 'number' ? (values[i] as number) * out.scale : NaN;
    return Number.isFinite(value) ? value : null;
  });
}

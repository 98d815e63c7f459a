import type { PlantClock } from '../clock/plantClock';
import type { Joint } from '../configuration/configuration';
import { JOINT_STATES, jointState } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';
import { shown } from '../configuration/problem';
import type { Nanoseconds } from '../times';
import { grouped, type Sample } from './grouping';
import { StampRule } from './stampRule';
import { Standing } from './standing';

/** A value as the control system gave it. */
export interface JointValue {
  /** The joint's place in the configuration. */
  joint: number;
  value: unknown;
  /** Null: it came without one that could be read. */
  stamp: Nanoseconds | null;
  /** The first of a connection: it tells how things are, and its stamp may be of long ago. */
  isFirst?: boolean;
}

export interface JointOutputOptions {
  /** Stamps that are not further apart count as one moment. */
  tolerance: Nanoseconds;
  oldest: Nanoseconds;
}

/** What a value's stamp may be that was written before anybody listened. */
const OF_LONG_AGO = ['stamp-old', 'stamp-not-newer', 'stamp-missing'];

interface Publisher {
  publish(topic: string, msg: object): void;
}

/** Makes joint states of the values of a plant, and refuses what cannot be a position with its time. */
export class JointOutput {
  readonly #rule: StampRule;
  readonly #standing: Standing;

  constructor(
    readonly joints: Joint[], readonly options: JointOutputOptions,
    readonly clock: Pick<PlantClock, 'now' | 'isSettled'>, readonly gateway: Publisher, readonly status: AdapterStatus,
  ) {
    this.#rule = new StampRule(joints.length, options.oldest);
    this.#standing = new Standing(joints.length);
  }

  /** Passes on what arrived together; of one joint oldest first. */
  publish(values: JointValue[]): void {
    const { now, isSettled } = this.clock;
    const samples = values.map(value => this.#sample(value, now)).filter(sample => sample !== null);
    // What stands is told again when the clock is there.
    if (isSettled) this.#send(samples);
    else samples.forEach(() => this.status.count('clock-unknown'));
  }

  /**
   * Says again what stands, of a plant that tells changes alone.
   * @param time Up to which every change has been published here, on the control clock.
   * @param silence How seldom a joint that moves may be heard of.
   * @param except Joints of which something newer is known already.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, except: ReadonlySet<number> = new Set()): void {
    const { now, isSettled } = this.clock;
    if (!isSettled || now === null) return;
    const standing = this.#standing.at(time, silence).filter(({ joint }) => !except.has(joint) && this.#rule.judge(joint, time, now) === null);
    for (const sample of standing) this.#standing.heard(sample);
    this.#send(standing);
  }

  /** The connection is another: what stood then may have moved since. */
  startAnew(): void {
    for (let joint = 0; joint < this.joints.length; joint++) this.#standing.forget(joint);
  }

  /** Counts a value that its source itself calls unusable. */
  refuse(joint: number, reason: string, text: string): void {
    this.#standing.forget(joint);
    this.status.refuse(reason, this.joints[joint].joint, text);
  }

  #send(samples: Sample[]): void {
    for (const group of grouped(samples, this.options.tolerance)) {
      const names = group.samples.map(s => this.joints[s.joint].joint), positions = group.samples.map(s => s.position);
      this.gateway.publish(JOINT_STATES, jointState(group.stamp, names, positions));
      this.status.sampled();
    }
  }

  #sample({ joint, value, stamp, isFirst }: JointValue, now: Nanoseconds | null): Sample | null {
    const { scale, offset } = this.joints[joint];
    const raw = typeof value === 'bigint' ? Number(value) : value;
    if (typeof raw !== 'number') {
      this.refuse(joint, 'type', `value ${shown(value)} is no number; name a variable that is one`);
      return null;
    }
    const position = raw * scale + offset;
    if (!Number.isFinite(position)) {
      this.refuse(joint, 'not-finite', `value ${raw} is no position`);
      return null;
    }
    const refusal = this.#rule.judge(joint, stamp, now);
    if (refusal !== null && isFirst === true && now !== null && OF_LONG_AGO.includes(refusal.reason)) {
      // Shown when it turns out to stand: the next may bear such a stamp too, by another clock than the control clock.
      this.#standing.heard({ joint, position, stamp: now });
      return null;
    }
    if (refusal !== null) {
      this.refuse(joint, refusal.reason, refusal.text);
      return null;
    }
    const sample = { joint, position, stamp: stamp! };
    this.#standing.heard(sample);
    this.status.accept(this.joints[joint].joint);
    return sample;
  }
}

import type { OfferedClock } from '../clock/offeredClock';
import type { Joint } from '../configuration/configuration';
import type { Publisher } from '../gateway/link';
import { JOINT_STATES, jointState, topicOf } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';
import type { Nanoseconds } from '../times';
import { grouped, type Sample } from './grouping';
import { JointTrack, type SourceStop } from './jointTrack';
import type { PlantValue } from './plantOutput';
import { SampleSilence } from './sampleSilence';
import type { Refusal } from './stampRule';

export interface JointOutputOptions {
  /** Maximum difference between stamps that belong to the same sample. */
  tolerance: Nanoseconds;
  oldest: Nanoseconds;
  /**
   * Time without data in ms after which a joint without its own setting has a fault; absent or null if a silent joint counts as at rest.
   */
  faultAfterMs?: number | null;
}

/** Publishes joint states from a plant's values. Refuses values that are not a valid position with a valid stamp. */
export class JointOutput {
  readonly #tracks: JointTrack[];
  /** Sampling interval of the source in seconds; 0 if unknown. */
  samplingS = 0;
  readonly silence: SampleSilence;
  /** Gets the phase in which the source stopped writing a joint's value; null if it has not stopped, or if this is unknown. */
  sourceStopOf: (joint: number) => SourceStop | null = () => null;

  /** @param counter Monotonic clock in ms; by default, the clock of this machine. */
  constructor(
    joints: Joint[],
    readonly options: JointOutputOptions,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    counter?: () => number,
  ) {
    this.#tracks = joints.map((joint, index) => new JointTrack(index, joint, this, options.oldest));
    const byName = new Map(this.#tracks.map(track => [track.joint.joint, track]));
    const limitOf = (joint: Joint | undefined): number | null => (joint ?? options).faultAfterMs ?? null;
    this.silence = new SampleSilence(status, name => limitOf(byName.get(name)?.joint), counter);
    this.silence.endOf = (name, silentMs) => byName.get(name)?.endOf(silentMs, clock.now) ?? null;
  }

  /** Publishes values that arrived together. Their indices are those of the joints. Several values of one joint are sorted, the oldest first. */
  publish(values: PlantValue[]): void {
    const { now, isSettled } = this.clock;
    const samples = values.flatMap(value => this.#tracks[value.index].sampleOf(value, now) ?? []);
    // Drops samples until the clock is known. Values at rest are repeated later.
    if (isSettled) this.#send(samples);
    else samples.forEach(() => this.status.count('clock-unknown'));
  }

  /**
   * Repeats the samples of joints at rest, for a plant that sends only changes.
   * @param time Control time up to which all changes have been passed to `publish`.
   * @param silence Maximum interval between the samples of a moving joint.
   * @param except Joints that have a newer value, or that may have changed.
   */
  hold(time: Nanoseconds, silence: Nanoseconds, except: ReadonlySet<number> = new Set()): void {
    const { now, isSettled } = this.clock;
    if (!isSettled || now === null) return;
    this.#send(this.#tracks.flatMap(track => (except.has(track.index) ? [] : (track.hold(time, silence, now) ?? []))));
  }

  /** Updates the state of joints that have been silent for too long. Samples of joints with a fault are no longer repeated. */
  checkSilence(): void {
    const faults = new Set(this.silence.check());
    for (const track of this.#tracks) if (faults.has(track.joint.joint)) track.storeEnd();
  }

  isAnyMovingAfter(stamp: Nanoseconds): boolean {
    return this.#tracks.some(track => track.goesOnAfter(stamp));
  }

  /** Whether the joint's data ended during a motion. */
  hasEnded(joint: number): boolean {
    return this.#tracks[joint].hasEnded;
  }

  /** Reports that the control system no longer has the variable of this joint. */
  lose(joint: number, refusal: Refusal): void {
    this.#tracks[joint].lose(refusal);
  }

  /** Reports the reason why a joint is not published yet although its value has arrived. */
  explain(joint: number, reason: Refusal): void {
    this.#tracks[joint].explain(reason);
  }

  /** Prepares for a new connection. */
  restart(): void {
    for (const track of this.#tracks) track.restart();
  }

  /** Discards the stamps of the previous control clock. */
  clockStepped(): void {
    const { now } = this.clock;
    for (const track of this.#tracks)
      if (now === null) track.restart();
      else track.clockStepped(now);
  }

  /** Counts an unusable value. */
  refuse(joint: number, refusal: Refusal): void {
    this.#tracks[joint].refuse(refusal);
  }

  #send(samples: Sample[]): void {
    for (const { stamp, samples: group } of grouped(samples, this.options.tolerance))
      for (const robot of new Set(group.map(({ index }) => this.#tracks[index].joint.robot))) {
        const own = group.filter(({ index }) => this.#tracks[index].joint.robot === robot);
        const names = own.map(({ index }) => this.#tracks[index].joint.name);
        const positions = own.map(({ value }) => value);
        const velocities = own.flatMap(({ velocity }) => velocity ?? []);
        this.gateway.publish(topicOf(robot, JOINT_STATES), jointState(stamp, names, positions, velocities.length === names.length ? velocities : []));
        this.status.sampled();
      }
  }
}

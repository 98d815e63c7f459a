import type { Nanoseconds } from '../times';
import type { Sample } from './grouping';

/**
 * Stores the last sample of each joint of a control system that sends only changes. If all changes up to a time are known and a joint has sent none,
 * the joint still had its last value at that time. The last value and that time then form a valid sample.
 */
export class RestingSamples {
  readonly #newest: (Sample | null)[];

  constructor(joints: number) {
    this.#newest = Array<Sample | null>(joints).fill(null);
  }

  heard(sample: Sample): void {
    this.#newest[sample.joint] = sample;
  }

  /** Removes a joint's sample, because a later value was refused or the joint has a fault. Returns its position, or null without a sample. */
  forget(joint: number): number | null {
    const position = this.#newest[joint]?.position ?? null;
    this.#newest[joint] = null;
    return position;
  }

  /**
   * Gets samples for all joints at rest, at a control time up to which all changes are known.
   * @param silence Gets the minimum time without changes after which a joint counts as at rest.
   */
  at(time: Nanoseconds, silence: (joint: number) => Nanoseconds): Sample[] {
    return this.#newest
      .filter(sample => sample !== null)
      .flatMap(sample => (time - sample.stamp >= silence(sample.joint) ? [{ ...sample, stamp: time }] : []));
  }
}

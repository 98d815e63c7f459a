import type { Nanoseconds } from '../times';
import type { Sample } from './grouping';

/**
 * The last value of each joint. For a control system that sends only changes, silence means that a joint is at rest: at a time up to which
 * all changes are known, the joint still had its last value. That is a valid sample.
 */
export class Standing {
  readonly #newest: (Sample | null)[];

  constructor(joints: number) {
    this.#newest = Array<Sample | null>(joints).fill(null);
  }

  heard(sample: Sample): void {
    this.#newest[sample.joint] = sample;
  }

  /** Removes a joint's value, because a later value was refused. */
  forget(joint: number): void {
    this.#newest[joint] = null;
  }

  /**
   * Gets the samples of all joints at rest at a time of the control system up to which all changes are known.
   * @param silence Minimum silence of a joint at rest.
   */
  at(time: Nanoseconds, silence: (joint: number) => Nanoseconds): Sample[] {
    return this.#newest
      .filter(sample => sample !== null)
      .flatMap(sample => (time - sample.stamp >= silence(sample.joint) ? [{ ...sample, stamp: time }] : []));
  }
}

import type { Nanoseconds } from '../times';
import type { Sample } from './grouping';

/**
 * The last sample of each joint. If a control system sends only changes, a silent joint is at rest. At a time up to which all changes are known, the
 * joint still had its last value, which gives a valid sample at that time.
 */
export class Standing {
  readonly #newest: (Sample | null)[];

  constructor(joints: number) {
    this.#newest = Array<Sample | null>(joints).fill(null);
  }

  heard(sample: Sample): void {
    this.#newest[sample.joint] = sample;
  }

  /** Removes a joint's sample, because a later value was refused or the joint has a fault. */
  forget(joint: number): void {
    this.#newest[joint] = null;
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

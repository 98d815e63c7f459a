import type { Nanoseconds } from '../times';
import type { Sample } from './grouping';

/**
 * What each joint showed last. A control system that tells changes alone says by its silence that a joint stands: at a moment of which all
 * changes have been told, the joint still had that value, and that is a sample as true as the one that told it.
 */
export class Standing {
  readonly #newest: (Sample | null)[];

  constructor(joints: number) {
    this.#newest = Array<Sample | null>(joints).fill(null);
  }

  heard(sample: Sample): void {
    this.#newest[sample.joint] = sample;
  }

  /** Nothing is known of it any more: its value was refused. */
  forget(joint: number): void {
    this.#newest[joint] = null;
  }

  /**
   * The samples of all that stood at a time of the control system up to which all changes are known.
   * @param silence How long nothing has come of a joint that stands.
   */
  at(time: Nanoseconds, silence: (joint: number) => Nanoseconds): Sample[] {
    return this.#newest.filter(sample => sample !== null)
      .flatMap(sample => time - sample.stamp >= silence(sample.joint) ? [{ ...sample, stamp: time }] : []);
  }
}

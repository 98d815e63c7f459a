import { type Nanoseconds, NS_PER_MS } from '../times';
import type { Sample } from './grouping';

/** A joint that moves is heard of more often, and a headset predicts from samples that are not older than some 300 ms. */
const SILENCE: Nanoseconds = 100n * NS_PER_MS;

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
   * @param silence How long nothing came of a joint that stands, where joints that move are heard of that seldom.
   */
  at(time: Nanoseconds, silence: Nanoseconds): Sample[] {
    const least = silence > SILENCE ? silence : SILENCE;
    return this.#newest.filter(sample => sample !== null).flatMap(sample => time - sample.stamp >= least ? [{ ...sample, stamp: time }] : []);
  }
}

import type { Nanoseconds } from '../times';

interface Reading {
  value: number;
  stamp: Nanoseconds;
}

/**
 * One number of a pose, with its two newest values. Servers sample variables one by one, so the components of a pose may have different
 * stamps. Components with newer stamps are then interpolated to the stamp of the oldest component.
 */
export class ComponentTrack {
  #newest: Reading | null = null;
  #previous: Reading | null = null;
  /** A value with an unknown time. It is valid until a newer value arrives. */
  #resting: number | null = null;

  get value(): number | null {
    return this.#newest?.value ?? this.#resting;
  }

  /** Stamp of the newest value; null if its time is unknown, or before the first. */
  get stamp(): Nanoseconds | null {
    return this.#newest?.stamp ?? null;
  }

  add(value: number, stamp: Nanoseconds): void {
    if (this.#newest !== null && stamp < this.#newest.stamp) return;
    [this.#previous, this.#newest] = [this.#newest, { value, stamp }];
  }

  /**
   * Sets a value that the component has had since an unknown time: since before the connection was made, or since a change whose notification was
   * lost.
   */
  rest(value: number): void {
    this.forget();
    this.#resting = value;
  }

  /** Forgets the value before the newest one, which is a coordinate in another parent. */
  settle(): void {
    this.#previous = null;
  }

  forget(): void {
    this.#newest = this.#previous = this.#resting = null;
  }

  /**
   * Gets the time up to which the component is known, given that another component is known up to `time`. A component at rest is also known
   * up to `time`. A component that changed recently is known up to its newest stamp only, because it is expected to change again.
   * @param patience Maximum interval between the values of a moving component.
   */
  knownUntil(time: Nanoseconds, patience: Nanoseconds): Nanoseconds {
    if (this.#newest === null || this.#previous === null || this.#newest.stamp >= time) return time;
    const isMoving = this.#newest.stamp - this.#previous.stamp <= patience && time - this.#newest.stamp <= patience;
    return isMoving ? this.#newest.stamp : time;
  }

  /**
   * Gets the interpolated value at a given time; null before the first value.
   * @param jump Maximum difference of two values that is interpolated. A larger difference is a jump, for example of an angle at a full turn.
   */
  at(time: Nanoseconds, jump: number): number | null {
    const [from, to] = [this.#previous, this.#newest];
    if (to === null || from === null || to.stamp <= time) return this.value;
    const share = Number(time - from.stamp) / Number(to.stamp - from.stamp);
    if (share <= 0) return from.value;
    if (Math.abs(to.value - from.value) > jump) return share < 0.5 ? from.value : to.value;
    return from.value + share * (to.value - from.value);
  }
}

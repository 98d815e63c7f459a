import type { AdapterStatus } from '../gateway/status';

/** A joint is called at rest after this time without a sample, so that slow motion does not change the state with each sample. */
const REST_MS = 1000;

/** Why rest is not certain where the source cannot be asked for the value of a joint that it does not send. */
const CURE = 'set silence: { fault_after_s: N } if the source sends each joint again and again, at rest too';
const UNCONFIRMED = `nothing confirms its last value, so an end of its data looks the same; ${CURE}`;
const ALL_UNCONFIRMED = `no joint of its source sends anything, so an end of the source looks the same; ${CURE}`;

interface Heard {
  /** Times of the last sample, and of the last confirmation that the joint still has that value. */
  sample: number;
  confirmed: number;
}

/** Watches how long nothing has come of each joint, and decides what that means. */
export class Silence {
  /** Limit for a joint that is silent and not confirmed by the source; null where the source cannot confirm. */
  unconfirmedMs: number | null = 1500;
  /** Whether the data of a joint ended while it moved; asked for a silent joint that the source cannot confirm. */
  hasEnded: (joint: string) => boolean = () => false;
  readonly #heard = new Map<string, Heard>();
  /** Joints whose state another gateway reports: their silence is not judged here. */
  readonly #reported = new Set<string>();

  /**
   * @param faultAfterMs Silence of a joint that is a fault; null: the joint is at rest.
   * @param now Milliseconds of a counter that never jumps.
   */
  constructor(
    readonly status: AdapterStatus, readonly faultAfterMs: (joint: string) => number | null, readonly now: () => number = () => performance.now(),
  ) {}

  /** A usable sample came. */
  heard(joint: string): void {
    this.arrived(joint);
    if (!this.#reported.has(joint)) this.status.joints.live(joint);
  }

  /** Another gateway reports the joint's state, until `judge` is called. */
  leave(joint: string): void {
    this.#reported.add(joint);
  }

  /** Nobody else reports the joint's state any more. Returns whether a sample of it has ever come. */
  judge(joint: string): boolean {
    const heard = this.#heard.get(joint);
    // One that was reported in fault stays so until its next sample.
    if (this.#reported.delete(joint) && heard !== undefined && this.now() - heard.sample < REST_MS) this.status.joints.live(joint);
    return heard !== undefined;
  }

  /** A value came that shows the joint only once it is confirmed. */
  arrived(joint: string): void {
    const now = this.now();
    this.#heard.set(joint, { sample: now, confirmed: now });
  }

  /**
   * The source has sent all changes up to now, and none of this joint: it still has its last value.
   * @param uncertainty Why it is not certain that the joint rests; empty for none.
   */
  confirm(joint: string, uncertainty = ''): void {
    const heard = this.#heard.get(joint);
    if (heard === undefined) return;
    heard.confirmed = this.now();
    if (this.status.joints.stateOf(joint) !== 'live' || heard.confirmed - heard.sample >= REST_MS) this.#rest(joint, heard, uncertainty);
  }

  /** Wall clock time of the last sample in milliseconds. */
  lastSample(joint: string): number {
    const heard = this.#heard.get(joint);
    return this.status.joints.now() - (heard === undefined ? 0 : this.now() - heard.sample);
  }

  /** Gives each joint that was silent for too long its state. Returns those that stay a fault until their next sample. */
  check(): string[] {
    if (this.status.state !== 'connected') return [];
    const areAllSilent = this.#heard.size > 1 && [...this.#heard.values()].every(({ sample }) => this.now() - sample >= REST_MS);
    return [...this.#heard].flatMap(([joint, heard]) => {
      const state = this.#reported.has(joint) ? undefined : this.status.joints.stateOf(joint);
      return state === 'live' || state === 'rest' ? this.#check(joint, heard, areAllSilent ? ALL_UNCONFIRMED : UNCONFIRMED) : [];
    });
  }

  #check(joint: string, heard: Heard, uncertainty: string): string[] {
    const silent = this.now() - heard.sample, limit = this.faultAfterMs(joint), unconfirmed = this.now() - heard.confirmed;
    if (limit !== null && silent > limit) {
      this.#fault(joint, `no new value for more than ${limit / 1000} s, which is a fault here (silence in plant.yaml)`);
      return [joint];
    }
    if (this.unconfirmedMs !== null && unconfirmed > this.unconfirmedMs)
      this.#fault(joint, `no value for more than ${this.unconfirmedMs / 1000} s, and the source does not confirm the last one`);
    else if (this.unconfirmedMs === null && silent >= REST_MS) {
      // Where a longer silence is a fault, the source is known to be silent for as long as this.
      if (limit !== null) this.#rest(joint, heard);
      else if (this.hasEnded(joint)) this.#fault(joint, 'its data ended in mid-motion: it cannot have stopped where it was last seen');
      else this.#rest(joint, heard, uncertainty);
    }
    return [];
  }

  #fault(joint: string, reason: string): void {
    this.status.joints.fault(joint, reason, this.lastSample(joint));
  }

  #rest(joint: string, heard: Heard, uncertainty = ''): void {
    const limit = this.faultAfterMs(joint);
    if (limit === null || this.now() - heard.sample <= limit) this.status.joints.rest(joint, this.lastSample(joint), uncertainty);
  }
}

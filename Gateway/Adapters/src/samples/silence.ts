import type { Conditions } from '../gateway/conditions';
import type { AdapterStatus } from '../gateway/status';
import { silenceMessages } from '../messages/values';

/** Time without a sample after which a joint is at rest. With a shorter time, slow motion would change the state with each sample. */
const REST_MS = 1000;

interface Heard {
  /** Times of the last sample, and of the last confirmation that the joint still has that value. */
  sample: number;
  confirmed: number;
}

/** Measures the silence of each joint and determines its meaning. */
export class Silence {
  /** Limit for a joint that is silent and not confirmed by the source; null if the source cannot confirm. */
  unconfirmedMs: number | null = 1500;
  /** Gets why the data of a joint ended while it moved, null if they did not; called for a silent joint that the source cannot confirm. */
  endOf: (joint: string) => string | null = () => null;
  readonly #heard = new Map<string, Heard>();
  /** Joints whose state another gateway reports; their silence is not evaluated here. */
  readonly #reported = new Set<string>();

  /**
   * @param faultAfterMs Time without data after which a joint has a fault, ms; null if the joint is at rest.
   * @param now Monotonic time in ms.
   * @param conditions The states to set: those of joints, frames or signals.
   */
  constructor(
    readonly status: AdapterStatus,
    readonly faultAfterMs: (joint: string) => number | null,
    readonly now: () => number = () => performance.now(),
    readonly conditions: Conditions = status.joints,
  ) {}

  /** Reports a valid sample. */
  heard(joint: string): void {
    this.arrived(joint);
    if (!this.#reported.has(joint)) this.conditions.live(joint);
  }

  /** Leaves the joint's state to another gateway's reports, until `judge` is called. */
  leave(joint: string): void {
    this.#reported.add(joint);
  }

  /** Resumes the evaluation of a joint's silence. Returns whether it has ever sent a sample. */
  judge(joint: string): boolean {
    const heard = this.#heard.get(joint);
    // A joint that was reported with a fault keeps it until its next sample.
    if (this.#reported.delete(joint) && heard !== undefined && this.now() - heard.sample < REST_MS) this.conditions.live(joint);
    return heard !== undefined;
  }

  /** Reports a value that is valid only once it is confirmed. */
  arrived(joint: string): void {
    const now = this.now();
    this.#heard.set(joint, { sample: now, confirmed: now });
  }

  /**
   * Confirms the joint's last value: the source has sent all changes up to now, and none of this joint.
   * @param uncertainty The reason why it is uncertain that the joint rests; empty for none.
   */
  confirm(joint: string, uncertainty = ''): void {
    const heard = this.#heard.get(joint);
    if (heard === undefined) return;
    heard.confirmed = this.now();
    if (this.conditions.stateOf(joint) !== 'live' || heard.confirmed - heard.sample >= REST_MS)
      this.#rest(joint, heard, silenceMessages.confirmed, uncertainty);
  }

  /** Wall clock time of the last sample in milliseconds. */
  lastSample(joint: string): number {
    const heard = this.#heard.get(joint);
    return this.conditions.now() - (heard === undefined ? 0 : this.now() - heard.sample);
  }

  /** Sets the state of each joint that was silent for too long. Returns those that have a fault until their next sample. */
  check(): string[] {
    if (this.status.state !== 'connected') return [];
    const areAllSilent = this.#heard.size > 1 && [...this.#heard.values()].every(({ sample }) => this.now() - sample >= REST_MS);
    return [...this.#heard].flatMap(([joint, heard]) => {
      const state = this.#reported.has(joint) ? undefined : this.conditions.stateOf(joint);
      return state === 'live' || state === 'rest'
        ? this.#check(joint, heard, areAllSilent ? silenceMessages.allUnconfirmed : silenceMessages.unconfirmed)
        : [];
    });
  }

  #check(joint: string, heard: Heard, uncertainty: string): string[] {
    const silent = this.now() - heard.sample;
    const limit = this.faultAfterMs(joint);
    const unconfirmed = this.now() - heard.confirmed;
    if (limit !== null && silent > limit) {
      this.#fault(joint, silenceMessages.tooLong(limit));
      return [joint];
    }
    if (this.unconfirmedMs !== null && unconfirmed > this.unconfirmedMs) this.#fault(joint, silenceMessages.notConfirmed(this.unconfirmedMs));
    else if (this.unconfirmedMs === null && silent >= REST_MS) {
      // With a limit for a fault, the source is known to be silent for up to that time.
      const end = limit === null ? this.endOf(joint) : null;
      if (end !== null) this.#fault(joint, end);
      else this.#rest(joint, heard, silenceMessages.noValue, limit === null ? uncertainty : '');
    }
    return [];
  }

  #fault(joint: string, reason: string): void {
    this.conditions.fault(joint, reason, this.lastSample(joint));
  }

  #rest(joint: string, heard: Heard, evidence: string, uncertainty = ''): void {
    const limit = this.faultAfterMs(joint);
    if (limit !== null && this.now() - heard.sample > limit) return;
    this.conditions.rest(joint, this.lastSample(joint), silenceMessages.basis(evidence, limit), uncertainty);
  }
}

import type { Conditions } from '../gateway/conditions';
import type { AdapterStatus } from '../gateway/status';
import { silenceMessages } from '../messages/values';
import type { Refusal } from './stampRule';

/** Time without a sample after which a joint counts as at rest. With a shorter time, a slow motion would change the state with each sample. */
const REST_MS = 1000;

/** The word for the reason of a joint whose data ended during a motion. */
export const ENDED_IN_MOTION = 'ended-in-motion';

interface Heard {
  /** Time of the last sample, and time of the last confirmation that the joint still has its value. */
  sample: number;
  confirmed: number;
}

/** Measures the time without samples for each joint, and sets the joint's state accordingly. Also used for frames and signals. */
export class SampleSilence {
  /** Time in ms without a confirmation after which a joint has a fault; null if the control system does not confirm values. */
  unconfirmedMs: number | null = 1500;
  /**
   * Gets the reason why a joint's data ended during a motion; null if they did not, or if this is not known yet. Called for a joint without samples,
   * with the time since its last sample, if the control system does not confirm values.
   */
  endOf: (joint: string, silentMs: number) => string | null = () => null;
  readonly #heard = new Map<string, Heard>();
  /** Joints whose state another gateway reports. Their silence is not evaluated. */
  readonly #reported = new Set<string>();

  /**
   * @param faultAfterMs Gets the time without data in ms after which a joint has a fault; null if a silent joint counts as at rest.
   * @param now Monotonic clock in ms.
   * @param conditions The states to set: the states of joints, frames or signals.
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

  /** Stops the evaluation of a joint's silence until `judge` is called, because another gateway reports its state. */
  leave(joint: string): void {
    this.#reported.add(joint);
  }

  /** Resumes the evaluation of a joint's silence. Returns whether the joint has ever sent a sample. */
  judge(joint: string): boolean {
    const heard = this.#heard.get(joint);
    // Only a joint with a recent sample becomes live. A joint that was reported with a fault keeps the fault until its next sample.
    if (this.#reported.delete(joint) && heard !== undefined && this.now() - heard.sample < REST_MS) this.conditions.live(joint);
    return heard !== undefined;
  }

  /** Stops the evaluation of a frame's silence until its next sample, because the frame is stationary. */
  forget(frame: string): void {
    this.#heard.delete(frame);
  }

  /** Reports a value that is used only after it has been confirmed. */
  arrived(joint: string): void {
    const now = this.now();
    this.#heard.set(joint, { sample: now, confirmed: now });
  }

  /**
   * Confirms a joint's last value: the source has sent all changes up to now, and this joint has not changed.
   * @param uncertainty The reason why the joint may not be at rest; an empty string if there is none.
   */
  confirm(joint: string, uncertainty = ''): void {
    const heard = this.#heard.get(joint);
    if (heard === undefined) return;
    heard.confirmed = this.now();
    if (this.conditions.stateOf(joint) !== 'live' || heard.confirmed - heard.sample >= REST_MS)
      this.#rest(joint, heard, silenceMessages.confirmed, uncertainty);
  }

  /** Gets the time of the last sample on the wall clock, in milliseconds. */
  lastSample(joint: string): number {
    const heard = this.#heard.get(joint);
    return this.conditions.now() - (heard === undefined ? 0 : this.now() - heard.sample);
  }

  /** Updates the state of joints that have been silent for too long. Returns the joints that have a fault until their next sample. */
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
      this.#fault(joint, { reason: 'silent-too-long', text: silenceMessages.tooLong(limit) });
      return [joint];
    }
    if (this.unconfirmedMs !== null && unconfirmed > this.unconfirmedMs) {
      this.#fault(joint, { reason: 'not-confirmed', text: silenceMessages.notConfirmed(this.unconfirmedMs) });
    } else if (this.unconfirmedMs === null && silent >= REST_MS) {
      // This check also applies before a configured limit, because a joint that moved in its last samples is not at rest.
      const end = this.endOf(joint, silent);
      if (end !== null) this.#fault(joint, { reason: ENDED_IN_MOTION, text: end });
      else this.#rest(joint, heard, silenceMessages.noValue, limit === null ? uncertainty : '');
    }
    return [];
  }

  #fault(joint: string, reason: Refusal): void {
    this.conditions.fault(joint, reason, this.lastSample(joint));
  }

  #rest(joint: string, heard: Heard, evidence: string, uncertainty = ''): void {
    const limit = this.faultAfterMs(joint);
    if (limit !== null && this.now() - heard.sample > limit) return;
    this.conditions.rest(joint, this.lastSample(joint), silenceMessages.basis(evidence, limit), uncertainty);
  }
}

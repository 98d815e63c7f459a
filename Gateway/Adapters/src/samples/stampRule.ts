import { type Nanoseconds, NS_PER_S, toMilliseconds } from '../times';
import { refusalMessages } from '../messages/values';

const FUTURE: Nanoseconds = NS_PER_S;

/** The reason why a value is not forwarded: a word for counting, and a text. */
export interface Refusal {
  reason: string;
  text: string;
}

/** Refusals that are normal for the stamp of a value from before the connection. */
export const OF_LONG_AGO = ['stamp-old', 'stamp-not-newer', 'stamp-missing'];

/** Checks whether a stamp is plausible as the t_k of a joint's value. */
export class StampRule {
  readonly #newest: (Nanoseconds | null)[];

  /** @param oldest Maximum age on the control clock. Older values do not show a motion that a headset could follow. */
  constructor(
    joints: number,
    readonly oldest: Nanoseconds,
  ) {
    this.#newest = Array<Nanoseconds | null>(joints).fill(null);
  }

  /**
   * Checks the stamp, and stores it as the joint's newest if it is accepted.
   * @param now Control time; null while it is unknown.
   */
  judge(joint: number, stamp: Nanoseconds | null, now: Nanoseconds | null): Refusal | null {
    if (stamp === null) return { reason: 'stamp-missing', text: refusalMessages.noStamp };
    if (stamp <= 0n) return { reason: 'stamp-zero', text: refusalMessages.before1970 };
    const refusal = now === null ? null : this.#against(now, stamp);
    if (refusal !== null) return refusal;
    const newest = this.#newest[joint];
    // After the clock was set back, the previous newest stamp is in the future and must not block newer ones.
    const isStepped = newest !== null && now !== null && newest > now + FUTURE;
    if (newest !== null && stamp <= newest && !isStepped)
      return { reason: 'stamp-not-newer', text: refusalMessages.notNewer(toMilliseconds(newest - stamp)) };
    this.#newest[joint] = stamp;
    return null;
  }

  #against(now: Nanoseconds, stamp: Nanoseconds): Refusal | null {
    const { ahead, behind } = refusalMessages;
    if (stamp > now + FUTURE) return { reason: 'stamp-future', text: ahead(toMilliseconds(stamp - now), toMilliseconds(FUTURE)) };
    if (stamp < now - this.oldest) return { reason: 'stamp-old', text: behind(toMilliseconds(now - stamp), toMilliseconds(this.oldest)) };
    return null;
  }
}

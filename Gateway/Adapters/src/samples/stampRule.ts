import { type Nanoseconds, NS_PER_S, toMilliseconds } from '../times';
import { refusalMessages } from '../messages/values';

const FUTURE: Nanoseconds = NS_PER_S;

/** Difference from the control clock above which the text states the date of the stamp, which shows a wrong unit better than a number of ms. */
const FAR: Nanoseconds = 86_400n * NS_PER_S;

/** The reason why a value is not forwarded. `reason` is the name of the counter, and `text` is the explanation for a user. */
export interface Refusal {
  reason: string;
  text: string;
}

/** Reasons for a refusal that are normal for the first value of a connection, whose stamp may be from before the connection. */
export const OF_LONG_AGO = ['stamp-old', 'stamp-not-newer', 'stamp-missing'];

/**
 * Whether a stamp is newer than the newest one. After the clock was set back, the newest one is in the future. It is then ignored, so that new stamps
 * are accepted.
 */
export const isNewer = (stamp: Nanoseconds, newest: Nanoseconds | null, now: Nanoseconds | null): boolean =>
  newest === null || stamp > newest || (now !== null && newest > now + FUTURE);

/** Checks whether the stamps of a joint, frame or signal are plausible as t_k. */
export class StampRule {
  #newest: Nanoseconds | null = null;

  /** @param oldest Maximum age of a stamp on the control clock. Older values are useless for showing a motion. */
  constructor(readonly oldest: Nanoseconds) {}

  /**
   * Checks a stamp, and stores it as the newest stamp if it is accepted.
   * @param now Control time; null while it is unknown.
   * @param mayBeOld Whether the maximum age does not apply, because the joint has not moved since.
   * @returns The refusal; null if the stamp is accepted.
   */
  judge(stamp: Nanoseconds | null, now: Nanoseconds | null, mayBeOld = false): Refusal | null {
    if (stamp === null) return { reason: 'stamp-missing', text: refusalMessages.noStamp };
    if (stamp <= 0n) return { reason: 'stamp-zero', text: stamp === 0n ? refusalMessages.zeroStamp : refusalMessages.before1970 };
    const refusal = now === null ? null : this.#against(now, stamp, mayBeOld);
    if (refusal !== null) return refusal;
    const newest = this.#newest;
    if (newest !== null && !isNewer(stamp, newest, now)) {
      const { sameStamp, notNewer } = refusalMessages;
      const text = stamp === newest ? sameStamp : notNewer(toMilliseconds(newest - stamp));
      // Without the control time, the newest stamp may be the wrong one.
      return { reason: 'stamp-not-newer', text: now === null ? text : textOf(stamp, now, text) };
    }
    this.#newest = stamp;
    return null;
  }

  /** Whether a stamp is newer than the newest accepted stamp. */
  isNewer(stamp: Nanoseconds, now: Nanoseconds | null): boolean {
    return isNewer(stamp, this.#newest, now);
  }

  /** Whether a stamp equals the newest accepted stamp. */
  isNewest(stamp: Nanoseconds | null): boolean {
    return stamp !== null && stamp === this.#newest;
  }

  #against(now: Nanoseconds, stamp: Nanoseconds, mayBeOld: boolean): Refusal | null {
    const { ahead, behind } = refusalMessages;
    if (stamp > now + FUTURE) return { reason: 'stamp-future', text: textOf(stamp, now, ahead(toMilliseconds(stamp - now), toMilliseconds(FUTURE))) };
    if (!mayBeOld && stamp < now - this.oldest)
      return { reason: 'stamp-old', text: textOf(stamp, now, behind(toMilliseconds(now - stamp), toMilliseconds(this.oldest))) };
    return null;
  }
}

/** Returns the text, or one with the date of the stamp if this is far from the control time. */
const textOf = (stamp: Nanoseconds, control: Nanoseconds, text: string): string =>
  stamp > control + FAR || stamp < control - FAR ? refusalMessages.farApart(dayOf(stamp)) : text;

/** Gets the date of a stamp, such as 2026-11-29; null if a Date cannot contain it. */
function dayOf(stamp: Nanoseconds): string | null {
  const date = new Date(toMilliseconds(stamp));
  return Number.isNaN(date.getTime()) ? null : date.toISOString().split('T')[0];
}

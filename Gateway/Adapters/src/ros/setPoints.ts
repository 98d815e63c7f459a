import type { OfferedClock } from '../clock/offeredClock';
import type { Publisher } from '../gateway/link';
import { JOINT_TRAJECTORY, topicOf } from '../gateway/messages';

/**
 * Sends the newest set-points of each robot as soon as the clock of their stamps is known. Earlier, the gateway would interpret the stamps as times of
 * its own clock. They are kept messages, because the source may send set-points only once per motion.
 */
export class SetPoints {
  /** Set-points that wait for the clock, by topic. */
  readonly #waiting = new Map<string, object>();
  /** Topics whose newest set-points are kept messages. */
  readonly #sent = new Set<string>();

  constructor(
    readonly clock: Pick<OfferedClock, 'isSettled'>,
    readonly gateway: Pick<Publisher, 'publishKept' | 'forgetKept'>,
  ) {}

  add(robot: string, trajectory: object): void {
    this.#waiting.set(topicOf(robot, JOINT_TRAJECTORY), trajectory);
    this.check();
  }

  /** Sends the set-points that have waited, if the clock is known now. */
  check(): void {
    if (!this.clock.isSettled) return;
    for (const [topic, trajectory] of this.#waiting) {
      this.gateway.publishKept(topic, trajectory);
      this.#sent.add(topic);
    }
    this.#waiting.clear();
  }

  /** Discards all set-points after a disconnection from the source: its clock may have restarted, and it sends those that still apply again. */
  forget(): void {
    this.#waiting.clear();
    for (const topic of this.#sent) this.gateway.forgetKept(topic);
  }
}

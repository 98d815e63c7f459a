import { TF_STATIC } from '../cell/messages';
import type { SendQueue } from './sendQueue';
import { UNSYNCHRONISED } from './statusMessages';

/** Interval at which stationary frames, signals and set-points that the gateway refuses are sent again. */
export const REFUSED_EVERY_MS = 10_000;

/**
 * Messages that the gateway must have. They are sent again after a reconnection, and also after a refusal that can end by itself: another source may
 * release a stationary frame, and the gateway may measure the clock of set-points.
 */
export class KeptMessages {
  readonly #messages = new Map<string, { topic: string; text: string }>();
  /** Topics with such a refusal since the last call of `repeatRefused`. */
  readonly #refused = new Set<string>();
  /** Keys of the messages that wait for room in the socket's buffer. */
  readonly #waiting = new Set<string>();

  /** @param queue Takes the messages when they can be sent, so that many set-points for a slow gateway do not fill the socket's buffer. */
  constructor(readonly queue: Pick<SendQueue, 'pull'>) {}

  /** @param key Identifies the message. A later message with the same key replaces it. */
  set(key: string, topic: string, text: string): void {
    this.#messages.set(key, { topic, text });
    this.#schedule(key);
    // The refusal was that of the previous set-points. The topic of stationary frames has other messages, which remain refused.
    if (topic !== TF_STATIC) this.#refused.delete(topic);
  }

  delete(key: string): void {
    this.#messages.delete(key);
    this.#waiting.delete(key);
  }

  /** @param status A status message of the gateway about a dropped message. */
  refused(status: string): void {
    for (const { topic } of this.#messages.values())
      if (status.includes(` ${topic} `) && (topic === TF_STATIC || UNSYNCHRONISED.test(status))) this.#refused.add(topic);
  }

  /** Schedules all messages, for a new connection. */
  repeat(): void {
    for (const key of this.#messages.keys()) this.#schedule(key);
  }

  /** Schedules the messages of the topics that the gateway has refused since the last call. */
  repeatRefused(): void {
    for (const [key, { topic }] of this.#messages) if (this.#refused.has(topic)) this.#schedule(key);
    this.#refused.clear();
  }

  #schedule(key: string): void {
    this.#waiting.add(key);
    this.queue.pull('kept', () => this.#next());
  }

  #next(): string | null {
    const [key] = this.#waiting;
    if (key === undefined) return null;
    this.#waiting.delete(key);
    return this.#messages.get(key)!.text;
  }
}

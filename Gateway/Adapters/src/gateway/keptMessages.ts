import { TF_STATIC } from '../cell/messages';
import { UNSYNCHRONISED } from './statusMessages';

/** Interval at which stationary frames, signals and set-points that the gateway refuses are sent again. */
export const REFUSED_EVERY_MS = 10_000;

/**
 * Messages that the gateway must have. They are sent again after a reconnection, and also after a refusal that can end by itself: another source may
 * release a stationary frame, and the gateway may measure the clock of set-points.
 */
export class KeptMessages {
  readonly #messages = new Map<string, { topic: string; text: string }>();
  /** Topics with such a refusal since the last call of `takeRefused`. */
  readonly #refused = new Set<string>();

  /** All messages. */
  get all(): string[] {
    return [...this.#messages.values()].map(({ text }) => text);
  }

  /** @param key Identifies the message. A later message with the same key replaces it. */
  set(key: string, topic: string, text: string): void {
    this.#messages.set(key, { topic, text });
    // The refusal was that of the previous set-points. The topic of stationary frames has other messages, which remain refused.
    if (topic !== TF_STATIC) this.#refused.delete(topic);
  }

  delete(key: string): void {
    this.#messages.delete(key);
  }

  /** @param status A status message of the gateway about a dropped message. */
  refused(status: string): void {
    for (const { topic } of this.#messages.values())
      if (status.includes(` ${topic} `) && (topic === TF_STATIC || UNSYNCHRONISED.test(status))) this.#refused.add(topic);
  }

  /** Returns the messages of the topics that the gateway has refused since the last call. */
  takeRefused(): string[] {
    const again = [...this.#messages.values()].filter(({ topic }) => this.#refused.has(topic)).map(({ text }) => text);
    this.#refused.clear();
    return again;
  }
}

import { TF_STATIC } from '../cell/messages';

/** Interval at which stationary frames and signals that the gateway refuses are sent again. */
export const REFUSED_EVERY_MS = 10_000;

/** Messages that the gateway must have. They are sent again after a reconnection; stationary frames also after the gateway has refused some. */
export class KeptMessages {
  readonly #messages = new Map<string, { topic: string; text: string }>();
  #isRefused = false;

  /** All messages. */
  get all(): string[] {
    return [...this.#messages.values()].map(({ text }) => text);
  }

  /** @param key Identifies the message. A later message with the same key replaces it. */
  set(key: string, topic: string, text: string): void {
    this.#messages.set(key, { topic, text });
  }

  delete(key: string): void {
    this.#messages.delete(key);
  }

  /** @param status A status message of the gateway about a dropped message. */
  refused(status: string): void {
    this.#isRefused ||= status.includes(TF_STATIC);
  }

  /** Returns the stationary frames if the gateway has refused some since the last call: another source may have released them in the meantime. */
  takeRefused(): string[] {
    if (!this.#isRefused) return [];
    this.#isRefused = false;
    return [...this.#messages.values()].filter(({ topic }) => topic === TF_STATIC).map(({ text }) => text);
  }
}

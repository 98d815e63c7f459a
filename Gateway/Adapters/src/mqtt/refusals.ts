import { REFUSED_EVERY_MS } from '../gateway/keptMessages';

/** The topics that the broker refuses. They are tried again every 10 s, because the broker's operator may have corrected the rights. */
export class Refusals {
  readonly #reasons = new Map<string, string>();
  /** Tries the topics again; undefined while there are none. */
  #repetition: NodeJS.Timeout | undefined;

  /**
   * @param changed Called when the reason of the first refused topic changes, with null if there is none.
   * @param again Tries these topics again.
   */
  constructor(
    readonly changed: (reason: string | null) => void,
    readonly again: (topics: string[]) => void,
  ) {}

  /** Whether the broker refuses the topic. */
  has(topic: string): boolean {
    return this.#reasons.has(topic);
  }

  /** @param reason The reason why the broker refuses a topic; null if it accepts the topic. */
  judge(topic: string, reason: string | null): void {
    const before = this.#first;
    if (reason === null) this.#reasons.delete(topic);
    else this.#reasons.set(topic, reason);
    const now = this.#first;
    if (now === before) return;
    if (now === null) this.clear();
    else this.#repetition ??= setInterval(() => this.again([...this.#reasons.keys()]), REFUSED_EVERY_MS);
    this.changed(now);
  }

  /** Forgets all refusals, because the connection has ended. */
  clear(): void {
    this.#reasons.clear();
    clearInterval(this.#repetition);
    this.#repetition = undefined;
  }

  get #first(): string | null {
    const [reason = null] = this.#reasons.values();
    return reason;
  }
}

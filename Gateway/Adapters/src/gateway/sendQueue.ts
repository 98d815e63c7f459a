const CAPACITY = 64;
const MAX_IN_FLIGHT = 64 * 1024;

/** Queue of messages to a gateway that may be disconnected or slow. When full, it drops and counts the oldest message. */
export class SendQueue<T = string> {
  readonly #waiting: T[] = [];
  /** Sources of messages that are not dropped, each with its function for the next message. */
  readonly #pulled = new Map<string, () => T | null>();
  #dropped = 0;

  get dropped(): number {
    return this.#dropped;
  }

  add(message: T): void {
    if (this.#waiting.push(message) <= CAPACITY) return;
    this.#waiting.shift();
    this.#dropped++;
  }

  /**
   * Takes messages from a source when they can be sent, before those that were added, until the source has none. A source with the same key is
   * replaced.
   * @param next Gets the next message; null if there is none.
   */
  pull(key: string, next: () => T | null): void {
    this.#pulled.set(key, next);
  }

  /**
   * Sends messages while the socket's buffer has room. The other messages stay in this queue, where they can still be dropped.
   * @param again Called after each sent message.
   */
  pump(socket: { readonly bufferedAmount: number; send(data: T, done: () => void): void }, again: () => void): void {
    while (socket.bufferedAmount < MAX_IN_FLIGHT) {
      const message = this.#next();
      if (message === null) return;
      socket.send(message, again);
    }
  }

  #next(): T | null {
    for (const [key, next] of this.#pulled) {
      const message = next();
      if (message !== null) return message;
      this.#pulled.delete(key);
    }
    return this.#waiting.shift() ?? null;
  }
}

const CAPACITY = 64;
const MAX_IN_FLIGHT = 64 * 1024;

/** Queue of messages to a gateway that may be disconnected or slow. When full, it drops and counts the oldest message. */
export class SendQueue<T = string> {
  readonly #waiting: T[] = [];
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
   * Sends messages while the socket's buffer has room. The other messages stay in this queue, where they can still be dropped.
   * @param again Called after each sent message.
   */
  pump(socket: { readonly bufferedAmount: number; send(data: T, done: () => void): void }, again: () => void): void {
    while (this.#waiting.length > 0 && socket.bufferedAmount < MAX_IN_FLIGHT) socket.send(this.#waiting.shift()!, again);
  }
}

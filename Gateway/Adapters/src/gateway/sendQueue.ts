const CAPACITY = 64;
const MAX_IN_FLIGHT = 64 * 1024;

/** Queue of messages to a gateway that is away or slow. When full, the oldest are dropped and counted. */
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

  clear(): void {
    this.#waiting.length = 0;
  }

  /** Sends while the socket accepts messages immediately. Messages in this queue can still be dropped; those in the socket cannot. */
  pump(socket: { readonly bufferedAmount: number; send(data: T, done: () => void): void }, again: () => void): void {
    while (this.#waiting.length > 0 && socket.bufferedAmount < MAX_IN_FLIGHT) socket.send(this.#waiting.shift()!, again);
  }
}

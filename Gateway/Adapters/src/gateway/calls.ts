import { gatewayMessages } from '../messages/gateway';
import { afterArrivals } from '../sockets';
import { text } from './messages';

type Message = Record<string, unknown>;

const CALL_MS = 1500;

/**
 * Time without a response to any call after which the server is assumed to never respond on this connection. It is doubled for each further
 * connection without a response, because the other messages of such a connection still arrive.
 */
const BLOCKED_MS = 3 * CALL_MS;
const MAX_BLOCKED_MS = 60_000;

/** A busy process may miss one call although the server responds. */
const MIN_MISSED = 2;

/**
 * Calls services over the connections of a link. Reports a connection that no longer responds: a rosbridge of ROS 2 before version 2.2.0 waits
 * without limit for a service that ends during a call, and then reads no further message of this connection.
 */
export class Calls {
  readonly #waiting = new Map<string, { resolve: (answer: Message) => void; reject: (error: Error) => void }>();
  #called = 0;
  /** Whether the server has ever responded, also on an earlier connection. */
  #hasAnswered = false;
  #blockedMs = BLOCKED_MS;
  /** Number of calls without a response since the last response of this connection, and the start of the first of them. */
  #missed = 0;
  #missedSince = 0;

  /** @param blocked Called when the server has responded before, but no longer responds. */
  constructor(
    readonly send: (text: string) => void,
    readonly blocked: (reason: string) => void,
    readonly now: () => number = () => performance.now(),
  ) {}

  /** Ends the calls of a connection that has ended. */
  closed(): void {
    this.#missed = 0;
    for (const { reject } of this.#waiting.values()) reject(new Error(gatewayMessages.closed));
    this.#waiting.clear();
  }

  /** @throws Error The server does not respond in time, or refuses the call, or the connection ends. */
  async call(service: string): Promise<Message> {
    const id = `${service} ${++this.#called}`;
    const began = this.now();
    const cancel = afterArrivals(CALL_MS, () => this.#miss(id, service, began));
    const answer = await new Promise<Message>((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.send(JSON.stringify({ op: 'call_service', id, service, args: {} }));
    }).finally(cancel);
    if (answer.result === false) throw new Error(`${service}: ${text(answer.values)}`);
    return answer.values as Message;
  }

  answered(message: Message): void {
    this.#hasAnswered = true;
    this.#blockedMs = BLOCKED_MS;
    this.#missed = 0;
    const id = text(message.id);
    this.#waiting.get(id)?.resolve(message);
    this.#waiting.delete(id);
  }

  #miss(id: string, service: string, began: number): void {
    const call = this.#waiting.get(id);
    if (call === undefined) return;
    this.#waiting.delete(id);
    call.reject(new Error(gatewayMessages.notAnswered(service, CALL_MS / 1000)));
    if (this.#missed++ === 0) this.#missedSince = began;
    if (!this.#hasAnswered || this.#missed < MIN_MISSED || this.now() - this.#missedSince < this.#blockedMs) return;
    this.blocked(gatewayMessages.notAnswered(service, this.#blockedMs / 1000));
    this.#missed = 0;
    this.#blockedMs = Math.min(2 * this.#blockedMs, MAX_BLOCKED_MS);
  }
}

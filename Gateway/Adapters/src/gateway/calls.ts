import { gatewayMessages } from '../messages/gateway';
import { text } from './messages';

type Message = Record<string, unknown>;

const CALL_MS = 1500;

/** Time without a response to any call after which the server is assumed to never respond on this connection. */
const BLOCKED_MS = 3 * CALL_MS;

/**
 * Calls services over a connection. Reports a connection that no longer responds: the rosbridge of ROS 2 up to version 2.1.0 waits without limit for
 * a service that ends during a call, and then reads no further message of this connection.
 */
export class Calls {
  readonly #waiting = new Map<string, (answer: Message) => void>();
  #called = 0;
  #hasAnswered = false;
  /** Start of the first call without a response since the last response; null if there is none. */
  #unansweredSince: number | null = null;

  /** @param blocked Called when the server has responded before, but no longer responds. */
  constructor(
    readonly send: (text: string) => void,
    readonly blocked: (reason: string) => void,
  ) {}

  /** Resets the state for a new connection. */
  opened(): void {
    this.#hasAnswered = false;
    this.#unansweredSince = null;
  }

  /** @throws Error The server does not respond in time, or refuses the call. */
  async call(service: string): Promise<Message> {
    const id = `${service} ${++this.#called}`;
    const began = performance.now();
    const answer = await new Promise<Message | null>(resolve => {
      const timer = setTimeout(() => resolve(null), CALL_MS);
      this.#waiting.set(id, heard => {
        clearTimeout(timer);
        resolve(heard);
      });
      this.send(JSON.stringify({ op: 'call_service', id, service, args: {} }));
    });
    this.#waiting.delete(id);
    if (answer === null) this.#missed(service, began);
    if (answer === null) throw new Error(gatewayMessages.notAnswered(service, CALL_MS / 1000));
    if (answer.result === false) throw new Error(`${service}: ${text(answer.values)}`);
    return answer.values as Message;
  }

  answered(message: Message): void {
    this.#hasAnswered = true;
    this.#unansweredSince = null;
    this.#waiting.get(text(message.id))?.(message);
  }

  #missed(service: string, began: number): void {
    this.#unansweredSince ??= began;
    const isBlocked = this.#hasAnswered && performance.now() - this.#unansweredSince >= BLOCKED_MS;
    if (isBlocked) this.blocked(gatewayMessages.notAnswered(service, BLOCKED_MS / 1000));
  }
}

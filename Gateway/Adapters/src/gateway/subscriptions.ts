import { subscription, text } from './messages';

type Message = Record<string, unknown>;

interface Subscription {
  type: string;
  listeners: ((message: Message) => void)[];
  /** Whether no message has arrived since the connection. */
  isSilent: boolean;
}

/** The subscriptions of a connection, and their listeners. A topic may have several listeners. */
export class Subscriptions {
  readonly #topics = new Map<string, Subscription>();

  /** @param send Sends a message, or drops it without a connection. */
  constructor(readonly send: (text: string) => void) {}

  add(topic: string, type: string, listen: (message: Message) => void): void {
    const known = this.#topics.get(topic);
    if (known !== undefined) return void known.listeners.push(listen);
    this.#topics.set(topic, { type, listeners: [listen], isSilent: true });
    this.send(subscription(topic, type));
  }

  /** Sends all subscriptions on a new connection. */
  opened(): void {
    for (const [topic, known] of this.#topics) {
      known.isSilent = true;
      this.send(subscription(topic, known.type));
    }
  }

  /** Replaces the subscriptions to the topics of which no message has arrived on this connection. */
  renewSilent(): void {
    for (const [topic, { type, isSilent }] of this.#topics) {
      if (!isSilent) continue;
      this.send(JSON.stringify({ op: 'unsubscribe', topic }));
      this.send(subscription(topic, type));
    }
  }

  /** Passes a message to the listeners of its topic. */
  pass({ topic, msg }: Message): void {
    const known = this.#topics.get(text(topic));
    if (known === undefined) return;
    known.isSilent = false;
    for (const listen of known.listeners) listen(msg as Message);
  }
}

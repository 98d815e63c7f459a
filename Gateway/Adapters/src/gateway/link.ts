import WebSocket, { type RawData } from 'ws';
import { reconnecting } from '../backoff';
import type { GatewayAddress } from '../configuration/configuration';
import type { Log } from '../log';
import { Calls } from './calls';
import { KeptMessages, REFUSED_EVERY_MS } from './keptMessages';
import { advertisement, parsed, publication, text, typeOf } from './messages';
import { agentFor } from './pin';
import { ping } from './pings';
import { inWords, MAX_MESSAGE, refusalInWords } from './reasons';
import { SendQueue } from './sendQueue';
import { StatusMessages } from './statusMessages';
import { Subscriptions } from './subscriptions';
import { gatewayMessages } from '../messages/gateway';

const HANDSHAKE_MS = 5000;

/** Time without a request after which the offer of a service is repeated, because the gateway may have refused it. */
const OFFER_MS = 5000;

/** Handles a service call. The message of an exception is returned to the caller as the reason. */
export type Service = () => Promise<object>;

/** Callbacks of a link. */
export interface LinkEvents {
  opened?(): void;
  /** Called for each message of `publish`. */
  published?(topic: string, msg: object): void;
  /** Called after a disconnection, and after each failed connection attempt. */
  away?(reason: string): void;
  /** Called when a message is not JSON, or a listener has thrown an exception for a message on this topic. */
  malformed?(topic: string, problem: string): void;
  /**
   * Called with the reason when the gateway has dropped a message of this link.
   * @param isMeasuring Whether this is normal, because the gateway is still measuring the clock of the stamps.
   */
  refused?(reason: string, isMeasuring: boolean): void;
}

/** The part of a link that outputs use. */
export type Publisher = Pick<GatewayLink, 'publish' | 'publishNewest' | 'publishKept' | 'forgetKept' | 'dropped'>;

/**
 * The connection to a gateway or a robot with the rosbridge protocol. After a disconnection, it reconnects and repeats advertisements, subscriptions,
 * services and kept messages.
 */
export class GatewayLink {
  readonly #queue = new SendQueue();
  readonly #kept = new KeptMessages(this.#queue);
  readonly #topics = new Set<string>();
  readonly #services = new Map<string, { type: string; answer: Service; heard: number }>();
  readonly #subscriptions = new Subscriptions(message => this.#send(message));
  readonly #calls = new Calls(
    message => this.#send(message),
    reason => this.#abandon(reason),
  );
  readonly #statuses: StatusMessages;
  readonly #watchers: LinkEvents[];
  readonly #malformed = (topic: string, problem: string): void => this.#watchers.forEach(each => each.malformed?.(topic, problem));
  #socket: WebSocket | null = null;
  /** Ends the connection with a reason. */
  #abandon: (reason: string) => void = () => {};

  /** @param name Name of the gateway or robot, for the log. */
  constructor(
    readonly address: GatewayAddress,
    readonly log: Log,
    readonly name = 'gateway',
    events: LinkEvents = {},
  ) {
    this.#statuses = new StatusMessages(name, log);
    this.#watchers = [events];
  }

  get isOpen(): boolean {
    return this.#socket?.readyState === WebSocket.OPEN;
  }

  /** Number of messages dropped because the gateway was disconnected or slow. */
  get dropped(): number {
    return this.#queue.dropped;
  }

  /** Publishes a message. Drops it if the gateway remains disconnected or slow while many newer messages are published. */
  publish(topic: string, msg: object): void {
    this.#advertise(topic);
    this.#queue.add(publication(topic, msg));
    this.#pump();
    for (const { published } of this.#watchers) published?.(topic, msg);
  }

  /**
   * Publishes messages that must not be dropped. While the gateway is disconnected or slow, they are not created, so that they have the newest values.
   * @param next Creates the next message of the topic; null if there is none.
   */
  publishNewest(topic: string, next: () => object | null): void {
    this.#advertise(topic);
    this.#queue.pull(topic, () => {
      const msg = next();
      return msg === null ? null : publication(topic, msg);
    });
    this.#pump();
  }

  /**
   * Publishes a message now and after each reconnection; stationary frames and set-points also repeatedly while the gateway refuses them.
   * @param key Identifies the message. A later message with the same key replaces it.
   */
  publishKept(topic: string, msg: object, key = topic): void {
    this.#advertise(topic);
    this.#kept.set(key, topic, publication(topic, msg));
    this.#pump();
  }

  /** Stops the repetition of a kept message. */
  forgetKept(key: string): void {
    this.#kept.delete(key);
  }

  /** Offers a service until the link ends. */
  offer(service: string, type: string, answer: Service): void {
    this.#services.set(service, { type, answer, heard: 0 });
    this.#statuses.offered();
    this.#offer(service);
  }

  /** Adds callbacks. */
  watch(events: LinkEvents): void {
    this.#watchers.push(events);
  }

  /** Subscribes to a topic. A topic may have several listeners. */
  subscribe(topic: string, listen: (message: Record<string, unknown>) => void, type = typeOf(topic)!): void {
    this.#subscriptions.add(topic, type, listen);
  }

  /** Replaces the subscriptions to the topics of which no message has arrived on this connection. */
  renewSilentSubscriptions(): void {
    this.#subscriptions.renewSilent();
  }

  /**
   * Calls a service of the gateway or robot.
   * @throws Error The link is disconnected, also during the call, the service does not respond in time, or it refuses the call.
   */
  async call(service: string): Promise<Record<string, unknown>> {
    if (!this.isOpen) throw new Error(gatewayMessages.notConnected(this.name));
    return this.#calls.call(service);
  }

  /** Connects, and reconnects after each disconnection, until the signal is aborted. */
  run(stop: AbortSignal): Promise<void> {
    const away = (reason: string): void => {
      this.log.change(this.name, `${this.name} ${this.address.url} disconnected: ${this.log.clean(reason)}`);
      for (const { away } of this.#watchers) away?.(reason);
    };
    return reconnecting(stop, () => this.#connect(stop), away);
  }

  // Opens a connection. Resolves with the reason when the connection has ended.
  #connect(stop: AbortSignal): Promise<string> {
    const { url, token, pin } = this.address;
    const socket = new WebSocket(url, {
      agent: url.startsWith('wss:') ? agentFor(pin, this.name) : undefined,
      headers: token === null ? {} : { Authorization: `Bearer ${token}` },
      handshakeTimeout: HANDSHAKE_MS,
      maxPayload: MAX_MESSAGE,
      perMessageDeflate: false,
    });
    return new Promise(resolve => {
      let reason = gatewayMessages.closed;
      const leave = (): void => (socket.readyState === WebSocket.OPEN ? socket.close(1000) : socket.terminate());
      this.#abandon = text => {
        reason = text;
        socket.terminate();
      };
      const endPings = ping(
        socket,
        () => this.#offerAgain(),
        seconds => this.#abandon(gatewayMessages.silent(seconds)),
      );
      const repetition = setInterval(() => {
        this.#kept.repeatRefused();
        this.#pump();
      }, REFUSED_EVERY_MS);
      stop.addEventListener('abort', leave);
      socket.on('open', () => this.#open(socket));
      socket.on('message', data => this.#hear(data));
      socket.on('unexpected-response', (request, response) => {
        reason = refusalInWords(response.statusCode!, this.name);
        request.destroy();
        socket.terminate();
      });
      socket.on('error', error => {
        if (reason === gatewayMessages.closed) reason = inWords(error, this.name, this.#socket === socket);
      });
      socket.on('close', code => {
        endPings();
        clearInterval(repetition);
        stop.removeEventListener('abort', leave);
        this.#socket = null;
        this.#calls.closed();
        resolve(code > 1000 && code !== 1006 ? `${reason} (${code})` : reason);
      });
    });
  }

  #open(socket: WebSocket): void {
    this.#socket = socket;
    this.#statuses.opened();
    this.log.change(this.name, `${this.name} ${this.address.url} connected`);
    for (const topic of this.#topics) this.#send(advertisement(topic));
    for (const service of this.#services.keys()) this.#offer(service);
    this.#subscriptions.opened();
    this.#kept.repeat();
    this.#pump();
    for (const { opened } of this.#watchers) opened?.();
  }

  #hear(data: RawData): void {
    const message = parsed(data.toString());
    if (message === null) this.#malformed('message', gatewayMessages.notJson);
    switch (message?.op) {
      case 'publish':
        this.#pass(message);
        break;
      case 'service_response':
        this.#calls.answered(message);
        break;
      case 'call_service':
        void this.#answer(text(message.service), message.id);
        break;
      case 'status':
        if (message.level === 'error') this.#refuse(text(message.msg));
        break;
    }
  }

  // Passes a message to the listeners. Catches exceptions, because an invalid message must not end the process.
  #pass(message: Record<string, unknown>): void {
    try {
      this.#subscriptions.pass(message);
    } catch (error) {
      this.#malformed(text(message.topic), (error as Error).message);
    }
  }

  #refuse(status: string): void {
    this.#kept.refused(status);
    for (const { refused } of this.#watchers) refused?.(status, this.#statuses.isMeasuring(status));
    this.#statuses.write(status);
  }

  #offer(service: string): void {
    const offered = this.#services.get(service)!;
    offered.heard = performance.now();
    this.#send(JSON.stringify({ op: 'advertise_service', service, type: offered.type }));
  }

  #offerAgain(): void {
    for (const [service, { heard }] of this.#services) if (performance.now() - heard > OFFER_MS) this.#offer(service);
  }

  async #answer(service: string, id: unknown): Promise<void> {
    const [socket, offered] = [this.#socket, this.#services.get(service)];
    if (offered !== undefined) offered.heard = performance.now();
    const answer = offered?.answer() ?? Promise.reject(new Error(gatewayMessages.noService(service)));
    const response = await answer.then(
      values => ({ values, result: true }),
      error => ({ values: this.log.clean((error as Error).message), result: false }),
    );
    // The next connection may have another request with the same id.
    if (socket === this.#socket) this.#send(JSON.stringify({ op: 'service_response', id, service, ...response }));
  }

  #advertise(topic: string): void {
    if (this.#topics.has(topic)) return;
    this.#topics.add(topic);
    this.#send(advertisement(topic));
  }

  // Sends a message without queueing it. Drops it without a connection: after a reconnection, it is outdated, or #open sends it again.
  #send(text: string): void {
    if (this.isOpen) this.#socket!.send(text);
  }

  #pump(): void {
    if (this.isOpen) this.#queue.pump(this.#socket!, () => this.#pump());
  }
}

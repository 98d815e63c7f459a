import { randomBytes } from 'node:crypto';
import { connect, type IClientOptions, type MqttClient } from 'mqtt';
import { reconnecting } from '../backoff';
import { alertIn, isCertificateRefused, isOtherName, isUnknownHost, isUntrusted } from '../connectionErrors';
import type { BrokerAddress } from './address';
import { brokerMessages } from '../messages/broker';
import { PacketLimit } from './packetLimit';
import { Refusals } from './refusals';

const KEEP_ALIVE_S = 3;
const CONNECT_MS = 5000;
const GOODBYE_MS = 500;

/** Maximum packet size in bytes: a robot description of 1 MiB with a margin. */
const MAX_PACKET = 1024 * 1024 + 64 * 1024;

/** Callbacks of a link. */
export interface MqttEvents {
  /** Called after each connection, after the subscriptions have been sent. */
  opened(): void;
  /** Called before this client disconnects. */
  leaving?(): void;
  /**
   * Called after a disconnection, and after each failed connection attempt.
   * @param wasOpen Whether it is a disconnection.
   */
  away(reason: string, wasOpen: boolean): void;
  /** Called if the broker refuses the subscription to a topic. The link tries it again. */
  refused?(topic: string, reason: string): void;
  /** Called if the broker accepts the subscription to a topic that it has refused. */
  accepted?(topic: string): void;
  /** Called when the reason changes for which the broker refuses a subscription. It is the reason of the first refused topic; null if there is none. */
  subscriptionRefused?(reason: string | null): void;
  /**
   * Called for each message.
   * @param isRetained Whether the message is a retained one, which the broker had before the subscription.
   */
  heard(topic: string, payload: Buffer, isRetained: boolean): void;
  /** Called if a message on this topic caused an exception in `heard`. */
  malformed(topic: string, problem: string): void;
}

/** A connection to an MQTT 5 broker. After a disconnection, it reconnects and subscribes again. */
export class MqttLink {
  #client: MqttClient | null = null;
  /** Whether the last attempt has established a connection. */
  #wasOpen = false;
  /** Whether the broker has refused user and password in the last attempt. */
  #isLoginRefused = false;
  #version: 4 | 5 = 5;
  readonly #refusals = new Refusals(
    reason => this.events.subscriptionRefused?.(reason),
    topics => this.subscribeAgain(topics),
  );

  /**
   * @param name Name of the plant, used in the client identifier.
   * @param needsMqtt5 Whether a broker without MQTT 5 cannot be used. Otherwise, MQTT 3.1.1 is used with such a broker.
   */
  constructor(
    readonly broker: BrokerAddress,
    readonly name: string,
    readonly topics: string[],
    readonly events: MqttEvents,
    readonly options: IClientOptions = {},
    readonly needsMqtt5 = true,
  ) {}

  /** The client; null while it is not connected. */
  get client(): MqttClient | null {
    return this.#client?.connected ? this.#client : null;
  }

  /** Connects, and reconnects after each disconnection, until the signal is aborted. */
  run(stop: AbortSignal): Promise<void> {
    return reconnecting(
      stop,
      () => this.#connect(stop).finally(() => this.#refusals.clear()),
      reason => this.events.away(reason, this.#wasOpen),
      () => {},
      () => this.#isLoginRefused,
    );
  }

  /** Subscribes again, so that the broker sends the retained messages again. Has no effect without a connection. */
  subscribeAgain(topics = this.topics): void {
    if (this.client !== null) this.#subscribe(this.client, topics);
  }

  #connect(stop: AbortSignal): Promise<string> {
    this.#wasOpen = false;
    const client = connect(this.broker.endpoint, this.#options());
    return new Promise(resolve => {
      let failure: (Error & { code?: string | number }) | null = null;
      const leave = (): void => {
        if (client.connected) this.events.leaving?.();
        client.end(false, {}, () => resolve('stopped'));
        // A second call of end has no effect while the first one waits for the broker.
        setTimeout(() => client.stream.destroy(), GOODBYE_MS).unref();
      };
      stop.addEventListener('abort', leave);
      client.on('connect', () => this.#open(client));
      const limit = new PacketLimit(MAX_PACKET);
      client.stream.on('data', (bytes: Uint8Array) => {
        if (failure !== null || !limit.exceeds(bytes)) return;
        failure = new Error(brokerMessages.packetTooLong(MAX_PACKET / 1024));
        client.stream.destroy();
      });
      client.on('message', (topic, payload, { retain }) => this.#hear(topic, payload, retain));
      client.on('error', error => {
        failure = error;
      });
      // Handles only the first close event, because at a later one, the next client may already exist.
      client.once('close', () => {
        stop.removeEventListener('abort', leave);
        this.#client = null;
        client.end(true);
        this.#isLoginRefused = this.broker.user !== null && isLoginRefused(failure);
        const usesOther = isVersionRefused(failure) && !this.needsMqtt5 && this.#version === 5 && !stop.aborted;
        if (usesOther) this.#version = 4;
        resolve(usesOther ? this.#connect(stop) : inWords(failure, this.broker, this.#wasOpen, this.#version));
      });
    });
  }

  // Passes on a message. Catches exceptions, because an invalid message must not end the process.
  #hear(topic: string, payload: Buffer, isRetained: boolean): void {
    try {
      this.events.heard(topic, payload, isRetained);
    } catch (error) {
      this.events.malformed(topic, (error as Error).message);
    }
  }

  #options(): IClientOptions {
    const { user, authority, userCertificate } = this.broker;
    return {
      protocolVersion: this.#version,
      clientId: `nowpose-${this.name}-${randomBytes(4).toString('hex')}`,
      clean: true,
      keepalive: KEEP_ALIVE_S,
      reschedulePings: false,
      connectTimeout: CONNECT_MS,
      reconnectPeriod: 0,
      queueQoSZero: false,
      ...(this.#version === 5 ? { properties: { maximumPacketSize: MAX_PACKET } } : {}),
      ...(user === null ? {} : { username: user.name, password: user.password }),
      ...(authority === null ? {} : { ca: authority }),
      ...(userCertificate === null ? {} : { cert: userCertificate.certificate, key: userCertificate.key }),
      ...this.options,
    };
  }

  #open(client: MqttClient): void {
    this.#client = client;
    this.#wasOpen = true;
    this.#subscribe(client, this.topics);
    this.events.opened();
  }

  #subscribe(client: MqttClient, topics: string[]): void {
    for (const topic of topics) {
      // With nl (no local, only MQTT 5), the broker does not return this client's own messages. Without resubscribe, the client would ignore a second
      // subscription.
      const subscription = Object.assign({ [topic]: { qos: 1 as const, nl: true } }, { resubscribe: true });
      client.subscribe(subscription, (error, _, response) => {
        // Ignores the error of a subscription without a response, which fails because the connection ends.
        if (error && response === undefined) return;
        const reason = error ? brokerMessages.subscriptionRefused(topic, error.message) : null;
        if (reason !== null) this.events.refused?.(topic, reason);
        else if (this.#refusals.has(topic)) this.events.accepted?.(topic);
        this.#refusals.judge(topic, reason);
      });
    }
  }
}

/** Reason codes of MQTT 5, and of earlier versions, with which a broker refuses a login or the version. */
const LOGIN_REFUSED = [134, 135, 4, 5];
const VERSION_REFUSED = [132, 1];

const isLoginRefused = (failure: { code?: string | number } | null): boolean => LOGIN_REFUSED.includes(failure?.code as number);
const isVersionRefused = (failure: { code?: string | number } | null): boolean => VERSION_REFUSED.includes(failure?.code as number);

/**
 * @param wasOpen Whether the connection was established.
 * @param version Version of MQTT that was requested, 4 for 3.1.1.
 */
function inWords(failure: (Error & { code?: string | number }) | null, { endpoint, user }: BrokerAddress, wasOpen: boolean, version: 4 | 5): string {
  const { code, message = '' } = failure ?? {};
  if (/^(keepalive|connack) timeout$/i.test(message)) return brokerMessages.silent(endpoint);
  if (wasOpen) return failure === null || /^(read|write) (ECONNRESET|EPIPE)$/.test(message) ? brokerMessages.closed : message;
  if (code === 'ECONNREFUSED') return brokerMessages.refuses(endpoint);
  if (isUnknownHost(code)) return brokerMessages.unknownHost(endpoint);
  if (isLoginRefused(failure)) return (user === null ? brokerMessages.anonymousRefused : brokerMessages.loginRefused)(endpoint);
  if (isVersionRefused(failure) && version === 5) return brokerMessages.noMqtt5(endpoint);
  if (typeof code === 'number') return brokerMessages.refusesWith(endpoint, message);
  if (isOtherName(code)) return brokerMessages.otherHost(endpoint);
  const alert = alertIn(message);
  if (alert !== undefined) return isCertificateRefused(alert) ? brokerMessages.certificateRefused(alert) : brokerMessages.handshakeRefused(alert);
  if (isUntrusted(code)) return brokerMessages.notTrusted(String(code));
  return brokerMessages.noBroker(endpoint, failure === null ? 'connection closed' : String(code ?? message));
}

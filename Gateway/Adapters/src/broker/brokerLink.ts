import { randomBytes } from 'node:crypto';
import { connect, type IClientOptions, type MqttClient } from 'mqtt';
import { Backoff, pause } from '../backoff';
import { SendQueue } from '../gateway/sendQueue';
import type { BrokerSettings } from './settings';
import { brokerMessages } from '../messages/broker';

const KEEP_ALIVE_S = 3;
const CONNECT_MS = 5000;
const STEADY_MS = 2000;
const GOODBYE_MS = 500;

/**
 * The topics below the plant's topic: those with ROS names, with the namespace of a robot before them, the joints that are not live, and the
 * presence of the publishing end. All but the joint states are retained.
 */
export const STATES = 'joint_states';
export const TRAJECTORY = 'joint_trajectory';
export const DESCRIPTION = 'robot_description';
export const STATUS = 'joint_status';
export const ALIVE = 'alive';

/** Gets the topic of a robot; an empty namespace means none. */
export const below = (robot: string, topic: string): string => (robot === '' ? topic : `${robot}/${topic}`);

/** Values of ALIVE: bridge and gateway are present, the bridge is present without its gateway, or the bridge is absent. */
export type Presence = 'true' | 'no gateway' | 'false';

/** Maximum packet size: a description of 1 MiB with a margin. */
const MAX_PACKET = 1024 * 1024 + 64 * 1024;

export interface BrokerEvents {
  opened(): void;
  away(reason: string): void;
  heard(topic: string, payload: Buffer): void;
  /** A message on this topic caused an exception in `heard`. */
  malformed(topic: string, problem: string): void;
}

/** The connection to an MQTT 5 broker. Reconnects by itself, and then repeats subscriptions and retained messages. */
export class BrokerLink {
  readonly #queue = new SendQueue<{ topic: string; payload: string }>();
  readonly #retained = new Map<string, string>();
  #client: MqttClient | null = null;
  #presence: Presence = 'no gateway';

  /** @param subscriptions Topics below the plant's topic. */
  constructor(
    readonly settings: BrokerSettings,
    readonly name: string,
    readonly subscriptions: string[],
    readonly events: BrokerEvents,
  ) {}

  /** Number of messages dropped because the broker was disconnected or slow. */
  get dropped(): number {
    return this.#queue.dropped;
  }

  /**
   * Sends joint states or poses at most once (QoS 0), because a repeated message could arrive after a newer one.
   * If the broker is slow, the oldest messages are dropped.
   */
  publishSamples(topic: string, payload: string): void {
    this.#queue.add({ topic, payload });
    this.#pump();
  }

  /** Publishes a retained message with acknowledgement, which the broker keeps for later subscribers. */
  publishRetained(topic: string, payload: string): void {
    this.#retained.set(topic, payload);
    if (this.#client?.connected) this.#keep(topic, payload);
  }

  /** Sets whether the gateway of a publishing bridge is connected. */
  set isGatewayOpen(value: boolean) {
    const presence: Presence = value ? 'true' : 'no gateway';
    if (presence === this.#presence) return;
    this.#presence = presence;
    if (this.#client?.connected) this.#keep(ALIVE, presence);
  }

  async run(stop: AbortSignal): Promise<void> {
    const backoff = new Backoff();
    while (!stop.aborted) {
      const began = performance.now();
      const reason = await this.#connect(stop);
      if (stop.aborted) return;
      this.events.away(reason);
      if (performance.now() - began > STEADY_MS) backoff.reset();
      await pause(backoff.next(), stop);
    }
  }

  #connect(stop: AbortSignal): Promise<string> {
    const client = connect(this.settings.endpoint, this.#options());
    return new Promise(resolve => {
      let reason = brokerMessages.closed;
      const leave = (): void => {
        this.#sayAway(client);
        client.end(false, {}, () => resolve('stopped'));
        setTimeout(() => client.end(true), GOODBYE_MS).unref();
      };
      stop.addEventListener('abort', leave);
      client.on('connect', () => this.#open(client));
      client.on('message', (topic, payload) => this.#hear(topic.slice(this.settings.topic.length + 1), payload));
      client.on('error', error => {
        reason = inWords(error, this.settings.endpoint);
      });
      // The close event would report the end again, when the next client may already exist.
      client.once('close', () => {
        stop.removeEventListener('abort', leave);
        this.#client = null;
        client.end(true);
        resolve(reason);
      });
    });
  }

  // An invalid message from any publisher must not end the process.
  #hear(topic: string, payload: Buffer): void {
    try {
      this.events.heard(topic, payload);
    } catch (error) {
      this.events.malformed(topic, (error as Error).message);
    }
  }

  #options(): IClientOptions {
    const { topic, user, authority, direction } = this.settings;
    return {
      protocolVersion: 5,
      clientId: `nowpose-${this.name}-${randomBytes(4).toString('hex')}`,
      clean: true,
      keepalive: KEEP_ALIVE_S,
      reschedulePings: false,
      connectTimeout: CONNECT_MS,
      reconnectPeriod: 0,
      queueQoSZero: false,
      properties: { maximumPacketSize: MAX_PACKET },
      ...(user === null ? {} : { username: user.name, password: user.password }),
      ...(authority === null ? {} : { ca: authority }),
      // Published by the broker when this end disconnects without a close.
      ...(direction === 'publish' ? { will: { topic: `${topic}/${ALIVE}`, payload: Buffer.from('false'), qos: 1 as const, retain: true } } : {}),
    };
  }

  #open(client: MqttClient): void {
    this.#client = client;
    const { topic, direction } = this.settings;
    for (const name of this.subscriptions)
      client.subscribe(`${topic}/${name}`, { qos: 1 }, error => {
        if (error) this.events.away(brokerMessages.subscriptionRefused(`${topic}/${name}`, error.message));
      });
    if (direction === 'publish') this.#keep(ALIVE, this.#presence);
    for (const [name, payload] of this.#retained) this.#keep(name, payload);
    this.events.opened();
    this.#pump();
  }

  #keep(name: string, payload: string): void {
    this.#client!.publish(`${this.settings.topic}/${name}`, payload, { qos: 1, retain: true });
  }

  #sayAway(client: MqttClient): void {
    const { topic, direction } = this.settings;
    if (client.connected && direction === 'publish') client.publish(`${topic}/${ALIVE}`, 'false', { qos: 1, retain: true });
  }

  #pump(): void {
    const client = this.#client;
    if (!client?.connected) return;
    const socket = {
      get bufferedAmount() {
        return client.stream.writableLength;
      },
      send: ({ topic, payload }: { topic: string; payload: string }, done: () => void) =>
        void client.publish(`${this.settings.topic}/${topic}`, payload, { qos: 0 }, done),
    };
    this.#queue.pump(socket, () => this.#pump());
  }
}

function inWords(error: Error & { code?: unknown }, endpoint: string): string {
  if (error.code === 'ECONNREFUSED') return brokerMessages.refuses(endpoint);
  if (error.code === 134 || error.code === 135 || error.code === 4 || error.code === 5) return brokerMessages.loginRefused(endpoint);
  if (String(error.code).includes('CERT') || String(error.code).includes('UNABLE_TO') || String(error.code).includes('SELF_SIGNED'))
    return brokerMessages.notTrusted(String(error.code));
  return error.message;
}

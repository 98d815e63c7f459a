import { SendQueue } from '../gateway/sendQueue';
import { MqttLink } from '../mqtt/link';
import { Refusals } from '../mqtt/refusals';
import type { BrokerSettings } from './kind';
import { brokerMessages } from '../messages/broker';

/**
 * MQTT topics below the plant's topic: topics with ROS names, prefixed with the robot's namespace; the list of joints that are not live; and the
 * presence of the publishing bridge. All except the joint states are retained.
 */
export const STATES = 'joint_states';
export const TRAJECTORY = 'joint_trajectory';
export const DESCRIPTION = 'robot_description';
export const STATUS = 'joint_status';
export const ALIVE = 'alive';

/** Prefixes a topic with the namespace of a robot: `arm1/joint_states`. Returns the topic unchanged if the namespace is empty. */
export const below = (robot: string, topic: string): string => (robot === '' ? topic : `${robot}/${topic}`);

/** Interval at which a publishing bridge repeats its presence, so that receivers do not trust the presence of a bridge that has ended. */
const PRESENT_EVERY_MS = 2000;

/** Values of the topic ALIVE. true: bridge and gateway are connected. no gateway: only the bridge is connected. false: the bridge is disconnected. */
export type Presence = 'true' | 'no gateway' | 'false';

interface BrokerEvents {
  opened(): void;
  /**
   * Called after a disconnection, and after each failed connection attempt.
   * @param wasOpen Whether it is a disconnection.
   */
  away(reason: string, wasOpen: boolean): void;
  /** Called when the reason changes for which the broker refuses a subscription. It is the reason of the first refused topic; null if there is none. */
  subscriptionRefused(reason: string | null): void;
  /**
   * Called when the reason changes for which the broker refuses retained messages. It is the reason of the first topic whose newest message is refused;
   * null if there is none. Only for a publishing bridge.
   */
  messagesRefused?(reason: string | null): void;
  /** @param isRetained Whether the broker had the message before the subscription. */
  heard(topic: string, payload: Buffer, isRetained: boolean): void;
  /** Called when `heard` has thrown an exception for a message on this topic. */
  malformed(topic: string, problem: string): void;
}

/**
 * The connection of a bridge to the broker. Publishes retained messages again after each reconnection, and every 10 s those that the broker refuses. A
 * publishing bridge also publishes its retained messages and its presence again when another connection withdraws its presence: the former connection
 * of this bridge, which the broker ends later than the bridge, or another bridge. Receivers have then discarded the values that they had.
 */
export class BrokerLink {
  readonly #queue = new SendQueue<{ topic: string; payload: string }>();
  readonly #retained = new Map<string, string>();
  /** Topics whose newest retained message the broker refuses. */
  readonly #refused: Refusals;
  readonly #link: MqttLink;
  #presence: Presence = 'no gateway';

  /** @param subscriptions Topics below the plant's topic. */
  constructor(
    readonly settings: BrokerSettings,
    name: string,
    subscriptions: string[],
    readonly events: BrokerEvents,
  ) {
    this.#refused = new Refusals(
      reason => events.messagesRefused?.(reason),
      names => this.#announce([...this.#retained].filter(([name]) => names.includes(name))),
    );
    const bare = (topic: string): string => topic.slice(settings.topic.length + 1);
    this.#link = new MqttLink(
      settings.broker,
      name,
      (this.#isPublishing ? [...subscriptions, ALIVE] : subscriptions).map(topic => this.#at(topic)),
      {
        opened: () => this.#open(),
        leaving: () => {
          if (this.#isPublishing) this.#keep(ALIVE, 'false');
        },
        away: (reason, wasOpen) => {
          this.#refused.clear();
          events.away(reason, wasOpen);
        },
        subscriptionRefused: reason => events.subscriptionRefused(reason),
        heard: (topic, payload, isRetained) => {
          if (this.#isPublishing && bare(topic) === ALIVE) this.#announceAfter(payload.toString(), isRetained);
          else events.heard(bare(topic), payload, isRetained);
        },
        malformed: (topic, problem) => events.malformed(bare(topic), problem),
      },
      // The broker publishes this message when the connection is lost.
      this.#isPublishing ? { will: { topic: this.#at(ALIVE), payload: Buffer.from('false'), qos: 1, retain: true } } : {},
    );
  }

  /** Number of messages dropped because the broker was disconnected or slow. */
  get dropped(): number {
    return this.#queue.dropped;
  }

  /**
   * Publishes joint states or poses with QoS 0 (at most once), because a repeated message could arrive after a newer one.
   * Drops the oldest messages if the broker is slow.
   */
  publishSamples(topic: string, payload: string): void {
    this.#queue.add({ topic, payload });
    this.#pump();
  }

  /** Publishes a message with acknowledgement (QoS 1). The broker retains it for later subscribers. */
  publishRetained(topic: string, payload: string): void {
    this.#retained.set(topic, payload);
    this.#keep(topic, payload);
  }

  /** Removes a retained message from the broker. */
  removeRetained(topic: string): void {
    this.#retained.delete(topic);
    this.#keep(topic, '');
  }

  /** Sets whether a publishing bridge is connected to its gateway. */
  set isGatewayOpen(value: boolean) {
    const presence: Presence = value ? 'true' : 'no gateway';
    if (presence === this.#presence) return;
    this.#presence = presence;
    this.#keep(ALIVE, presence);
  }

  run(stop: AbortSignal): Promise<void> {
    const repetition = this.#isPublishing ? setInterval(() => this.#keep(ALIVE, this.#presence), PRESENT_EVERY_MS) : undefined;
    return this.#link.run(stop).finally(() => {
      clearInterval(repetition);
      this.#refused.clear();
    });
  }

  get #isPublishing(): boolean {
    return this.settings.direction === 'publish';
  }

  #at(topic: string): string {
    return `${this.settings.topic}/${topic}`;
  }

  #open(): void {
    this.#announce();
    this.events.opened();
    this.#pump();
  }

  // Sends the presence last, so that receivers have all values when the connection is announced.
  #announce(retained: Iterable<[string, string]> = this.#retained): void {
    for (const [name, payload] of retained) this.#keep(name, payload);
    if (this.#isPublishing) this.#keep(ALIVE, this.#presence);
  }

  // Ignores a retained message, because this bridge announces itself after its subscriptions.
  #announceAfter(presence: string, isRetained: boolean): void {
    if (!isRetained && presence === ('false' satisfies Presence)) this.#announce();
  }

  #keep(name: string, payload: string): void {
    this.#link.client?.publish(this.#at(name), payload, { qos: 1, retain: true }, (error, response) => {
      // Without a response, the connection has ended.
      if (response === undefined) return;
      // Does not store the refusal of a removal, because the bridge no longer has a message for this topic and would never delete the entry.
      this.#refused.judge(name, error && payload !== '' ? brokerMessages.publicationRefused(this.#at(name), error.message) : null);
    });
  }

  #pump(): void {
    const { client } = this.#link;
    if (client === null) return;
    const socket = {
      get bufferedAmount() {
        return client.stream.writableLength;
      },
      send: ({ topic, payload }: { topic: string; payload: string }, done: () => void) =>
        void client.publish(this.#at(topic), payload, { qos: 0 }, done),
    };
    this.#queue.pump(socket, () => this.#pump());
  }
}

import { SIGNALS, TF, TF_STATIC } from '../cell/messages';
import { isLate } from '../cell/signalSender';
import type { GatewayLink } from '../gateway/link';
import { SIGNAL_STATUS } from '../gateway/messages';
import { type Nanoseconds, ofRosTime } from '../times';
import type { BrokerLink } from './brokerLink';
import { FRAMES, REPORTS, SIGNAL, STATIONARY, topicFor } from './objectTopics';

interface Transform {
  child_frame_id: string;
}

/**
 * Forwards objects and signals from the gateway to the broker. Each retained topic has a value that the gateway has sent in this connection; the
 * gateway sends all its current values after the subscription. Other topics are removed: those of signals and stationary frames that no longer
 * exist, of frames that now move, and of an earlier run of this bridge.
 */
export class PublishedObjects {
  static readonly topics = [`${STATIONARY}/+`, `${SIGNAL}/+`];
  /** The retained topics, with the stamps of their values; zero for a stationary frame. */
  readonly #retained = new Map<string, Nanoseconds>();

  constructor(
    gateway: Pick<GatewayLink, 'subscribe' | 'watch'>,
    readonly broker: Pick<BrokerLink, 'publishSamples' | 'publishRetained' | 'removeRetained'>,
  ) {
    gateway.subscribe(TF, message => {
      for (const { child_frame_id: child } of message.transforms as Transform[]) this.#remove(topicFor(STATIONARY, child));
      broker.publishSamples(FRAMES, JSON.stringify(message));
    });
    gateway.subscribe(TF_STATIC, ({ transforms }) => {
      for (const one of transforms as Transform[]) this.#retain(topicFor(STATIONARY, one.child_frame_id), { transforms: [one] });
    });
    gateway.subscribe(SIGNALS, ({ header, name, value }) => {
      const stamp = ofRosTime((header as { stamp?: unknown }).stamp) ?? 0n;
      (name as string[]).forEach((one, i) => this.#retain(topicFor(SIGNAL, one), { header, name: [one], value: [(value as number[])[i]] }, stamp));
    });
    gateway.subscribe(SIGNAL_STATUS, message => broker.publishRetained(REPORTS, JSON.stringify(message)));
    gateway.watch({
      opened: () => {
        for (const topic of this.#retained.keys()) this.#remove(topic);
      },
    });
  }

  /** Processes a message on one of the topics. A retained one may be from an earlier run. */
  heard(topic: string, isRetained: boolean): void {
    if (isRetained && !this.#retained.has(topic)) this.broker.removeRetained(topic);
  }

  #retain(topic: string, message: object, stamp: Nanoseconds = 0n): void {
    if (isLate(stamp, this.#retained.get(topic) ?? 0n)) return;
    this.#retained.set(topic, stamp);
    this.broker.publishRetained(topic, JSON.stringify(message));
  }

  #remove(topic: string): void {
    if (this.#retained.delete(topic)) this.broker.removeRetained(topic);
  }
}

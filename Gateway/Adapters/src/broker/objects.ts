import { SIGNALS, TF, TF_STATIC } from '../cell/messages';
import { SignalSender } from '../cell/signalSender';
import type { OfferedClock } from '../clock/offeredClock';
import type { GatewayLink } from '../gateway/link';
import { SIGNAL_STATUS } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';
import { ofRosTime } from '../times';
import type { BrokerLink } from './brokerLink';
import { OTHER_GATEWAY, reportsOf } from './reportedJoints';
import { malformedMessages } from '../messages/broker';

/**
 * MQTT topics of objects and signals below the plant's topic. Each stationary frame and each signal has its own retained topic, so that a
 * later subscriber receives its newest value.
 */
export const FRAMES = 'tf';
const STATIONARY = 'tf_static';
const SIGNAL = 'signals';
const REPORTS = 'signal_status';

const MAX_NAMES = 256;

/** Encodes a name as a topic level, without MQTT's separators and wildcards. */
const level = (name: string): string => encodeURIComponent(name);

interface Transform {
  child_frame_id?: unknown;
}

/** Forwards objects and signals from the gateway to the broker. */
export function publishObjects(gateway: GatewayLink, broker: BrokerLink): void {
  gateway.subscribe(TF, message => broker.publishSamples(FRAMES, JSON.stringify(message)));
  gateway.subscribe(TF_STATIC, ({ transforms }) => {
    for (const one of transforms as Transform[])
      broker.publishRetained(`${STATIONARY}/${level(String(one.child_frame_id))}`, JSON.stringify({ transforms: [one] }));
  });
  gateway.subscribe(SIGNALS, ({ header, name, value }) =>
    (name as string[]).forEach((one, i) =>
      broker.publishRetained(`${SIGNAL}/${level(one)}`, JSON.stringify({ header, name: [one], value: [(value as number[])[i]] })),
    ),
  );
  gateway.subscribe(SIGNAL_STATUS, message => broker.publishRetained(REPORTS, JSON.stringify(message)));
}

/** Forwards objects and signals from the broker to a gateway. The gateway checks their content. */
export class ReceivedObjects {
  readonly topics = [FRAMES, `${STATIONARY}/+`, `${SIGNAL}/+`, REPORTS];
  readonly #sender: SignalSender;
  readonly #signals = new Set<string>();
  /** Signals that are not current at the plant's gateway, with the reasons. */
  #reported = new Map<string, string>();
  readonly #stationary = new Set<string>();

  /** @param counter Monotonic time in ms. */
  constructor(
    readonly gateway: GatewayLink,
    readonly clock: OfferedClock,
    readonly status: AdapterStatus,
    counter: () => number = () => performance.now(),
  ) {
    this.#sender = new SignalSender(clock, gateway, () => status.sampled(), counter);
    gateway.watch(this.#sender);
  }

  take(topic: string, message: Record<string, unknown>): void {
    const [kind] = topic.split('/');
    if (kind === SIGNAL) this.#takeSignal(message);
    else if (kind === REPORTS) this.#takeReports(message);
    else this.#takeFrames(kind === STATIONARY, message);
  }

  /** Sends the signals that have waited for the clock. Called several times per second. */
  check(): void {
    this.#sender.check();
  }

  /** Updates the state of all signals, because the plant's gateway is connected again. */
  enter(): void {
    for (const name of this.#signals) this.#judge(name);
  }

  #takeFrames(isStationary: boolean, message: Record<string, unknown>): void {
    const { transforms } = message as { transforms?: unknown };
    if (!Array.isArray(transforms)) throw new Error(malformedMessages.noTransforms);
    if (isStationary) {
      const [{ child_frame_id: child }] = transforms as [{ child_frame_id: string }];
      if (!this.#stationary.has(child) && this.#stationary.size >= MAX_NAMES) return this.status.count('too-many');
      this.#stationary.add(child);
      // Uses a zero stamp, which needs no clock, because a stationary frame has the same pose at all times.
      const [{ header, ...pose }] = transforms as [{ header: object }];
      const still = { ...header, stamp: { sec: 0, nanosec: 0 } };
      this.gateway.publishKept(TF_STATIC, { transforms: [{ header: still, ...pose }] }, `${TF_STATIC} ${child}`);
    } else if (this.clock.isSettled) {
      this.gateway.publish(TF, message);
      this.status.sampled();
    } else {
      this.status.count('clock-unknown');
    }
  }

  #takeSignal({ header, name, value }: Record<string, unknown>): void {
    const [one] = name as unknown[];
    const [number] = value as unknown[];
    const stamp = ofRosTime((header as { stamp?: unknown }).stamp);
    if (typeof one !== 'string' || typeof number !== 'number' || stamp === null) throw new Error(malformedMessages.signal);
    if (!this.#signals.has(one) && this.#signals.size >= MAX_NAMES) return this.status.count('too-many');
    this.#signals.add(one);
    this.#sender.add(one, number, stamp);
    this.#judge(one);
  }

  #takeReports(message: Record<string, unknown>): void {
    const reports = reportsOf(message, Date.now());
    if (typeof reports === 'string') throw new Error(reports);
    this.#reported = new Map(reports.map(({ joint, reason }) => [joint, reason]));
    for (const name of new Set([...this.#signals, ...this.#reported.keys()])) this.#judge(name);
  }

  #judge(name: string): void {
    const reason = this.#reported.get(name);
    if (reason === undefined) this.status.signals.live(name);
    else this.status.signals.fault(name, { reason: OTHER_GATEWAY, text: reason });
  }
}

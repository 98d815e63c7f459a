import { stationaryKey, TF, TF_STATIC } from '../cell/messages';
import { SignalSender } from '../cell/signalSender';
import type { OfferedClock } from '../clock/offeredClock';
import type { GatewayLink } from '../gateway/link';
import type { AdapterStatus } from '../gateway/status';
import { ofRosTime, unixTimeMs } from '../times';
import { FRAMES, namedBy, REPORTS, SIGNAL, STATIONARY } from './objectTopics';
import { OTHER_GATEWAY, reportsOf } from './reportedJoints';
import { brokerMessages, malformedMessages } from '../messages/broker';

const MAX_NAMES = 256;

/** Time in ms for which the values of the plant's gateway may still arrive after its connection. */
const ARRIVAL_MS = 2000;

/** Forwards objects and signals from the broker to a gateway. The gateway checks their content. */
export class ReceivedObjects {
  readonly topics = [FRAMES, `${STATIONARY}/+`, `${SIGNAL}/+`, REPORTS];
  readonly #sender: SignalSender;
  readonly #signals = new Set<string>();
  /** Signals whose values the plant's gateway still has, as long as it is connected. */
  readonly #confirmed = new Set<string>();
  /** Whether the plant's gateway is connected to the broker. */
  #isThere = false;
  /** Time of its connection in ms, while its values may still arrive; otherwise null. */
  #entered: number | null = null;
  /** Signals that are not current at the plant's gateway, with the reasons. */
  #reported = new Map<string, string>();
  readonly #stationary = new Set<string>();

  /** @param counter Monotonic time in ms. */
  constructor(
    readonly gateway: Pick<GatewayLink, 'publish' | 'publishNewest' | 'publishKept' | 'forgetKept' | 'watch'>,
    readonly clock: Pick<OfferedClock, 'isSettled'>,
    readonly status: AdapterStatus,
    readonly counter: () => number = () => performance.now(),
  ) {
    this.#sender = new SignalSender(clock, gateway, () => status.sampled(), counter);
    gateway.watch(this.#sender);
  }

  take(topic: string, message: Record<string, unknown>): void {
    const { kind } = namedBy(topic);
    if (kind === SIGNAL) this.#takeSignal(message);
    else if (kind === REPORTS) this.#takeReports(message);
    else this.#takeFrames(kind === STATIONARY, message);
  }

  /** Processes the removal of a retained message. The plant's gateway no longer has this stationary frame or signal, or the frame now moves. */
  remove(topic: string): void {
    const { kind, name } = namedBy(topic);
    if (name === undefined) throw new Error(malformedMessages.notObject);
    if (kind === STATIONARY) this.#forgetStationary(name);
    else if (this.#confirmed.delete(name)) this.#judge(name);
  }

  /** Sends the signals that have waited for the clock, and judges those whose value has not arrived in time. Called several times per second. */
  check(): void {
    this.#sender.check();
    if (this.#entered === null || this.counter() - this.#entered < ARRIVAL_MS) return;
    this.#entered = null;
    this.#judgeAll();
  }

  /** Updates the state of all signals, because the plant's gateway is connected. A signal without a value keeps its state for ARRIVAL_MS. */
  enter(): void {
    this.#isThere = true;
    this.#entered = this.counter();
    this.#judgeAll();
  }

  /** Discards the confirmation of all signals, because the plant's gateway is disconnected. When it is connected, it sends the values that it still has. */
  leave(): void {
    this.#isThere = false;
    this.#confirmed.clear();
  }

  #takeFrames(isStationary: boolean, message: Record<string, unknown>): void {
    const { transforms } = message as { transforms?: unknown };
    if (!Array.isArray(transforms)) throw new Error(malformedMessages.noTransforms);
    if (isStationary) {
      const [{ child_frame_id: child }] = transforms as [{ child_frame_id: string }];
      if (!this.#stationary.has(child) && this.#stationary.size >= MAX_NAMES) return this.status.tooMany('stationary frames', MAX_NAMES);
      this.#stationary.add(child);
      // Uses a zero stamp, which needs no clock, because a stationary frame has the same pose at all times.
      const [{ header, ...pose }] = transforms as [{ header: object }];
      const still = { ...header, stamp: { sec: 0, nanosec: 0 } };
      this.gateway.publishKept(TF_STATIC, { transforms: [{ header: still, ...pose }] }, stationaryKey(child));
      return;
    }
    for (const one of transforms as ({ child_frame_id?: string } | null)[]) this.#forgetStationary(one?.child_frame_id ?? '');
    if (this.clock.isSettled) {
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
    if (!this.#signals.has(one) && this.#signals.size >= MAX_NAMES) return this.status.tooMany('signals', MAX_NAMES);
    this.#signals.add(one);
    this.#confirmed.add(one);
    this.#sender.add(one, number, stamp);
    this.#judge(one);
  }

  #takeReports(message: Record<string, unknown>): void {
    const reports = reportsOf(message, unixTimeMs());
    if (typeof reports === 'string') throw new Error(reports);
    const reported = new Map(reports.map(({ joint, reason }) => [joint, reason]));
    for (const name of this.#reported.keys()) if (!this.#signals.has(name) && !reported.has(name)) this.status.signals.forget(name);
    this.#reported = reported;
    this.#judgeAll();
  }

  #judgeAll(): void {
    for (const name of new Set([...this.#signals, ...this.#reported.keys()])) this.#judge(name);
  }

  #forgetStationary(frame: string): void {
    if (this.#stationary.delete(frame)) this.gateway.forgetKept(stationaryKey(frame));
  }

  // A report without a signal does not confirm its value: the list of a gateway that has just started is empty.
  #judge(name: string): void {
    if (!this.#isThere) return;
    const reason = this.#reported.get(name);
    if (reason !== undefined) this.#fault(name, reason);
    else if (this.#confirmed.has(name)) this.status.signals.live(name);
    else if (this.#entered === null) this.#fault(name, brokerMessages.noSignal);
  }

  #fault(name: string, text: string): void {
    this.status.signals.fault(name, { reason: OTHER_GATEWAY, text });
  }
}

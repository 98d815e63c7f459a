import type { OfferedClock } from '../clock/offeredClock';
import type { PlantOutput } from '../samples/plantOutput';
import type { TopicValues } from '../samples/topicValues';
import { ofRosTime } from '../times';

type Message = Record<string, unknown>;

/**
 * Publishes the values in messages of topics. A message without a header has the time of its arrival, which is later than the change by the transmission
 * time. A robot sends a latched message once, directly after the subscription, so such a message waits until the clock is known.
 */
export class TopicMessages {
  /** Newest message without a header of each topic. */
  readonly #newest = new Map<string, Message>();
  /** Topics whose newest message waits for the clock. */
  readonly #waiting = new Set<string>();

  constructor(
    readonly values: Pick<TopicValues, 'in'>,
    readonly output: PlantOutput,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
  ) {}

  pass(topic: string, message: Message): void {
    const { stamp } = (message.header ?? {}) as { stamp?: unknown };
    const sampled = ofRosTime(stamp);
    if (sampled !== null) return this.output.publish(this.values.in(topic, message, sampled));
    this.#newest.set(topic, message);
    this.#waiting.add(topic);
    this.check();
  }

  /** Publishes the messages that have waited, if the clock is known now. */
  check(): void {
    const { now, isSettled } = this.clock;
    if (now === null || !isSettled) return;
    for (const topic of this.#waiting) this.output.publish(this.values.in(topic, this.#newest.get(topic)!, now));
    this.#waiting.clear();
  }

  /** Prepares for the time of another clock. Signals have their last values with the new time, because the robot does not send them again. */
  clockStepped(): void {
    const { signals } = this.output;
    this.output.clockStepped();
    for (const [topic, message] of this.#newest)
      if (!this.#waiting.has(topic)) signals.publish(this.values.in(topic, message, this.clock.now).filter(({ index }) => index >= signals.offset));
  }

  /** Discards all messages after a disconnection from the robot, which sends the latched ones again. */
  forget(): void {
    this.#newest.clear();
    this.#waiting.clear();
  }
}

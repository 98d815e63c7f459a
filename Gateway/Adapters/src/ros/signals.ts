import type { PlantClock } from '../clock/plantClock';
import type { Signal } from '../configuration/signals';
import type { PlantOutput } from '../samples/plantOutput';
import { ofRosTime } from '../times';

/** A signal and its place in ROS. */
export interface RosSignal extends Signal {
  topic: string;
  type: string;
  field: string;
}

/**
 * Takes the signals of a robot's topics. The stamp is that of the message's header or, for a type without one, the robot's time at the
 * arrival, which is later than the change by the transmission time.
 */
export class RosSignals {
  readonly #heard = new Set<number>();

  /** @param offset Index of the first signal among the values of the configuration. */
  constructor(
    readonly signals: RosSignal[],
    readonly offset: number,
    readonly clock: Pick<PlantClock, 'now'>,
    readonly output: Pick<PlantOutput, 'publish'>,
  ) {}

  /** The topics with their types, each once. */
  get topics(): Map<string, string> {
    return new Map(this.signals.map(({ topic, type }) => [topic, type]));
  }

  pass(topic: string, message: Record<string, unknown>): void {
    const { stamp } = (message.header ?? {}) as { stamp?: unknown };
    const values = this.signals.flatMap((signal, i) => {
      if (signal.topic !== topic) return [];
      const value = signal.field.split('.').reduce<unknown>((part, name) => (part as Record<string, unknown> | undefined)?.[name], message);
      const isFirst = !this.#heard.has(i);
      this.#heard.add(i);
      return [{ index: this.offset + i, value, stamp: ofRosTime(stamp) ?? this.clock.now, isFirst }];
    });
    this.output.publish(values);
  }
}

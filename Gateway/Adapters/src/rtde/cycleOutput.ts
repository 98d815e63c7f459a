import type { PlantOutput } from '../samples/plantOutput';
import { type Nanoseconds, NS_PER_MS, ofMilliseconds } from '../times';
import type { Cycle, Recipe, RtdeAddress } from './recipe';
import type { RtdeSettings } from './kind';

/** Time by which a package may be earlier than the chosen interval, because timestamps are rounded. */
const TOLERANCE: Nanoseconds = NS_PER_MS / 2n;

/** Time without a confirmation after which a signal has a fault. The controller confirms each signal in each package. */
const SIGNAL_SILENCE_MS = 1000;

/** Publishes the joints and poses from data packages at the chosen rate, and the signals from all packages. */
export class CycleOutput {
  /** The configured values of frames and signals whose fields exist in the controller. */
  readonly #values: { index: number; address: RtdeAddress }[];
  #published: Nanoseconds | null = null;

  constructor(
    readonly output: PlantOutput,
    readonly settings: RtdeSettings,
    readonly recipe: Recipe,
  ) {
    const first = settings.indices.length;
    output.signals.silence.unconfirmedMs = SIGNAL_SILENCE_MS;
    this.#values = settings.addresses.flatMap((address, i) => {
      const objection = recipe.objectionTo(address);
      if (objection !== null) output.lose(first + i, { reason: 'not-readable', text: objection });
      return objection === null ? [{ index: first + i, address }] : [];
    });
  }

  publish({ positions, velocities }: Cycle, payload: Buffer, stamp: Nanoseconds): void {
    const { joints, frames, signals } = this.output;
    const values = this.#values.map(({ index, address }) => ({ index, value: this.recipe.read(payload, address), stamp }));
    signals.publish(values.filter(({ index }) => index >= signals.offset));
    const interval = ofMilliseconds(1000 / this.settings.rateHz);
    if (this.#published !== null && stamp - this.#published < interval - TOLERANCE) return;
    this.#published = stamp;
    frames.publish(values.filter(({ index }) => index < signals.offset));
    joints.publish(
      this.settings.indices.map((place, index) => ({
        index,
        value: positions[place],
        stamp,
        ...(velocities === null ? {} : { velocity: velocities[place] }),
      })),
    );
  }
}

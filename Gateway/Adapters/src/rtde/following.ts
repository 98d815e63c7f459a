import type { Cycle } from './recipe';

/** Time constant, in s, with which the weight of old cycles decays. */
const WINDOW_S = 10;

/** Minimum integral of the squared velocities over time for an estimate, rad²/s. */
const MOVED = 0.01;

/** Estimates by how much the measured positions lag behind the commanded ones: the slope of their difference as a function of the velocity. */
export class Following {
  #products = 0;
  #squares = 0;
  #last: number | null = null;

  /** The lag in ms; null until the arm has moved enough. */
  get lagMs(): number | null {
    return this.#squares < MOVED ? null : (1000 * this.#products) / this.#squares;
  }

  add({ timestamp, deviations, velocities }: Cycle): void {
    const passed = this.#last === null ? 0 : timestamp - this.#last;
    this.#last = timestamp;
    if (deviations === null || velocities === null) return;
    const kept = Math.exp(-passed / WINDOW_S);
    this.#products = kept * this.#products + passed * deviations.reduce((sum, deviation, i) => sum + deviation * velocities[i], 0);
    this.#squares = kept * this.#squares + passed * velocities.reduce((sum, velocity) => sum + velocity ** 2, 0);
  }
}

import { isClockStopped, type PlantClock } from '../clock/plantClock';
import type { Nanoseconds } from '../times';

const LOOK_MS = 500, SILENCE_MS = 5000, MISSED = 3, MOST_READINGS = 64;

/** Sees that the server still talks: by its notifications, or signs of life in their place, and by its clock. */
export class Watch {
  #heard = performance.now();
  /** What its clock showed, and when it was read; oldest first. */
  #readings: { time: Nanoseconds; at: number }[] = [];

  alive(): void {
    this.#heard = performance.now();
  }

  /**
   * A time that its clock showed so long ago that what changed until then has been told by now; null where none was read.
   * @param delayMs How long a change may take to be told.
   */
  settledTime(delayMs: number): Nanoseconds | null {
    const settled = this.#readings.filter(({ at }) => performance.now() - at > delayMs).at(-1) ?? null;
    this.#readings = this.#readings.filter(reading => settled === null || reading.at >= settled.at);
    return settled?.time ?? null;
  }

  /**
   * Resolves with the reason when it has fallen silent; looks until `ended`. Each look also tells how its clock goes.
   * @param keepAliveMs How often it gives a sign of life.
   * @param look Called in each look, after the clock was read.
   */
  async silence(clock: PlantClock, keepAliveMs: number, ended: Promise<unknown>, look: () => Promise<void>): Promise<string> {
    const longest = Math.max(SILENCE_MS, MISSED * keepAliveMs);
    let isOver = false;
    void ended.then(() => { isOver = true; });
    while (!isOver) {
      await new Promise(resolve => setTimeout(resolve, LOOK_MS));
      if (performance.now() - this.#heard > longest) return `nothing was published for ${longest / 1000} s`;
      try {
        if (!isOver) this.#note((await clock.read()).received);
      } catch (error) {
        // A server whose clock was stopped still answers; whoever asks for the time is told.
        if (!isClockStopped(error)) return `its clock cannot be read: ${(error as Error).message}`;
      }
      try {
        if (!isOver) await look();
      } catch (error) {
        return `its nodes cannot be read: ${(error as Error).message}`;
      }
    }
    return 'the connection ended';
  }

  #note(time: Nanoseconds): void {
    this.#readings.push({ time, at: performance.now() });
    if (this.#readings.length > MOST_READINGS) this.#readings.shift();
  }
}

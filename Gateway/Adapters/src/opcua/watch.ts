import { isClockStopped, type PlantClock } from '../clock/plantClock';
import type { Nanoseconds } from '../times';
import { clockMessages } from '../messages/gateway';
import { opcuaMessages } from '../messages/opcua';

/** Interval of the checks while values arrive, and after none has arrived for QUIET_MS. A headset shows a sample for 300 ms. */
const LOOK_MS = 500;
const QUIET_LOOK_MS = 60;
const QUIET_MS = 50;

const SILENCE_MS = 5000;
const MISSED = 3;

/** Monitors the server by its notifications, its keep-alive messages and its clock. */
export class Watch {
  #heard = performance.now();
  #valued = -Infinity;

  alive(): void {
    this.#heard = performance.now();
  }

  /** Reports that values arrived. */
  valued(): void {
    this.#valued = performance.now();
  }

  /**
   * Resolves with the reason when the server is silent; checks until `ended`. Each check also measures the clock.
   * @param keepAliveMs Interval of the server's keep-alive messages.
   * @param look Called in each check, with the clock's time just before; null if it was not read.
   */
  async silence(clock: PlantClock, keepAliveMs: number, ended: Promise<unknown>, look: (time: Nanoseconds | null) => Promise<void>): Promise<string> {
    const longest = Math.max(SILENCE_MS, MISSED * keepAliveMs);
    let isOver = false;
    let looked = performance.now();
    void ended.then(() => {
      isOver = true;
    });
    while (!isOver) {
      await new Promise(resolve => setTimeout(resolve, QUIET_LOOK_MS));
      if (performance.now() - this.#heard > longest) return opcuaMessages.silent(longest / 1000);
      if (performance.now() - this.#valued < QUIET_MS && performance.now() - looked < LOOK_MS) continue;
      looked = performance.now();
      let time: Nanoseconds | null = null;
      try {
        if (!isOver) time = (await clock.read()).received;
      } catch (error) {
        // A server with a stopped clock still answers. The reader of the time gets the error.
        if (!isClockStopped(error)) return clockMessages.notReadable((error as Error).message);
      }
      try {
        if (!isOver) await look(time);
      } catch (error) {
        return opcuaMessages.notReadable((error as Error).message);
      }
    }
    return opcuaMessages.ended;
  }
}

import { isClockStopped, type OfferedClock } from '../clock/offeredClock';
import { SILENT_MS } from '../samples/silentValues';
import { afterArrivals } from '../sockets';
import type { Nanoseconds } from '../times';
import { clockMessages } from '../messages/gateway';
import { requestTrouble } from './troubles';
import { opcuaMessages } from '../messages/opcua';

/**
 * LOOK_MS: interval of the checks while values arrive. QUIET_LOOK_MS: interval between notifications while a node must be read. It is short, because
 * headsets show a sample for only about 300 ms.
 */
const LOOK_MS = 500;
const QUIET_LOOK_MS = 60;

const SILENCE_MS = 5000;
const MISSED = 3;

/** Gets the time in ms without notifications after which a server counts as silent. `keepAliveMs` is the interval of its keep-alive messages. */
export const maxSilenceMs = (keepAliveMs: number): number => Math.max(SILENCE_MS, MISSED * keepAliveMs);

/** Detects a server that no longer responds, from its notifications, its keep-alive messages and the readings of its clock. */
export class ServerSilence {
  #heard = performance.now();
  #valued = -Infinity;

  alive(): void {
    this.#heard = performance.now();
  }

  /** Records that values have just arrived. */
  valued(): void {
    this.#valued = performance.now();
  }

  /**
   * Checks the server until `ended` resolves. Each check also reads the clock. Resolves with the reason when the server no longer responds.
   * @param keepAliveMs Interval of the server's keep-alive messages, ms.
   * @param hasSilent Whether the next check reads a node.
   * @param look Called in each check with the time just read from the clock; null if the clock has stopped.
   */
  async detect(
    clock: OfferedClock,
    keepAliveMs: number,
    ended: Promise<unknown>,
    hasSilent: () => boolean,
    look: (time: Nanoseconds | null) => Promise<void>,
  ): Promise<string> {
    const longest = maxSilenceMs(keepAliveMs);
    let isOver = false;
    let looked = performance.now();
    void ended.then(() => {
      isOver = true;
    });
    while (!isOver) {
      await new Promise<void>(resolve => void afterArrivals(QUIET_LOOK_MS, resolve));
      if (performance.now() - this.#heard > longest) return opcuaMessages.silent(longest / 1000);
      // Frequent notifications confirm the values at rest, too.
      const isQuiet = performance.now() - this.#valued >= SILENT_MS && hasSilent();
      if (!isQuiet && performance.now() - looked < LOOK_MS) continue;
      looked = performance.now();
      let time: Nanoseconds | null = null;
      try {
        if (!isOver) time = (await clock.read()).received;
      } catch (error) {
        // Continues if the clock has stopped, because such a server still responds. The gateway receives this error when it reads the time.
        if (!isClockStopped(error)) return clockMessages.notReadable(requestTrouble(error as Error));
      }
      try {
        if (!isOver) await look(time);
      } catch (error) {
        return opcuaMessages.notReadable(requestTrouble(error as Error));
      }
    }
    return opcuaMessages.ended;
  }
}

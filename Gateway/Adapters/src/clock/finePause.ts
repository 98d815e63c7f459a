import { pause } from '../backoff';
import { monotonicTime, ofMilliseconds } from '../times';

/**
 * Resolves after a time of a few ms, or as soon as the signal is aborted. The timers of Windows have a step of 15.6 ms, so that a timer would hide
 * what a plant's clock does in between. There, this function lets the program continue without a timer, which uses the processor meanwhile.
 * @param counter Monotonic clock of this machine, ns.
 */
export async function finePause(ms: number, stop: AbortSignal, counter = monotonicTime): Promise<void> {
  if (process.platform !== 'win32') return pause(ms, stop);
  const due = counter() + ofMilliseconds(ms);
  while (!stop.aborted && counter() < due) await new Promise(setImmediate);
}

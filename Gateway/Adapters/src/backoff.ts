const FIRST_MS = 200;
const MAX_MS = 1500;
const VARIATION = 0.2;

/**
 * Delays between connection attempts: 0.2 s, doubled up to 1.5 s. A random variation of ±20 % prevents many clients from connecting at the
 * same time.
 */
export class Backoff {
  #next = FIRST_MS;

  constructor(readonly random: () => number = Math.random) {}

  next(): number {
    const wait = this.#next;
    this.#next = Math.min(2 * wait, MAX_MS);
    return wait * (1 + VARIATION * (2 * this.random() - 1));
  }

  reset(): void {
    this.#next = FIRST_MS;
  }
}

/** Resolves after a time in ms, or as soon as the signal is aborted. */
export function pause(ms: number, stop: AbortSignal): Promise<void> {
  return new Promise(resolve => {
    if (stop.aborted) return resolve();
    const end = (): void => {
      clearTimeout(timer);
      stop.removeEventListener('abort', end);
      resolve();
    };
    const timer = setTimeout(end, ms);
    stop.addEventListener('abort', end);
  });
}

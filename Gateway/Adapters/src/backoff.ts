const FIRST_MS = 200;
const MAX_MS = 1500;
const VARIATION = 0.2;

/** Maximum length of an attempt that does not reset the delays. */
const STEADY_MS = 2000;

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

/**
 * Connects, and connects again after each attempt, until the signal is aborted. Keeps the longer delay for a server that accepts connections and
 * closes them immediately.
 * @param attempt Connects, and resolves when the connection has ended or could not be established.
 * @param ended Called with the result of each attempt, unless the signal ended it.
 * @param again Called after each delay.
 */
export async function reconnecting<T>(
  stop: AbortSignal,
  attempt: () => Promise<T>,
  ended: (result: T) => void,
  again = (): void => {},
): Promise<void> {
  const backoff = new Backoff();
  while (!stop.aborted) {
    const began = performance.now();
    const result = await attempt();
    if (stop.aborted) return;
    ended(result);
    if (performance.now() - began > STEADY_MS) backoff.reset();
    await pause(backoff.next(), stop);
    again();
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

import { afterArrivals } from './sockets';

const FIRST_MS = 200;
const MAX_MS = 1500;
const VARIATION = 0.2;

/**
 * Limits of the delays after a refusal of user and password, because many servers lock the account after several attempts with a wrong password. With
 * the variation, the longest delay is 5 min.
 */
const LOGIN_FIRST_MS = 30_000;
const LOGIN_MAX_MS = 250_000;

/** Maximum length of an attempt that does not reset the delays. */
const STEADY_MS = 2000;

/**
 * Delays between connection attempts: 0.2 s, doubled up to 1.5 s. A random variation of ±20 % prevents many clients from connecting at the
 * same time.
 */
export class Backoff {
  #next: number;

  constructor(
    readonly random: () => number = Math.random,
    readonly firstMs = FIRST_MS,
    readonly maxMs = MAX_MS,
  ) {
    this.#next = firstMs;
  }

  next(): number {
    const wait = this.#next;
    this.#next = Math.min(2 * wait, this.maxMs);
    return wait * (1 + VARIATION * (2 * this.random() - 1));
  }

  reset(): void {
    this.#next = this.firstMs;
  }
}

/**
 * Connects, and connects again after each attempt, until the signal is aborted. Keeps the longer delay for a server that accepts connections and
 * closes them immediately.
 * @param attempt Connects, and resolves when the connection has ended or could not be established.
 * @param ended Called with the result of each attempt, unless the signal ended it.
 * @param again Called after each delay.
 * @param isLoginRefused Whether the server has refused user and password, so that the next attempt must wait longer.
 */
export async function reconnecting<T>(
  stop: AbortSignal,
  attempt: () => Promise<T>,
  ended: (result: T) => void,
  again = (): void => {},
  isLoginRefused: (result: T) => boolean = () => false,
): Promise<void> {
  const backoff = new Backoff();
  const logins = new Backoff(Math.random, LOGIN_FIRST_MS, LOGIN_MAX_MS);
  while (!stop.aborted) {
    const began = performance.now();
    const result = await attempt();
    if (stop.aborted) return;
    ended(result);
    if (performance.now() - began > STEADY_MS) backoff.reset();
    const isRefused = isLoginRefused(result);
    if (!isRefused) logins.reset();
    await pause((isRefused ? logins : backoff).next(), stop);
    again();
  }
}

/** Resolves after a time in ms and after the data that have arrived by then (`afterArrivals`), or as soon as the signal is aborted. */
export function pause(ms: number, stop: AbortSignal): Promise<void> {
  return new Promise(resolve => {
    if (stop.aborted) return resolve();
    const end = (): void => {
      cancel();
      stop.removeEventListener('abort', end);
      resolve();
    };
    const cancel = afterArrivals(ms, end);
    stop.addEventListener('abort', end);
  });
}

import type { Log } from '../log';
import { gatewayMessages } from '../messages/gateway';

/** Maximum number of stored status messages. */
const MAX_STATUSES = 32;

/**
 * Matches the status message of a gateway that does not know the clock of the stamps yet, for example because it is still measuring this clock. The
 * measurement takes up to MEASURING_MS.
 */
export const UNSYNCHRONISED = /\(Unsynchronised\)$/;
const MEASURING_MS = 20_000;

/** The status messages with which a gateway reports dropped messages. Logs equal ones only once per connection. */
export class StatusMessages {
  readonly #seen = new Set<string>();
  /** Time at which the gateway began to measure the offered clocks. */
  #measured = 0;

  /** @param name Name of the gateway or robot, for the log. */
  constructor(
    readonly name: string,
    readonly log: Log,
  ) {}

  /** Reports that the gateway begins to measure an offered clock. */
  offered(): void {
    this.#measured = performance.now();
  }

  /** Prepares for a new connection, on which the gateway also begins to measure the clocks. */
  opened(): void {
    this.offered();
    this.#seen.clear();
    this.log.forget(`${this.name} says`);
  }

  /** Whether a status is normal, because the gateway is still measuring the clock of the stamps. */
  isMeasuring(status: string): boolean {
    return UNSYNCHRONISED.test(status) && performance.now() - this.#measured < MEASURING_MS;
  }

  write(status: string): void {
    if (this.isMeasuring(status)) return this.log.change(`${this.name} measures`, 'measuring', gatewayMessages.measuring(this.name));
    if (this.#seen.has(status)) return;
    if (this.#seen.size >= MAX_STATUSES) this.#seen.clear();
    this.#seen.add(status);
    this.log.change(`${this.name} says`, status, `${this.name} says: ${status}`);
  }
}

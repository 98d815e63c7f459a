import { type Nanoseconds, NS_PER_MS, NS_PER_S, toMilliseconds } from '../times';
import { opcuaMessages } from '../messages/opcua';

/** Minimum length of a comparison, and minimum number of changes in it. */
const LENGTH: Nanoseconds = 5n * NS_PER_S;
const MIN_CHANGES = 10;

/** Maximum time by which a source timestamp may be later than the server's time stamp, for servers that round them differently. */
const MAX_AHEAD: Nanoseconds = 5n * NS_PER_MS;

/** Maximum difference of the server's time stamps from the clock that headsets use. A larger one shows that they are from another clock. */
const MAX_FROM_CLOCK: Nanoseconds = 2n * NS_PER_S;

/** Minimum age of the newest change at which the source is reported. Most servers sample their sources more often. */
const MIN_BEHIND: Nanoseconds = 50n * NS_PER_MS;

/**
 * Compares the source timestamps of changes with the server's time stamps of the same changes, which are times of the server's clock. If the
 * difference of all changes within a few seconds has the same sign, another clock may have stamped the source, but headsets use the server's clock.
 */
export class StampComparison {
  #changes = 0;
  #began: Nanoseconds | null = null;
  /** Ages of the youngest and the oldest change: the server's time stamp minus the source timestamp. */
  #youngest: Nanoseconds = 0n;
  #oldest: Nanoseconds = 0n;

  /** @param report Called after each comparison with the text for the user, or with null if the time stamps agree. */
  constructor(readonly report: (text: string | null) => void) {}

  /** @param now Approximate time of the clock that headsets use; null while it is unknown. */
  add(source: Nanoseconds | null, server: Nanoseconds | null, now: Nanoseconds | null): void {
    if (source === null || server === null || now === null || now - server > MAX_FROM_CLOCK || server - now > MAX_FROM_CLOCK) return;
    const age = server - source;
    if (this.#began === null || server < this.#began) this.#restart(server, age);
    this.#changes++;
    if (age < this.#youngest) this.#youngest = age;
    if (age > this.#oldest) this.#oldest = age;
    if (this.#changes < MIN_CHANGES || server - this.#began! < LENGTH) return;
    this.report(this.#text);
    this.#began = null;
  }

  #restart(server: Nanoseconds, age: Nanoseconds): void {
    [this.#began, this.#changes, this.#youngest, this.#oldest] = [server, 0, age, age];
  }

  get #text(): string | null {
    if (this.#oldest < -MAX_AHEAD) return opcuaMessages.stampsAhead(toMilliseconds(-this.#oldest));
    return this.#youngest > MIN_BEHIND ? opcuaMessages.stampsBehind(toMilliseconds(this.#youngest)) : null;
  }
}

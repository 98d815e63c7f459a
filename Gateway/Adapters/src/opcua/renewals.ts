import type { SourceStop } from '../samples/jointOutput';
import type { Nanoseconds } from '../times';

/** Number of renewals of a node at rest after which it is known that its source writes it periodically. */
const MIN_RENEWALS = 3;

/**
 * Time without a change of any node, in ms, after which renewals show that the source also writes at rest. Some sources write all values when one
 * changes, and nothing when all rest.
 */
const QUIET_MS = 1000;

/** A source has stopped writing a node after this time, in ms, and this multiple of the longest observed interval. */
const STOPPED_MS = 1200;
const INTERVALS = 3;

interface Node {
  /** Source timestamp of the last value; null before the first. */
  stamp: Nanoseconds | null;
  /** Time at which this stamp was first seen. */
  changedAt: number;
  renewals: number;
  /** Whether it was renewed since its value changed. */
  isRenewed: boolean;
  longestMs: number;
}

/**
 * Source timestamps of nodes whose value does not change. Many sources write their values periodically, even at rest: a notification or a
 * read then has the same value with a newer source timestamp. If such a source stops writing, its data have ended.
 * @remarks A server that stamps each read renews all nodes forever. Renewals therefore do not prove that the source works.
 */
export class Renewals {
  readonly #nodes: Node[];
  #lastChange = -Infinity;

  /** @param now Monotonic time in ms. */
  constructor(
    nodes: number,
    readonly now: () => number,
  ) {
    this.#nodes = Array.from({ length: nodes }, () => ({ stamp: null, changedAt: now(), renewals: 0, isRenewed: false, longestMs: 0 }));
  }

  /** Reports the source timestamp of a new value. */
  changed(node: number, stamp: Nanoseconds | null): void {
    this.#lastChange = this.now();
    this.#set(node, stamp, false);
  }

  /**
   * Reports the source timestamp of a value that did not change. Returns whether the source has written it again.
   * @param isInFault Whether the source is known to have stopped. Otherwise even a long interval counts as normal.
   */
  unchanged(node: number, stamp: Nanoseconds | null, isInFault = false): boolean {
    const known = this.#nodes[node];
    const interval = this.now() - known.changedAt;
    if (stamp === null || (known.stamp !== null && stamp <= known.stamp)) return false;
    const isFirst = known.stamp === null;
    const isQuiet = this.now() - this.#lastChange > QUIET_MS;
    if (!isFirst && !isInFault) known.longestMs = Math.max(known.longestMs, interval);
    if (!isFirst && isQuiet) known.renewals++;
    this.#set(node, stamp, !isFirst);
    return !isFirst;
  }

  /** Returns when a source that wrote the node periodically at rest stopped writing it; null if it still writes, or if this is unknown. */
  stopOf(node: number): SourceStop | null {
    const { changedAt, renewals, isRenewed, longestMs } = this.#nodes[node];
    if (renewals < MIN_RENEWALS || this.now() - changedAt <= Math.max(STOPPED_MS, INTERVALS * longestMs)) return null;
    return isRenewed ? 'at-rest' : 'after-change';
  }

  #set(node: number, stamp: Nanoseconds | null, isRenewed: boolean): void {
    Object.assign(this.#nodes[node], { stamp, changedAt: this.now(), isRenewed });
  }
}

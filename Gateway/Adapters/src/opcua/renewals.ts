import type { Nanoseconds } from '../times';

/** Number of renewals of a node at rest after which it is known that its source writes it periodically. */
const MIN_RENEWALS = 3;

/** A source has stopped writing a node after this time, in ms, and this multiple of the longest observed interval. */
const STOPPED_MS = 700, INTERVALS = 3;

interface Node {
  /** Source timestamp of the last value; null before the first. */
  stamp: Nanoseconds | null;
  /** Time at which this stamp was first seen. */
  changedAt: number;
  renewals: number;
  longestMs: number;
}

/**
 * Source timestamps of nodes whose value does not change. Many sources write their values periodically, also at rest: a notification or a
 * read then has the same value with a newer source timestamp. If such a source stops writing, its data have ended.
 * @remarks A server that stamps each read renews all nodes forever. Renewals therefore do not prove that the source works.
 */
export class Renewals {
  readonly #nodes: Node[];

  /** @param now Monotonic time in ms. */
  constructor(nodes: number, readonly now: () => number) {
    this.#nodes = Array.from({ length: nodes }, () => ({ stamp: null, changedAt: now(), renewals: 0, longestMs: 0 }));
  }

  /** Reports the source timestamp of a new value. */
  changed(node: number, stamp: Nanoseconds | null): void {
    Object.assign(this.#nodes[node], { stamp, changedAt: this.now() });
  }

  /** Reports the source timestamp of a value that did not change. Returns whether the source writes it again after it had stopped. */
  unchanged(node: number, stamp: Nanoseconds | null): boolean {
    const known = this.#nodes[node], interval = this.now() - known.changedAt;
    if (stamp === null || known.stamp !== null && stamp <= known.stamp) return false;
    const isFirst = known.stamp === null, wasStopped = this.hasStopped(node);
    if (!isFirst && !wasStopped) known.longestMs = Math.max(known.longestMs, interval);
    if (!isFirst) known.renewals++;
    this.changed(node, stamp);
    return wasStopped;
  }

  /** Whether the source wrote the node periodically at an earlier rest, and has not written it for a while. */
  hasStopped(node: number): boolean {
    const { changedAt, renewals, longestMs } = this.#nodes[node];
    return renewals >= MIN_RENEWALS && this.now() - changedAt > Math.max(STOPPED_MS, INTERVALS * longestMs);
  }
}

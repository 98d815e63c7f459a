import type { SourceStop } from '../samples/jointTrack';
import type { Nanoseconds } from '../times';

/** Minimum number of renewals of a node at rest after which its source counts as writing the node periodically. */
const MIN_RENEWALS = 3;

/**
 * Time in ms without a change of any node after which a renewal shows that the source also writes at rest. Some sources write all values when one
 * value changes, and none while all values are at rest.
 */
const QUIET_MS = 1000;

/**
 * A source is assumed to have stopped writing a node if the node was not renewed for the longer of STOPPED_MS and INTERVALS times the longest
 * observed interval.
 */
const STOPPED_MS = 1200;
const INTERVALS = 3;

interface Node {
  /** Source timestamp of the last value; null before the first. */
  stamp: Nanoseconds | null;
  /** Time at which this stamp was first seen. */
  changedAt: number;
  renewals: number;
  /** Whether the node was renewed after its last change. */
  isRenewed: boolean;
  longestMs: number;
}

/**
 * Watches the source timestamps of nodes whose values do not change. Many sources write their values periodically, even at rest. A notification or a
 * read then returns the same value with a newer source timestamp, which is called a renewal. If such a source stops writing, its data have ended.
 * @remarks Renewals do not prove that the source works, because some servers return a new stamp for each read request, which renews all nodes.
 */
export class Renewals {
  readonly #nodes: Node[];
  #lastChange = -Infinity;

  /** @param now Monotonic clock in ms. */
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
   * Reports the source timestamp of an unchanged value. Returns whether the source has written the value again.
   * @param isInFault Whether the source is known to have stopped, so that the interval until this value is not a normal one.
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

  /**
   * Gets the phase in which the source stopped writing a node: at rest or directly after a change. Returns null if the source still writes the node,
   * or if this is unknown because the source did not write the node periodically at rest.
   */
  stopOf(node: number): SourceStop | null {
    const { changedAt, renewals, isRenewed, longestMs } = this.#nodes[node];
    if (renewals < MIN_RENEWALS || this.now() - changedAt <= Math.max(STOPPED_MS, INTERVALS * longestMs)) return null;
    return isRenewed ? 'at-rest' : 'after-change';
  }

  #set(node: number, stamp: Nanoseconds | null, isRenewed: boolean): void {
    Object.assign(this.#nodes[node], { stamp, changedAt: this.now(), isRenewed });
  }
}

import type { Nanoseconds } from '../times';

/** A valid number and its time. */
export interface Sample {
  /** Index of the joint, or of the value from which a pose is computed. */
  index: number;
  /** The position of the joint in rad or m, or the number in the unit of the control system. */
  value: number;
  /** Velocity in rad/s or m/s; absent if the source does not provide it. */
  velocity?: number;
  stamp: Nanoseconds;
}

/** Samples with one common stamp. */
interface Group {
  /** Midpoint between the first and the last stamp of the samples. Its error is at most half the tolerance. */
  stamp: Nanoseconds;
  samples: Sample[];
}

/**
 * Groups the samples of each cycle of the control system, the oldest group first. The stamps in a group are within the tolerance, and each index
 * occurs at most once.
 */
export function grouped(samples: Sample[], tolerance: Nanoseconds): Group[] {
  const inOrder = [...samples].sort((a, b) => (a.stamp < b.stamp ? -1 : a.stamp > b.stamp ? 1 : a.index - b.index));
  const groups: Sample[][] = [];
  let indices = new Set<number>();
  for (const sample of inOrder) {
    const group = groups.at(-1);
    if (group !== undefined && sample.stamp - group[0].stamp <= tolerance && !indices.has(sample.index)) {
      group.push(sample);
    } else {
      groups.push([sample]);
      indices = new Set();
    }
    indices.add(sample.index);
  }
  return groups.map(group => ({ stamp: (group[0].stamp + group.at(-1)!.stamp) / 2n, samples: group }));
}

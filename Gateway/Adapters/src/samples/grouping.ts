import type { Nanoseconds } from '../times';

export interface Sample {
  joint: number;
  position: number;
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
 * Groups the samples of each cycle of the control system, the oldest group first. The stamps in a group are within the tolerance, and each joint
 * occurs at most once.
 */
export function grouped(samples: Sample[], tolerance: Nanoseconds): Group[] {
  const inOrder = [...samples].sort((a, b) => (a.stamp < b.stamp ? -1 : a.stamp > b.stamp ? 1 : a.joint - b.joint));
  const groups: Sample[][] = [];
  let joints = new Set<number>();
  for (const sample of inOrder) {
    const group = groups.at(-1);
    if (group !== undefined && sample.stamp - group[0].stamp <= tolerance && !joints.has(sample.joint)) {
      group.push(sample);
    } else {
      groups.push([sample]);
      joints = new Set();
    }
    joints.add(sample.joint);
  }
  return groups.map(group => ({ stamp: (group[0].stamp + group.at(-1)!.stamp) / 2n, samples: group }));
}

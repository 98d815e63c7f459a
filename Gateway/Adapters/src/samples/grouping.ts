import type { Nanoseconds } from '../times';

export interface Sample {
  joint: number;
  position: number;
  /** rad/s or m/s; absent if the source does not provide it. */
  velocity?: number;
  stamp: Nanoseconds;
}

/** Samples that count as simultaneous. */
export interface Group {
  /** The middle of the first and the last stamp, so that the error is at most half the tolerance. */
  stamp: Nanoseconds;
  samples: Sample[];
}

/**
 * Groups the samples of each cycle of the control system, oldest first: those whose stamps are within the tolerance, each joint once.
 * A group may have a single joint.
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

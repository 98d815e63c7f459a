import type { Nanoseconds } from '../times';

export interface Sample {
  joint: number;
  position: number;
  /** rad/s or m/s; left out where the source does not tell it. */
  velocity?: number;
  stamp: Nanoseconds;
}

/** Samples that count as taken at one moment. */
export interface Group {
  /** The middle of the first and the last stamp, so that none is wrong by more than half the tolerance. */
  stamp: Nanoseconds;
  samples: Sample[];
}

/**
 * Puts together what belongs to one cycle of the control system, oldest first: samples whose stamps lie within the tolerance, each joint
 * once. A joint that is alone goes alone.
 */
export function grouped(samples: Sample[], tolerance: Nanoseconds): Group[] {
  const inOrder = [...samples].sort((a, b) => a.stamp < b.stamp ? -1 : a.stamp > b.stamp ? 1 : a.joint - b.joint);
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

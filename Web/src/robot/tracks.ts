import { JointTrack } from './track';

/** As many as a message may carry, twice: a robot that takes another's place finds room. */
const GREATEST_JOINTS = 512;

/** Where all joints are at one time. */
export interface Pose {
  names: string[];
  positions: number[];
}

/** A robot's joints over time. A message may carry any of them, now these and now those: each joint keeps its own history. */
export class JointTracks {
  private readonly tracks = new Map<string, JointTrack>();

  /** @param keep As of {@link JointTrack}. */
  constructor(private readonly keep = Infinity) {}

  /** Of the joint that spoke last. */
  get last(): number | undefined {
    let last: number | undefined;
    for (const track of this.tracks.values()) if (last === undefined || track.last! > last) last = track.last;
    return last;
  }

  add(time: number, names: string[], positions: ArrayLike<number>): void {
    names.forEach((name, i) => {
      if (Number.isFinite(positions[i])) this.trackOf(name).add(time, positions[i]);
    });
  }

  /** Between samples; joints that have not spoken since stay where they were. Null before any has. */
  at(time: number): Pose | null {
    return this.pose(track => track.at(time));
  }

  /** As shown without compensation: the newest samples at or before a time. */
  heldAt(time: number): Pose | null {
    return this.pose(track => track.heldAt(time));
  }

  private trackOf(name: string): JointTrack {
    let track = this.tracks.get(name);
    if (track) return track;
    if (this.tracks.size >= GREATEST_JOINTS) this.tracks.delete(this.oldest());
    this.tracks.set(name, track = new JointTrack(this.keep));
    return track;
  }

  private oldest(): string {
    return [...this.tracks].reduce((a, b) => (a[1].last! <= b[1].last! ? a : b))[0];
  }

  private pose(of: (track: JointTrack) => number | null): Pose | null {
    const pose: Pose = { names: [], positions: [] };
    for (const [name, track] of this.tracks) {
      const position = of(track);
      if (position === null) continue;
      pose.names.push(name);
      pose.positions.push(position);
    }
    return pose.names.length === 0 ? null : pose;
  }
}

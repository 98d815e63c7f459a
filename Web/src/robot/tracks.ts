import { JointTrack } from './track';

/** Maximum number of joints: twice that of a message, so that the joints of a robot that replaces another fit. */
const MAX_JOINTS = 512;

/** Positions of all joints at one time. */
export interface Pose {
  names: string[];
  positions: number[];
}

/** A robot's joint positions over time. Each joint has its own history, because each message may contain any subset of the joints. */
export class JointTracks {
  private readonly tracks = new Map<string, JointTrack>();

  /** @param keep Length of the kept history in seconds, see {@link JointTrack}. */
  constructor(private readonly keep = Infinity) {}

  /** Time of the newest sample of any joint. */
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

  /** Interpolates between samples. A joint without a newer sample keeps its last position. Null before the first sample. */
  at(time: number): Pose | null {
    return this.pose(track => track.at(time));
  }

  /** Returns the newest samples at or before a time, which are shown without compensation. */
  heldAt(time: number): Pose | null {
    return this.pose(track => track.heldAt(time));
  }

  private trackOf(name: string): JointTrack {
    let track = this.tracks.get(name);
    if (track) return track;
    if (this.tracks.size >= MAX_JOINTS) this.tracks.delete(this.oldest());
    this.tracks.set(name, (track = new JointTrack(this.keep)));
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

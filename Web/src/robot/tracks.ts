import { type Place, Track } from './track';

/** Maximum number of joints: twice the maximum in a message, so that the joints of a second robot fit, too. */
const MAX_JOINTS = 512;

/**
 * Interval between two samples of a joint, in seconds, above which its true position between them is unknown unless it rests. The gateway's limit is
 * the same.
 */
const MAX_GAP = 1.8;

/** Time for which a joint moves that is at rest until its next sample, in seconds. */
const START = 0.001;

/** Positions of all joints at one time. */
export interface Pose {
  names: string[];
  positions: number[];
}

/** Joint positions of a robot over time. Each joint has its own history, because a message can contain any subset of the joints. */
export class JointTracks {
  private readonly tracks = new Map<string, Track<number>>();

  /**
   * @param keep Length of the stored history in seconds.
   * @param isAtRest Returns whether a joint without new samples is known to stay at its position.
   * @param maxGap Interval between two samples, in seconds, above which the position between them is unknown.
   */
  constructor(
    private readonly keep: number,
    private readonly isAtRest: (joint: string) => boolean = () => false,
    private readonly maxGap = MAX_GAP,
  ) {}

  /** Returns whether the samples of one of the joints end before a time, except those of joints at rest and of joints without samples. */
  endBefore(time: number, joints: string[]): boolean {
    return joints.some(name => !this.isAtRest(name) && this.tracks.has(name) && this.tracks.get(name)!.last! < time);
  }

  add(time: number, names: string[], positions: ArrayLike<number>): void {
    names.forEach((name, i) => {
      if (!Number.isFinite(positions[i])) return;
      const track = this.trackOf(name);
      const rest = track.at(Infinity);
      if (rest && time - rest.toTime > this.maxGap && this.isAtRest(name)) track.add(time - START, rest.to);
      track.add(time, positions[i]);
    });
  }

  clear(): void {
    this.tracks.clear();
  }

  /** Whether the history contains a sample of the joint. */
  has(joint: string): boolean {
    return this.tracks.has(joint);
  }

  /**
   * Interpolates between samples. After its last sample, a joint keeps its position while it is at rest, otherwise for as long as a gap between two
   * samples may last. Without the joints that have no data at this time: before their first sample, in a longer gap between two samples with different
   * positions, and later after their last sample. Null if no joint has data.
   */
  at(time: number): Pose | null {
    return this.pose(time, ({ from, to, share }) => from + share * (to - from));
  }

  /** Returns the last positions up to a time, as displayed without compensation, of the joints that have data at this time. */
  heldAt(time: number): Pose | null {
    return this.pose(time, ({ from }) => from);
  }

  private trackOf(name: string): Track<number> {
    let track = this.tracks.get(name);
    if (track) return track;
    if (this.tracks.size >= MAX_JOINTS) this.tracks.delete(this.oldest());
    this.tracks.set(name, (track = new Track(this.keep)));
    return track;
  }

  private oldest(): string {
    return [...this.tracks].reduce((a, b) => (a[1].last! <= b[1].last! ? a : b))[0];
  }

  private pose(time: number, of: (place: Place<number>) => number): Pose | null {
    const pose: Pose = { names: [], positions: [] };
    for (const [name, track] of this.tracks) {
      const place = track.at(time);
      if (!place || (time > place.fromTime && place.toTime - place.fromTime > this.maxGap && place.from !== place.to)) continue;
      if (time - place.toTime > this.maxGap && !this.isAtRest(name)) continue;
      pose.names.push(name);
      pose.positions.push(of(place));
    }
    return pose.names.length === 0 ? null : pose;
  }
}

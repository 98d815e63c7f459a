import { AxesHelper, type Box3, Group, Matrix4, Quaternion, Vector3 } from 'three';
import { Track } from './track';

/** Length of a drawn axis, m. */
const AXES = 0.05;

/** Limits of the protocol: maximum depth of the tree of frames, and maximum number of frames. The gateway rejects what exceeds them. */
const MAX_DEPTH = 16;
const MAX_FRAMES = 256;

/** Maximum age at which a pose is still drawn, s. */
const MAX_AGE = 1;

/** Age at which a moving frame is removed before a stationary one if there are too many, s. */
const SILENT_S = 3;

/** Length of the stored history, s: more than the delay of the display and the time by which a stamp may be in the future. */
const KEEP_S = 2;

/** Maximum distance from the world's origin of a frame that the camera includes, m: a frame at a wrong position must not hide the cell. */
const MAX_DISTANCE = 100;

const ONE = new Vector3(1, 1, 1);

interface Sample {
  parent: string;
  position: Vector3;
  rotation: Quaternion;
  isStationary: boolean;
}

interface Frame {
  samples: Track<Sample>;
  axes: AxesHelper;
}

/** A received transform with the fields of a ROS message. */
interface Transform {
  header: { stamp: { sec: number; nanosec: number }; frame_id: string };
  child_frame_id: string;
  transform: { translation: { x: number; y: number; z: number }; rotation: { x: number; y: number; z: number; w: number } };
}

/** Draws the frames of the cell as axes: x red, y green, z blue. */
export class Frames {
  readonly group = new Group();
  /** The stationary frames among them are in the order of their arrival. */
  private readonly frames = new Map<string, Frame>();
  private listed = new Set<string>();

  /** @param sampled Called with the time stamp of each pose of a moving frame. */
  constructor(private readonly sampled: (stamp: number) => void = () => {}) {}

  /** @param text A message on /tf or /tf_static. An invalid message is ignored. */
  take(text: string, isStationary: boolean): void {
    let transforms: Transform[];
    try {
      transforms = JSON.parse(text).msg.transforms;
      for (const transform of transforms) this.add(transform, isStationary);
    } catch {
      // Ignores a message that cannot be read. The gateway has checked it, so it has a format that this page does not support.
    }
  }

  /** @param names All frames of the gateway, also those without a pose that the gateway could send to this page. */
  setListed(names: string[]): void {
    this.listed = new Set(names);
  }

  /** Removes all frames. */
  clear(): void {
    for (const name of [...this.frames.keys()]) this.remove(name);
  }

  /**
   * Moves the axes to their poses at a given time. Hides frames without a known parent or without a recent pose.
   * @param time Control time in seconds; -Infinity shows only the stationary frames.
   * @param linkOf Returns the pose of a robot's link in the world; null for an unknown link.
   */
  pose(time: number, linkOf: (name: string) => Matrix4 | null): void {
    for (const [name, frame] of this.frames) {
      const world = this.worldOf(name, time, linkOf, 0);
      frame.axes.visible = world !== null;
      if (world) world.decompose(frame.axes.position, frame.axes.quaternion, frame.axes.scale);
    }
  }

  /** Returns the pose of a frame in the world; null if the pose is unknown at that time, and the identity if the gateway has no frame of this name. */
  baseAt(name: string, time: number, linkOf: (name: string) => Matrix4 | null): Matrix4 | null {
    return this.frames.has(name) || this.listed.has(name) ? this.worldOf(name, time, linkOf, 0) : new Matrix4();
  }

  addTo(box: Box3): void {
    for (const { axes } of this.frames.values()) if (axes.visible && axes.position.length() <= MAX_DISTANCE) box.expandByObject(axes);
  }

  private add({ header, child_frame_id, transform }: Transform, isStationary: boolean): void {
    const { translation: t, rotation: q } = transform;
    // A stationary pose applies to all times. Its stamp may be 0.
    const time = isStationary ? -Infinity : header.stamp.sec + header.stamp.nanosec / 1e9;
    const position = new Vector3(t.x, t.y, t.z);
    const rotation = new Quaternion(q.x, q.y, q.z, q.w);
    const frame = this.frameOf(child_frame_id, time);
    if (isStationary) {
      frame.samples.clear();
      this.frames.delete(child_frame_id);
      this.frames.set(child_frame_id, frame);
    } else this.sampled(time);
    frame.samples.add(time, { parent: header.frame_id, position, rotation, isStationary });
  }

  private frameOf(name: string, time: number): Frame {
    let frame = this.frames.get(name);
    if (frame) return frame;
    if (this.frames.size >= MAX_FRAMES) this.removeOldest(time);
    frame = { samples: new Track(KEEP_S), axes: new AxesHelper(AXES) };
    this.frames.set(name, frame);
    this.group.add(frame.axes);
    return frame;
  }

  // Removes a frame, because the gateway accepts a new one only after the end of another one: the moving frame with the oldest pose if it is silent,
  // otherwise the stationary frame that arrived first.
  private removeOldest(time: number): void {
    const lastOf = (name: string) => this.frames.get(name)!.samples.last!;
    const names = [...this.frames.keys()];
    const stationary = names.find(name => lastOf(name) === -Infinity);
    const moving = names.filter(name => lastOf(name) !== -Infinity).sort((a, b) => lastOf(a) - lastOf(b));
    const newest = Math.max(time, ...moving.slice(-1).map(lastOf));
    const isSilent = moving.length > 0 && newest - lastOf(moving[0]) > SILENT_S;
    this.remove(isSilent || stationary === undefined ? moving[0] : stationary);
  }

  private remove(name: string): void {
    const { axes } = this.frames.get(name)!;
    this.frames.delete(name);
    this.group.remove(axes);
    axes.dispose();
  }

  private worldOf(name: string, time: number, linkOf: (name: string) => Matrix4 | null, depth: number): Matrix4 | null {
    if (name === 'world') return new Matrix4();
    const frame = this.frames.get(name);
    if (!frame) return null;
    const sample = sampleAt(frame.samples, time);
    if (!sample || depth >= MAX_DEPTH) return null;
    // A link is drawn with its robot, even if a source publishes its pose too.
    const parent = linkOf(sample.parent) ?? this.worldOf(sample.parent, time, linkOf, depth + 1);
    return parent && parent.clone().multiply(new Matrix4().compose(sample.position, sample.rotation, ONE));
  }
}

// Interpolates between two samples with the same parent. Otherwise, the earlier sample applies until the later one, and the last sample for a limited
// time.
function sampleAt(samples: Track<Sample>, time: number): Sample | null {
  const place = samples.at(time);
  if (!place) return null;
  const { from, to, share } = place;
  if (from.isStationary) return from;
  if (time - samples.last! > MAX_AGE) return null;
  if (from.parent !== to.parent) return from;
  return { ...from, position: from.position.clone().lerp(to.position, share), rotation: from.rotation.clone().slerp(to.rotation, share) };
}

import { AxesHelper, type Box3, Group, LineBasicMaterial, Matrix4, Quaternion, Vector3 } from 'three';
import { frameStates } from '../messages/robot';
import { MAX_DISTANCE_M } from './camera';
import type { Label } from './labels';
import { Track } from './track';

/** Length of a drawn axis, m. */
const AXES = 0.05;

/** Limits of the protocol: maximum depth of the tree of frames, and maximum number of frames. The gateway rejects what exceeds them. */
const MAX_DEPTH = 16;
const MAX_FRAMES = 256;

/** Maximum age of a current pose, s. */
const MAX_AGE = 1;

/** Maximum number of frames that the text about frames without a pose lists. */
const MAX_NAMES = 8;

/** Age at which a moving frame is removed before a stationary one if there are too many, s. */
const SILENT_S = 3;

/** Length of the stored history, s: more than the delay of the display and the time by which a stamp may be in the future. */
const KEEP_S = 2;

const ONE = new Vector3(1, 1, 1);

/** Looks of the axes. The grey of axes whose pose is not current has a contrast of 3.5:1 to the light background and of 4.7:1 to the dark one. */
const CURRENT = new LineBasicMaterial({ vertexColors: true, toneMapped: false });
const NOT_CURRENT = new LineBasicMaterial({ color: 0x808a94, toneMapped: false });

interface Sample {
  parent: string;
  position: Vector3;
  rotation: Quaternion;
  isStationary: boolean;
}

interface Frame {
  samples: Track<Sample>;
  axes: AxesHelper;
  /** Control time for which the axes were last placed, s; null before the first pose. */
  placedAt: number | null;
  /** State if the pose is not current; null if it is current. */
  state: string | null;
  /** Whether the gateway has listed the frame. */
  wasListed: boolean;
}

/** State of each frame according to the gateway; null if the pose is current. */
type FrameStates = Map<string, string | null>;

/** A received transform with the fields of a ROS message. */
interface Transform {
  header: { stamp: { sec: number; nanosec: number }; frame_id: string };
  child_frame_id: string;
  transform: { translation: { x: number; y: number; z: number }; rotation: { x: number; y: number; z: number; w: number } };
}

/**
 * Draws the frames of the cell as axes: x red, y green, z blue. A frame whose pose is not current stays at its last pose, with grey axes and its state
 * in its label.
 */
export class Frames {
  readonly group = new Group();
  /** The stationary frames among them are in the order of their arrival. */
  private readonly frames = new Map<string, Frame>();
  /** Frames of the gateway; null before the first list. */
  private listed: FrameStates | null = null;

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

  /** @param listed All frames of the gateway, also those without a pose that the gateway could send to this page. */
  setListed(listed: FrameStates): void {
    this.listed = listed;
    for (const [name, frame] of this.frames) frame.wasListed ||= listed.has(name);
  }

  /** Removes all frames. */
  clear(): void {
    for (const name of [...this.frames.keys()]) this.remove(name);
  }

  /**
   * Moves the axes to their poses at a given time. Axes without a current pose do not move.
   * @param time Control time in seconds; -Infinity shows only the stationary frames.
   * @param linkOf Returns the pose of a robot's link in the world; null for an unknown link.
   */
  pose(time: number, linkOf: (name: string) => Matrix4 | null): void {
    for (const [name, frame] of this.frames) {
      const current = this.worldOf(name, time, linkOf);
      const isSilent = sampleAt(frame.samples, time) === null;
      // While the page is in the background, it draws nothing but receives poses. One of them can be newer than the pose that was drawn last.
      const hasNewer = isSilent && (frame.samples.at(time)?.fromTime ?? -Infinity) > (frame.placedAt ?? -Infinity);
      const world = current ?? (hasNewer ? this.worldOf(name, time, linkOf, Infinity) : null);
      if (world) {
        world.decompose(frame.axes.position, frame.axes.quaternion, frame.axes.scale);
        frame.placedAt = time;
      }
      const own = current ? null : isSilent ? frameStates.stale : frameStates.parentStale;
      frame.state = this.listed?.get(name) ?? own;
      frame.axes.material = frame.state === null ? CURRENT : NOT_CURRENT;
      frame.axes.visible = frame.placedAt !== null && this.exists(name, frame, current !== null);
    }
  }

  /** Returns the labels of the drawn frames. */
  labels(): Label[] {
    return [...this.frames].filter(([, { axes }]) => axes.visible).map(([name, { axes, state }]) => ({ name, state, at: axes.position }));
  }

  /** Returns the frames of the gateway that are not current and have no pose on this page, each with its state, and the number of those left out. */
  notDrawn(): { names: string[]; others: number } {
    const all = [...(this.listed ?? [])].filter(([name, state]) => state !== null && !this.frames.get(name)?.axes.visible);
    return { names: all.slice(0, MAX_NAMES).map(([name, state]) => `${name} (${state})`), others: Math.max(0, all.length - MAX_NAMES) };
  }

  /** Returns the pose of a frame in the world; null if the pose is unknown at that time, and the identity if the gateway has no frame of this name. */
  baseAt(name: string, time: number, linkOf: (name: string) => Matrix4 | null): Matrix4 | null {
    return this.frames.has(name) || this.listed?.has(name) ? this.worldOf(name, time, linkOf) : new Matrix4();
  }

  addTo(box: Box3): void {
    for (const { axes } of this.frames.values()) if (axes.visible && axes.position.length() <= MAX_DISTANCE_M) box.expandByObject(axes);
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
    }
    frame.samples.add(time, { parent: header.frame_id, position, rotation, isStationary });
  }

  private frameOf(name: string, time: number): Frame {
    let frame = this.frames.get(name);
    if (frame) return frame;
    if (this.frames.size >= MAX_FRAMES) this.removeOldest(time);
    const axes = new AxesHelper(AXES);
    axes.visible = false;
    frame = { samples: new Track(KEEP_S), axes, placedAt: null, state: null, wasListed: this.listed?.has(name) ?? false };
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
    axes.geometry.dispose();
  }

  // The gateway removes a frame from its list some time after the frame's source has ended. Its list may be a little older than a new frame.
  private exists(name: string, { wasListed }: Frame, isCurrent: boolean): boolean {
    return this.listed === null || this.listed.has(name) || (isCurrent && !wasListed);
  }

  /** @param maxAge Maximum age of the poses of the frame and of its parents, s. */
  private worldOf(name: string, time: number, linkOf: (name: string) => Matrix4 | null, maxAge = MAX_AGE, depth = 0): Matrix4 | null {
    if (name === 'world') return new Matrix4();
    const frame = this.frames.get(name);
    if (!frame) return null;
    const sample = sampleAt(frame.samples, time, maxAge);
    if (!sample || depth >= MAX_DEPTH) return null;
    // A link is drawn with its robot, even if a source publishes its pose too.
    const parent = linkOf(sample.parent) ?? this.worldOf(sample.parent, time, linkOf, maxAge, depth + 1);
    return parent && parent.clone().multiply(new Matrix4().compose(sample.position, sample.rotation, ONE));
  }
}

// Interpolates between two samples with the same parent. Before a sample with another parent, or after a gap, the earlier sample applies, but only for
// a limited time, like the last sample.
function sampleAt(samples: Track<Sample>, time: number, maxAge = MAX_AGE): Sample | null {
  const place = samples.at(time);
  if (!place) return null;
  const { from, to, fromTime, toTime, share } = place;
  if (from.isStationary) return from;
  if (time - fromTime > maxAge) return null;
  if (from.parent !== to.parent || toTime - fromTime > MAX_AGE) return from;
  return { ...from, position: from.position.clone().lerp(to.position, share), rotation: from.rotation.clone().slerp(to.rotation, share) };
}

import {
  Box3,
  type BufferAttribute,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  MeshPhongMaterial,
  type Object3D,
  Vector3,
} from 'three';
import { colour, type Ink } from '../theme';
import { MAX_DISTANCE_M } from './camera';
import type { Pose } from './tracks';
import { isDrawn, linkOf, movingJoints, paint, readUrdf, type Robot, setJoints, showKnown, toolJoints, toolPosition } from './urdf';

/** Poses of a robot that can be drawn together. */
export type Part = 'truth' | 'displayed' | 'hold';

/** The pose of each copy of a robot; null hides the copy. */
export type Poses = Record<Part, Pose | null>;

/** Style of each pose. Poses are drawn in ascending order of `place`, so the last one covers the others where they coincide. */
export const PARTS: Record<Part, { ink: Ink; opacity: number; place: number }> = {
  truth: { ink: '--truth', opacity: 1, place: 2 },
  displayed: { ink: '--compensated', opacity: 0.5, place: 1 },
  hold: { ink: '--hold', opacity: 0.35, place: 0 },
};

/** Moves faces away from the camera by an invisible distance: one pixel on a slope, and about 3 mm in depth if a robot of 1 m fills the picture. */
export const BACK = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 200 };

/** Several copies of one robot, each with its own colour and joint positions. */
export class Bodies {
  readonly group = new Group();
  readonly robots: Record<Part, Robot>;
  private readonly materials: Record<Part, MeshPhongMaterial>;
  private readonly bones: Record<Part, LineSegments> | null = null;
  private readonly points = { from: new Vector3(), to: new Vector3() };

  /** @throws Error if the text is not a valid URDF. */
  constructor(urdf: string) {
    const each = <T>(make: (part: Part) => T) => ({ truth: make('truth'), displayed: make('displayed'), hold: make('hold') });
    this.robots = each(() => readUrdf(urdf));
    this.materials = each(
      part =>
        new MeshPhongMaterial({
          transparent: PARTS[part].opacity < 1,
          opacity: PARTS[part].opacity,
          depthWrite: PARTS[part].opacity === 1,
          // Draws a coloured copy behind the grey robot: in front of it, a copy at the same position would look like a position error.
          ...(PARTS[part].opacity < 1 ? BACK : {}),
        }),
    );
    for (const part of Object.keys(PARTS) as Part[]) {
      paint(this.robots[part].root, this.materials[part], PARTS[part].place);
      this.robots[part].root.visible = false;
      this.group.add(this.robots[part].root);
    }
    if (this.robots.truth.meshes > 0) this.bones = each(part => this.boneOf(part));
    this.recolour();
  }

  /** Joints of the robot that need positions. */
  get joints(): string[] {
    return movingJoints(this.robots.truth);
  }

  /** Joints on which the position of the tool depends. */
  get toolJoints(): string[] {
    return toolJoints(this.robots.truth);
  }

  /** Name of the root link. A frame with this name moves the robot. */
  get rootName(): string {
    return this.robots.truth.root.urdfName;
  }

  /** @param base Pose of the root link in the world; null hides the robot. */
  place(base: Matrix4 | null): void {
    this.group.visible = base !== null;
    base?.decompose(this.group.position, this.group.quaternion, this.group.scale);
  }

  /** Hides the links below joints whose position is unknown. At the position 0, these links would look as if they had been measured. */
  showKnown(part: Part, isKnown: (joint: string) => boolean): void {
    showKnown(this.robots[part], isKnown);
  }

  /** @param positions Positions of the joints; null hides the copy. */
  pose(part: Part, names: string[], positions: ArrayLike<number> | null): void {
    this.robots[part].root.visible = positions !== null;
    if (positions) setJoints(this.robots[part], names, positions);
    if (this.bones) this.stretch(part);
  }

  /**
   * Shows the copies, without the links below joints whose position is unknown.
   * @param isCurrent Returns whether the newest true position of a joint is current.
   */
  show(poses: Poses, isCurrent: (joint: string) => boolean): void {
    for (const part of Object.keys(PARTS) as Part[]) {
      const received = new Set(poses[part]?.names);
      this.showKnown(part, joint => received.has(joint) && (part === 'displayed' || isCurrent(joint)));
      this.pose(part, poses[part]?.names ?? [], poses[part]?.positions ?? null);
    }
  }

  isShown(part: Part): boolean {
    return isDrawn(this.robots[part].root);
  }

  /** Returns whether the position of the tool is known. */
  isToolDrawn(part: Part): boolean {
    return isDrawn(this.robots[part].tool);
  }

  /** Extends a box so that it contains the visible copies. Leaves out a copy that is too far away, for example after positions in mm. */
  addTo(box: Box3): void {
    for (const part of Object.keys(PARTS) as Part[]) {
      if (!this.isShown(part)) continue;
      const own = new Box3().setFromObject(this.robots[part].root);
      // Not true for sizes in a description that are not finite.
      if (Math.max(own.min.length(), own.max.length()) <= MAX_DISTANCE_M) box.union(own);
    }
  }

  /** Returns the pose of a link in the world; null if the link does not exist or is not drawn. */
  linkOf(part: Part, name: string): Matrix4 | null {
    const link = linkOf(this.robots[part], name);
    if (!link || !isDrawn(link)) return null;
    this.group.updateMatrixWorld();
    return link.matrixWorld.clone();
  }

  /** Returns the distance between the tools of two copies, mm; null if one of them is not drawn. */
  distance(a: Part, b: Part): number | null {
    if (!isDrawn(this.robots[a].tool) || !isDrawn(this.robots[b].tool)) return null;
    return 1000 * toolPosition(this.robots[a], this.points.from).distanceTo(toolPosition(this.robots[b], this.points.to));
  }

  recolour(): void {
    for (const part of Object.keys(PARTS) as Part[]) {
      this.materials[part].color.set(colour(PARTS[part].ink));
      (this.bones?.[part].material as LineBasicMaterial | undefined)?.color.set(colour(PARTS[part].ink));
    }
  }

  /** Releases the graphics memory. The object cannot be used afterwards. */
  dispose(): void {
    this.group.traverse(object => (object as Partial<LineSegments>).geometry?.dispose());
    for (const part of Object.keys(PARTS) as Part[]) {
      this.materials[part].dispose();
      (this.bones?.[part].material as LineBasicMaterial | undefined)?.dispose();
    }
  }

  // Creates the lines between links that are drawn in place of meshes.
  private boneOf(part: Part): LineSegments {
    const ends = 2 * Object.keys(this.robots[part].root.joints).length;
    const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(3 * ends, 3));
    const bones = new LineSegments(geometry, new LineBasicMaterial());
    bones.frustumCulled = false;
    bones.renderOrder = PARTS[part].place;
    this.robots[part].root.add(bones);
    return bones;
  }

  private stretch(part: Part): void {
    const { root } = this.robots[part];
    const places = this.bones![part].geometry.getAttribute('position') as BufferAttribute;
    let at = 0;
    for (const joint of Object.values(root.joints)) {
      const link = joint.children.find(child => 'isURDFLink' in child);
      // If the position of the joint is unknown, the line has zero length.
      for (const end of [joint.parent!, isDrawn(joint) ? (link ?? joint) : joint.parent!] as Object3D[]) {
        const { x, y, z } = root.worldToLocal(end.getWorldPosition(this.points.from));
        places.setXYZ(at++, x, y, z);
      }
    }
    places.needsUpdate = true;
    this.bones![part].geometry.computeBoundingBox();
  }
}

import {
  type Box3,
  BoxGeometry,
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshPhongMaterial,
  Quaternion,
  Vector3,
} from 'three';
import type { ObjectsData } from '../data';
import { partLabels } from '../messages/robot';
import { colour } from '../theme';
import { BACK, type Part, PARTS } from './bodies';
import type { Label } from './labels';

/** Number of values per object: x, y, z in m and a unit quaternion with the scalar part last. */
const NUMBERS = 7;

const ALL = Object.keys(PARTS) as Part[];

/** Draws the workpieces of a cell, in the same colours as the robot's poses, and the belt and fixture that carry them. */
export class Objects {
  readonly group = new Group();
  private readonly cubes: Record<Part, Mesh[]>;
  private readonly materials: Record<Part, MeshPhongMaterial>;
  private readonly stands = new LineBasicMaterial();

  constructor(private readonly data: ObjectsData) {
    const shape = new BoxGeometry(data.size, data.size, data.size);
    const each = <T>(make: (part: Part) => T) => ({ truth: make('truth'), displayed: make('displayed'), hold: make('hold') });
    this.materials = each(
      part => new MeshPhongMaterial({ transparent: PARTS[part].opacity < 1, opacity: PARTS[part].opacity, ...(PARTS[part].opacity < 1 ? BACK : {}) }),
    );
    this.cubes = each(part =>
      data.names.map(() => {
        const cube = new Mesh(shape, this.materials[part]);
        cube.renderOrder = PARTS[part].place;
        this.group.add(cube);
        return cube;
      }),
    );
    this.group.add(lineOf(data.belt, this.stands), lineOf(squareAt(data.fixture, data.size), this.stands));
    this.recolour();
  }

  /** Names of the workpieces, of belt and fixture. */
  get names(): string[] {
    return [...this.data.names, partLabels.belt, partLabels.fixture];
  }

  /** @param poses Poses of all objects; null hides the objects. */
  pose(part: Part, poses: ArrayLike<number> | null): void {
    this.cubes[part].forEach((cube, i) => {
      cube.visible = poses !== null;
      if (poses) place(cube, poses, i);
    });
  }

  /** Returns the largest distance of an object between two sets of poses, mm. */
  largestDistance(a: ArrayLike<number>, b: ArrayLike<number>): number {
    return Math.max(...this.data.names.map((_, i) => 1000 * positionOf(a, i).distanceTo(positionOf(b, i))));
  }

  /** Returns the labels of the workpieces at their true poses, or at other poses if those are hidden, and of belt and fixture. */
  labels(): Label[] {
    const shown = ALL.map(part => this.cubes[part]).find(cubes => cubes.some(cube => cube.visible)) ?? [];
    const { belt, fixture } = this.data;
    const stands: [string, number[]][] = [
      [partLabels.belt, belt[belt.length >> 1]],
      [partLabels.fixture, fixture],
    ];
    return [
      ...shown.map((cube, i) => ({ name: this.data.names[i], state: null, at: cube.position })),
      ...stands.map(([name, at]) => ({ name, state: null, at: new Vector3(...at) })),
    ];
  }

  addTo(box: Box3): void {
    box.expandByObject(this.group);
  }

  recolour(): void {
    for (const part of ALL) this.materials[part].color = new Color(colour(PARTS[part].ink));
    this.stands.color = new Color(colour('--muted'));
  }
}

function place(cube: Mesh, poses: ArrayLike<number>, object: number): void {
  const at = NUMBERS * object;
  cube.position.copy(positionOf(poses, object));
  cube.quaternion.copy(new Quaternion(poses[at + 3], poses[at + 4], poses[at + 5], poses[at + 6]));
}

function positionOf(poses: ArrayLike<number>, object: number): Vector3 {
  const at = NUMBERS * object;
  return new Vector3(poses[at], poses[at + 1], poses[at + 2]);
}

function lineOf(points: number[][], material: LineBasicMaterial): Line {
  return new Line(new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points.flat(), 3)), material);
}

function squareAt([x, y, z]: number[], size: number): number[][] {
  return [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
    [-1, -1],
  ].map(([i, j]) => [x + i * size, y + j * size, z]);
}

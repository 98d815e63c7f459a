import { Box3, PerspectiveCamera, Vector3 } from 'three';

const STEP = Math.PI / 36;
const STEEPEST = 1.5;
const CLOSEST_M = 0.1;

/** Margin around the drawn objects, relative to their size. */
const ROOM = 0.03;

/** Maximum distance from the world's origin of what the camera includes, m: an object at a wrong position must not hide the cell. */
export const MAX_DISTANCE_M = 100;

/** Minimum distance of the far plane, m, and its ratio to the distance of the near plane. */
const MIN_FAR_M = 100;
const FAR_TO_NEAR = 10_000;

/** Box that is visible before the first object. */
const INITIAL = new Box3(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 1));

const START = { azimuth: -0.9, elevation: 0.4, zoom: 1 };

/** A camera that orbits the robot. Mouse, touch and keyboard control it. z points up. */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(35, 1);
  /** Box that must be visible from every direction. */
  private readonly framed = new Box3();
  private look = { ...START };
  private readonly fingers = new Map<number, PointerEvent>();

  /** @param changed Called after the camera has moved. */
  constructor(
    element: HTMLElement,
    private readonly changed: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    element.addEventListener('pointerdown', event => {
      this.fingers.set(event.pointerId, event);
      element.setPointerCapture(event.pointerId);
    });
    element.addEventListener('pointermove', event => this.drag(event));
    for (const end of ['pointerup', 'pointercancel'] as const) element.addEventListener(end, event => this.fingers.delete(event.pointerId));
    // Zooms only with Ctrl, so that scrolling the page does not stop at the robot.
    element.addEventListener(
      'wheel',
      event => {
        if (!event.ctrlKey) return;
        event.preventDefault();
        this.turn(0, 0, event.deltaY > 0 ? 1.1 : 1 / 1.1);
      },
      { passive: false },
    );
    element.addEventListener('dblclick', () => this.reset());
  }

  /** Moves the camera back until a box is visible, too. The boxes of earlier calls stay visible. */
  include(box: Box3): void {
    if (this.framed.containsBox(box)) return;
    // Adds a margin. Otherwise, the camera would move in each picture of a motion.
    this.framed.union(box.clone().expandByScalar(ROOM * box.getSize(new Vector3()).length()));
    this.place();
  }

  /** Releases the boxes of earlier calls, so that the camera may come closer. */
  release(): void {
    this.framed.makeEmpty();
  }

  /** Returns to the first direction, and to a distance at which the boxes of later calls are visible. */
  reset(): void {
    this.look = { ...START };
    this.release();
    this.place();
  }

  /**
   * Moves the camera if a key controls it.
   * @returns Whether the key controls the camera.
   */
  onKey(key: string): boolean {
    const turns: Record<string, () => void> = {
      ArrowLeft: () => this.turn(-STEP, 0, 1),
      ArrowRight: () => this.turn(STEP, 0, 1),
      ArrowUp: () => this.turn(0, STEP, 1),
      ArrowDown: () => this.turn(0, -STEP, 1),
      '+': () => this.turn(0, 0, 1 / 1.2),
      '=': () => this.turn(0, 0, 1 / 1.2),
      '-': () => this.turn(0, 0, 1.2),
      '0': () => this.reset(),
    };
    if (!(key in turns)) return false;
    turns[key]();
    return true;
  }

  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.place();
  }

  private drag(event: PointerEvent): void {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    this.fingers.set(event.pointerId, event);
    const other = [...this.fingers.values()].find(finger => finger !== event);
    if (other) this.turn(0, 0, distance(before, other) / distance(event, other));
    else this.turn((before.clientX - event.clientX) * 0.008, (event.clientY - before.clientY) * 0.008, 1);
  }

  private turn(azimuth: number, elevation: number, zoom: number): void {
    this.look.azimuth += azimuth;
    this.look.elevation = Math.min(STEEPEST, Math.max(-0.2, this.look.elevation + elevation));
    this.look.zoom = Math.min(4, Math.max(0.3, this.look.zoom * zoom));
    this.place();
  }

  private place(): void {
    const { azimuth, elevation, zoom } = this.look;
    const { camera } = this;
    const box = this.framed.isEmpty() ? INITIAL : this.framed;
    const centre = box.getCenter(new Vector3());
    camera.position.set(Math.cos(azimuth) * Math.cos(elevation), Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation)).add(centre);
    camera.lookAt(centre);
    const { x, y, z } = this.fitted(box, centre);
    camera.position.copy(new Vector3(x, y, zoom * z).applyQuaternion(camera.quaternion).add(centre));
    camera.far = Math.max(MIN_FAR_M, zoom * z + box.getSize(new Vector3()).length());
    camera.near = camera.far / FAR_TO_NEAR;
    camera.updateProjectionMatrix();
    this.changed();
  }

  // Returns the camera's position relative to the centre, in the camera's axes, at which all corners of the box are visible and centred.
  private fitted({ min, max }: Box3, centre: Vector3): Vector3 {
    const turned = this.camera.quaternion.clone().invert();
    const corners = [min.x, max.x].flatMap(x => [min.y, max.y].flatMap(y => [min.z, max.z].map(z => new Vector3(x, y, z))));
    for (const corner of corners) corner.sub(centre).applyQuaternion(turned);
    const high = Math.tan((this.camera.fov * Math.PI) / 360);
    const wide = high * this.camera.aspect;
    // A corner that is nearer to the camera appears farther from the centre of the picture.
    const extent = (axis: 'x' | 'y', sign: number, slope: number) => Math.max(...corners.map(corner => sign * corner[axis] + slope * corner.z));
    const [left, right, low, top] = [extent('x', -1, wide), extent('x', 1, wide), extent('y', -1, high), extent('y', 1, high)];
    return new Vector3((right - left) / 2, (top - low) / 2, Math.max(CLOSEST_M, (left + right) / (2 * wide), (low + top) / (2 * high)));
  }
}

/** Distance of two fingers in pixels, at least 1. */
function distance(a: PointerEvent, b: PointerEvent): number {
  return Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY));
}

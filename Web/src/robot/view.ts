import { AmbientLight, Box3, Color, DirectionalLight, GridHelper, type Group, type Mesh, Scene, WebGLRenderer } from 'three';
import { el } from '../dom';
import { robotLabels, robotMessages } from '../messages/robot';
import { colour, onColoursChanged } from '../theme';
import { Bodies } from './bodies';
import { OrbitCamera } from './camera';
import { type Label, Labels } from './labels';

const HEIGHT = 380;

/** Changes of a pose below this value, in m or rad, are not visible. */
const TOLERANCE = 1e-6;

/** Objects that are drawn together with the robot, in the same base frame. */
export interface Beside {
  group: Group;
  /** Extends a box so that it contains the visible objects. */
  addTo(box: Box3): void;
  /** Applies the colours of the page. */
  recolour?(): void;
  /** Returns the labels of the visible objects. */
  labels?(): Label[];
}

/** Draws a robot at its true, displayed and uncompensated poses. Without WebGL, shows a message; the joints are still updated. */
export class RobotView {
  readonly element: HTMLElement;
  private bodiesShown: Bodies | null = null;
  private readonly others: Beside[] = [];
  private readonly labels = new Labels();
  private readonly note = el('p', { class: 'missing', hidden: true });
  private readonly interruption = el('p', { class: 'missing', hidden: true }, robotMessages.interrupted);
  private readonly scene = new Scene();
  private floor: GridHelper | null = null;
  private readonly renderer: WebGLRenderer | null;
  private readonly orbit: OrbitCamera | null = null;
  private readonly canvas: HTMLCanvasElement;
  /** What the last picture shows. */
  private drawn: (number | string | null)[] = [];
  private isAsked = false;
  private isSeen = true;

  constructor(description: string) {
    this.canvas = el('canvas', { 'aria-hidden': 'true' });
    const stage = el(
      'div',
      { class: 'stage', tabindex: 0, role: 'group', 'aria-roledescription': robotLabels.view, 'aria-label': `${description} ${robotMessages.keys}` },
      this.canvas,
      this.labels.element,
    );
    this.element = el('div', { class: 'robot' }, stage, this.note, this.interruption);
    this.renderer = rendererOn(this.canvas);
    if (!this.renderer) {
      stage.remove();
      this.say(robotMessages.noWebGl);
      return;
    }
    this.orbit = new OrbitCamera(stage, () => this.ask());
    stage.addEventListener('keydown', event => {
      if (!event.ctrlKey && !event.metaKey && !event.altKey && this.orbit!.onKey(event.key)) event.preventDefault();
    });
    const sun = new DirectionalLight(0xffffff, 2);
    sun.position.set(1, -2, 3);
    this.scene.add(new AmbientLight(0xffffff, 1.6), sun);
    new ResizeObserver(() => this.fit()).observe(stage);
    // Pauses while the view is not visible, because rendering without a graphics card is slow.
    new IntersectionObserver(entries => {
      // Several changes can be reported together; the last one applies.
      this.isSeen = entries[entries.length - 1].isIntersecting;
      this.ask();
    }).observe(stage);
    this.canvas.addEventListener('webglcontextlost', () => (this.interruption.hidden = false));
    this.canvas.addEventListener('webglcontextrestored', () => {
      this.interruption.hidden = true;
      this.ask();
    });
    onColoursChanged(() => this.recolour());
    this.recolour();
  }

  /** Whether the view is in the window and can be drawn. */
  get isVisible(): boolean {
    return this.isSeen && this.renderer !== null;
  }

  /** The robot; null before a valid description was received. */
  get bodies(): Bodies | null {
    return this.bodiesShown;
  }

  /** Replaces the robot. If the URDF is invalid, shows a message and no robot. */
  describe(urdf: string): void {
    this.clear();
    try {
      this.bodiesShown = new Bodies(urdf);
    } catch (fault) {
      this.say(robotMessages.notShown(fault instanceof Error ? fault.message : String(fault)));
      return;
    }
    this.scene.add(this.bodiesShown.group);
    const { meshes } = this.bodiesShown.robots.truth;
    if (this.renderer && meshes > 0) this.say(robotMessages.meshesReplaced(meshes));
  }

  /** Removes the robot. */
  clear(): void {
    if (this.bodiesShown) this.scene.remove(this.bodiesShown.group);
    this.bodiesShown?.dispose();
    this.bodiesShown = null;
    if (this.renderer) this.say('');
    this.orbit?.release();
    this.ask();
  }

  /** Adds objects that are drawn together with the robot. */
  add(others: Beside): void {
    this.others.push(others);
    this.scene.add(others.group);
  }

  /** Requests a redraw in the next frame. Several calls cause one redraw. */
  ask(): void {
    if (this.isAsked || !this.isVisible) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      this.isAsked = false;
      this.draw();
    });
  }

  /**
   * Draws if an object has moved, appeared, disappeared or got another material since the last picture. A change of a material or a shape itself needs
   * `ask`.
   * @returns Whether the view has changed.
   */
  drawIfChanged(): boolean {
    if (this.isAsked || !this.isVisible) return this.isAsked;
    const current = this.appearance();
    const isSame = (value: number | string | null, former: number | string | null) =>
      value === former || (typeof value === 'number' && typeof former === 'number' && Math.abs(value - former) < TOLERANCE);
    const hasChanged = current.length !== this.drawn.length || !current.every((value, i) => isSame(value, this.drawn[i]));
    // A page in the background gets no frame, so the picture waits until the page is visible.
    if (hasChanged && document.hidden) this.ask();
    else if (hasChanged) this.draw(current);
    return hasChanged;
  }

  private draw(appearance = this.appearance()): void {
    this.widen();
    this.renderer!.render(this.scene, this.orbit!.camera);
    this.labels.show(this.labelled(), this.orbit!.camera);
    this.drawn = appearance;
  }

  private labelled(): Label[] {
    return this.others.flatMap(others => others.labels?.() ?? []);
  }

  // Returns the visible objects with their materials and poses, and the texts of the labels. Includes the links, because a robot that is drawn as lines
  // has no other objects that move.
  private appearance(): (number | string | null)[] {
    this.scene.updateMatrixWorld();
    const parts: (number | string | null)[] = this.labelled().flatMap(({ name, state }) => [name, state]);
    this.scene.traverseVisible(object => {
      const { material } = object as Partial<Mesh>;
      parts.push(object.id, material && !Array.isArray(material) ? material.id : null, ...object.matrixWorld.elements);
    });
    return parts;
  }

  private say(words: string): void {
    this.note.textContent = words;
    this.note.hidden = words === '';
  }

  // Moves the camera back when the robot leaves the area shown so far. The zero pose does not show how far the robot can reach.
  private widen(): void {
    const box = new Box3();
    this.bodiesShown?.addTo(box);
    for (const others of this.others) others.addTo(box);
    if (!box.isEmpty()) this.orbit!.include(box);
  }

  private recolour(): void {
    this.bodiesShown?.recolour();
    for (const others of this.others) others.recolour?.();
    this.scene.background = new Color(colour('--surface'));
    this.floor?.removeFromParent().dispose();
    this.floor = new GridHelper(4, 20, colour('--muted'), colour('--grid'));
    this.floor.rotation.x = Math.PI / 2;
    this.scene.add(this.floor);
    this.ask();
  }

  private fit(): void {
    const width = Math.floor(this.canvas.parentElement!.clientWidth);
    if (width === 0) return;
    this.renderer!.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer!.setSize(width, HEIGHT);
    this.labels.resize(width, HEIGHT);
    this.orbit!.setAspect(width / HEIGHT);
    // A canvas is empty after a change of its size.
    this.ask();
  }
}

// Checks for WebGL first, because without it the renderer writes an error to the console.
function rendererOn(canvas: HTMLCanvasElement): WebGLRenderer | null {
  const context = canvas.getContext('webgl2', { antialias: true });
  try {
    return context && new WebGLRenderer({ canvas, context });
  } catch {
    // The browser has created a context that is already lost.
    return null;
  }
}

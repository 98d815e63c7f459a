import { AmbientLight, Box3, Color, DirectionalLight, GridHelper, Scene, Vector3, WebGLRenderer } from 'three';
import { el } from '../dom';
import { colour, onColoursChanged } from '../theme';
import { Bodies } from './bodies';
import { OrbitCamera } from './camera';

const KEYS = 'Arrow keys turn the view, plus and minus zoom, 0 resets; or drag, and double-click.';
const HEIGHT = 380;

/** Around what is shown, as a share of its size. */
const ROOM = 0.03;

/** Draws one robot as it is, as it is displayed and as it would be held. Without WebGL it says so; the robots' joints go on all the same. */
export class RobotView {
  readonly element: HTMLElement;
  private bodiesShown: Bodies | null = null;
  private readonly note = el('p', { class: 'missing', hidden: true });
  private readonly scene = new Scene();
  private readonly renderer: WebGLRenderer | null;
  private readonly orbit: OrbitCamera | null = null;
  private readonly canvas: HTMLCanvasElement;
  /** What of the robot has been shown so far. */
  private readonly seen = new Box3();
  private isAsked = false;
  private isSeen = true;

  constructor(description: string) {
    this.canvas = el('canvas', { 'aria-hidden': 'true' });
    const stage = el('div', { class: 'stage', tabindex: 0, role: 'group', 'aria-roledescription': '3D view', 'aria-label': `${description} ${KEYS}` }, this.canvas);
    this.element = el('div', { class: 'robot' }, stage, this.note);
    this.renderer = rendererOn(this.canvas);
    if (!this.renderer) {
      stage.remove();
      this.say('This browser has no WebGL, so the robot is not drawn. Everything else on this page works.');
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
    // Where a processor draws, what nobody sees is dear.
    new IntersectionObserver(([entry]) => {
      this.isSeen = entry.isIntersecting;
      this.ask();
    }).observe(stage);
    onColoursChanged(() => this.recolour());
  }

  /** Null until there is a description that can be read. */
  get bodies(): Bodies | null { return this.bodiesShown; }

  /** Takes the place of the former robot. A text that is no URDF is said, and nothing is shown. */
  describe(urdf: string): void {
    if (this.bodiesShown) this.scene.remove(this.bodiesShown.group);
    this.bodiesShown?.dispose();
    this.bodiesShown = null;
    try {
      this.bodiesShown = new Bodies(urdf);
    } catch (fault) {
      this.say(`The robot cannot be shown: ${fault instanceof Error ? fault.message : fault}`);
      return;
    }
    this.scene.add(this.bodiesShown.group);
    const { meshes } = this.bodiesShown.robots.truth;
    if (this.renderer) this.say(meshes > 0 ? `Lines stand for ${meshes} ${meshes === 1 ? 'part' : 'parts'} of the robot whose meshes are not on this page.` : '');
    this.seen.makeEmpty();
    this.recolour();
  }

  /** Draws with the next frame, however often it is asked. */
  ask(): void {
    if (this.isAsked || !this.isSeen || !this.renderer) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      this.isAsked = false;
      this.widen();
      this.renderer!.render(this.scene, this.orbit!.camera);
    });
  }

  private say(words: string): void {
    this.note.textContent = words;
    this.note.hidden = words === '';
  }

  // Where all joints are zero tells little of where the robot will be: the camera steps back whenever it comes to where it has not been.
  private widen(): void {
    const box = new Box3();
    this.bodiesShown?.addTo(box);
    const size = box.getSize(new Vector3()).length();
    // A size in the description may be no number.
    if (box.isEmpty() || !Number.isFinite(size) || this.seen.containsBox(box)) return;
    // Somewhat more, or each picture of a movement would be another step.
    this.seen.union(box.expandByScalar(ROOM * size));
    this.orbit!.frame(this.seen);
  }

  private recolour(): void {
    this.bodiesShown?.recolour();
    this.scene.background = new Color(colour('--surface'));
    this.scene.children.filter(child => child instanceof GridHelper).forEach(grid => {
      this.scene.remove(grid);
      (grid as GridHelper).dispose();
    });
    const floor = new GridHelper(4, 20, colour('--muted'), colour('--grid'));
    floor.rotation.x = Math.PI / 2;
    this.scene.add(floor);
    this.ask();
  }

  private fit(): void {
    const width = Math.floor(this.canvas.parentElement!.clientWidth);
    if (width === 0) return;
    this.renderer!.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer!.setSize(width, HEIGHT);
    this.orbit!.setAspect(width / HEIGHT);
  }
}

// Asked first: the renderer complains on the console where there is none.
function rendererOn(canvas: HTMLCanvasElement): WebGLRenderer | null {
  const context = canvas.getContext('webgl2', { antialias: true });
  return context ? new WebGLRenderer({ canvas, context }) : null;
}

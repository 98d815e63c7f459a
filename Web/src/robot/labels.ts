import { type PerspectiveCamera, Vector3 } from 'three';
import { el } from '../dom';
import { robotMessages } from '../messages/robot';
import { LABEL_HEIGHT, type Spot, spotsOf, type Wanted } from './labelSpots';

/** The name of a frame or an object, shown beside a point of the view. */
export interface Label {
  name: string;
  /** State of the object if its pose is not current; null if the pose is current. */
  state: string | null;
  /** Point in the world, m. */
  at: Vector3;
}

/** Maximum number of labels. More would cover the picture, and each picture would take longer. */
const MAX_LABELS = 48;

/** Maximum number of characters of a name. A longer one loses its middle, because similar names differ at their ends. */
const MAX_LETTERS = 30;

interface Shown {
  element: HTMLElement;
  /** Width in px. */
  width: number;
  state: string | null;
  spot: number | null;
}

/** Shows labels over a 3D view. Uses elements of the page, so that they have its style and the 3D scene needs no text. */
export class Labels {
  /**
   * Hidden from screen readers, because other elements name the objects: on the operations page the table of objects, with the states of the gateway,
   * and in the report the description of the view.
   */
  readonly element: HTMLElement;
  /** Number of labels that do not fit, at the bottom of the view. Always has its height, which the labels leave free. */
  private readonly others = el('p', { class: 'others' });
  private readonly shown = new Map<string, Shown>();
  private size = { width: 0, height: 0 };

  constructor() {
    this.element = el('div', { class: 'labels', 'aria-hidden': 'true' }, this.others);
    this.count(0);
  }

  /** Sets the size of the picture, px. */
  resize(width: number, height: number): void {
    this.size = { width, height };
  }

  /** Shows the labels of the points in the picture. If there are too many, labels with a state come first, and then those in the previous picture. */
  show(labels: Label[], camera: PerspectiveCamera): void {
    const inPicture = labels.map(label => ({ label, ...this.pointOf(label, camera) })).filter(({ isInPicture }) => isInPicture);
    this.createFor(inPicture.map(({ label }) => label));
    const all = inPicture.map(({ label, x, y }) => ({ label, x, y, shown: this.shown.get(label.name)! }));
    const rank = ({ label, shown }: (typeof all)[0]) => (label.state !== null ? 0 : shown.spot !== null ? 1 : 2);
    all.sort((a, b) => rank(a) - rank(b));
    const wanted = all.map(({ x, y, shown }) => ({ x, y, width: shown.width, former: shown.spot }));
    const spots = spotsOf(wanted, { width: this.size.width, height: this.size.height - this.others.offsetHeight }, MAX_LABELS);
    all.forEach(({ shown }, i) => {
      const spot = spots[i];
      shown.spot = spot?.number ?? null;
      shown.element.style.visibility = spot ? 'visible' : 'hidden';
      if (spot) move(shown.element, spot, wanted[i]);
    });
    this.count(spots.filter(spot => spot === null).length);
  }

  private pointOf({ at }: Label, camera: PerspectiveCamera): { x: number; y: number; isInPicture: boolean } {
    const { x, y, z } = at.clone().project(camera);
    return {
      x: ((x + 1) / 2) * this.size.width,
      y: ((1 - y) / 2) * this.size.height,
      isInPicture: Math.abs(x) <= 1 && Math.abs(y) <= 1 && Math.abs(z) <= 1,
    };
  }

  // Creates all missing elements before it measures the first of them, because each alternation between the two would compute the layout again.
  private createFor(labels: Label[]): void {
    const kept = new Set(labels.map(({ name }) => name));
    for (const [name, { element }] of this.shown) {
      if (kept.has(name)) continue;
      element.remove();
      this.shown.delete(name);
    }
    const changed = labels.filter(({ name, state }) => this.shown.get(name)?.state !== state);
    for (const { name, state } of changed) {
      const former = this.shown.get(name);
      const element = elementOf(name, state);
      if (former) former.element.replaceWith(element);
      else this.element.append(element);
      this.shown.set(name, { element, state, width: 0, spot: former?.spot ?? null });
    }
    for (const { name } of changed) {
      const shown = this.shown.get(name)!;
      shown.width = shown.element.offsetWidth;
    }
  }

  private count(hidden: number): void {
    this.others.style.visibility = hidden === 0 ? 'hidden' : 'visible';
    const words = robotMessages.labelsHidden(hidden);
    if (this.others.textContent !== words) this.others.textContent = words;
  }
}

function elementOf(name: string, state: string | null): HTMLElement {
  const element = el(
    'span',
    { class: state === null ? 'label' : 'label old' },
    shortened(name),
    state === null ? null : el('span', { class: 'level warning' }, state),
  );
  element.style.height = element.style.lineHeight = `${LABEL_HEIGHT}px`;
  return element;
}

// Moves a label, and draws the line from the nearer one of its sides to its point.
function move({ style }: HTMLElement, { left, top }: Spot, { x, y, width }: Wanted): void {
  const side = left > x ? 0 : width;
  const [right, down] = [x - (left + side), y - (top + LABEL_HEIGHT / 2)];
  style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
  style.setProperty('--side', `${side}px`);
  style.setProperty('--length', `${Math.hypot(right, down)}px`);
  style.setProperty('--angle', `${Math.atan2(down, right)}rad`);
}

function shortened(name: string): string {
  const half = MAX_LETTERS / 2 - 1;
  return name.length <= MAX_LETTERS ? name : `${name.slice(0, half)}…${name.slice(-half)}`;
}

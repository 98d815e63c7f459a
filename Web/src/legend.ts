import { el, svg } from './dom';
import { term } from './terms';
import type { Look } from './traces';

interface LegendEntry {
  label: string;
  look: Look;
  /** Shows or hides the trace. Absent if the trace cannot be hidden. */
  toggle?: (shown: boolean) => void;
}

/** Legend of a plot. It names the traces, shows or hides them, and displays their values at the cursor. */
export class Legend {
  readonly element: HTMLElement;
  private readonly values: HTMLElement[];
  private readonly position = el('span', { class: 'position' });

  constructor(entries: LegendEntry[]) {
    this.values = entries.map(() => el('span', { class: 'value' }));
    const items = entries.map((entry, i) => el('li', {}, switchOf(entry), this.values[i]));
    this.element = el('div', { class: 'legend' }, el('ul', {}, ...items), this.position);
  }

  show(position: string, values: string[] = []): void {
    this.position.textContent = position;
    this.values.forEach((element, i) => {
      element.textContent = values[i] ?? '';
    });
  }
}

function switchOf(entry: LegendEntry): HTMLElement {
  if (!entry.toggle) return el('span', { class: 'key' }, swatch(entry.look), term(entry.label));
  const button = el('button', { type: 'button', class: 'key', 'aria-pressed': 'true' }, swatch(entry.look), term(entry.label));
  button.addEventListener('click', () => {
    const shown = button.getAttribute('aria-pressed') !== 'true';
    button.setAttribute('aria-pressed', String(shown));
    entry.toggle!(shown);
  });
  return button;
}

function swatch(look: Look): SVGElement {
  const shape = look.mark ? square(look) : line(look);
  return svg('svg', { width: look.mark ? 12 : 28, height: 12, 'aria-hidden': 'true' }, shape);
}

function square(look: Look): SVGElement {
  const fill = look.mark === 'filled' ? `var(${look.ink})` : 'none';
  return svg('rect', { x: 2, y: 2, width: 8, height: 8, style: `stroke: var(${look.ink}); stroke-width: 1.5; fill: ${fill}` });
}

function line(look: Look): SVGElement {
  return svg('line', {
    x1: 1,
    y1: 6,
    x2: 27,
    y2: 6,
    style: `stroke: var(${look.ink}); stroke-width: ${look.width}; stroke-dasharray: ${look.dash.join(' ') || 'none'}`,
  });
}

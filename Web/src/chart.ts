import uPlot from 'uplot';
import { el } from './dom';
import { plotLabels, plotMessages } from './messages/plots';
import { colour, onColoursChanged } from './theme';

const charts: Chart[] = [];

interface ChartOptions {
  /** Description of the plot for screen readers. */
  description: string;
  height: number;
  xLabel: string;
  yLabel: string;
  series: uPlot.Series[];
  data: uPlot.AlignedData;
  bands?: uPlot.Band[];
  scales?: uPlot.Scales;
  /** Whether the vertical axis can be zoomed, too. If not, it is fitted to the data. */
  zoomY?: boolean;
  draw?: (u: uPlot) => void;
  /** Called when the cursor moves. `inside` is false when the cursor has left the plot. */
  onCursor?: (u: uPlot, inside: boolean) => void;
}

/** A uPlot plot with keyboard control. It adapts to the size of its container and to the colours of the page. */
export class Chart {
  readonly element: HTMLElement;
  readonly plot: uPlot;
  private full: { x: [number, number]; y: [number, number] } = { x: [0, 1], y: [0, 1] };

  constructor(private readonly options: ChartOptions) {
    this.element = el('div', {
      class: 'plot',
      tabindex: 0,
      role: 'group',
      'aria-roledescription': plotLabels.plot,
      'aria-label': `${options.description} ${plotMessages.keys}`,
    });
    this.plot = new uPlot(this.uplotOptions(), options.data, this.element);
    this.plot.root.querySelector('canvas')!.setAttribute('aria-hidden', 'true');
    this.element.addEventListener('keydown', e => this.onKey(e));
    new ResizeObserver(() => this.fit()).observe(this.element);
    charts.push(this);
  }

  reset(): void {
    this.setRange(this.full.x, this.full.y);
  }

  /** Moves the cursor to a position on the horizontal axis. Hides the cursor if the plot does not show the position. */
  pointAt(x: number): void {
    const left = this.plot.valToPos(x, 'x');
    const isShown = left >= 0 && left <= this.plot.over.clientWidth;
    this.plot.setCursor(isShown ? { left, top: this.plot.over.clientHeight / 2 } : { left: -10, top: -10 });
  }

  /** Shows new data over a range of x. If the user has zoomed, keeps the zoomed range. */
  show(data: uPlot.AlignedData, x: [number, number]): void {
    const shown = this.range('x');
    const [min, max] = shown.every((end, i) => end === this.full.x[i]) ? x : shown;
    this.full.x = x;
    this.plot.batch(() => {
      this.plot.setData(data, false);
      // Also fits the vertical axis.
      this.plot.setScale('x', { min, max });
    });
  }

  fit(): void {
    const width = Math.floor(this.element.clientWidth);
    if (width > 0 && width !== this.plot.width) this.plot.setSize({ width, height: this.options.height });
  }

  private setRange(x: [number, number], y: [number, number]): void {
    this.plot.batch(() => {
      this.plot.setScale('x', { min: x[0], max: x[1] });
      if (this.options.zoomY) this.plot.setScale('y', { min: y[0], max: y[1] });
    });
  }

  private range(scale: string): [number, number] {
    return [this.plot.scales[scale].min ?? 0, this.plot.scales[scale].max ?? 1];
  }

  private onKey(event: KeyboardEvent): void {
    const step = event.shiftKey ? 0.1 : 0.01;
    const moves: Record<string, () => void> = {
      ArrowLeft: () => this.moveCursor(-step, 0),
      ArrowRight: () => this.moveCursor(step, 0),
      ArrowUp: () => this.moveCursor(0, -step),
      ArrowDown: () => this.moveCursor(0, step),
      '+': () => this.zoom(0.5),
      '=': () => this.zoom(0.5),
      '-': () => this.zoom(2),
      '0': () => this.reset(),
    };
    if (event.ctrlKey || event.metaKey || event.altKey || !(event.key in moves)) return;
    moves[event.key]();
    event.preventDefault();
  }

  private moveCursor(right: number, down: number): void {
    const { clientWidth: width, clientHeight: height } = this.plot.over;
    const { left = -1, top = -1 } = this.plot.cursor;
    const from = left < 0 ? { left: width / 2, top: height / 2 } : { left, top };
    this.plot.setCursor({
      left: Math.min(width - 1, Math.max(0, from.left + right * width)),
      top: Math.min(height - 1, Math.max(0, from.top + down * height)),
    });
  }

  /** Zooms around the cursor; without a cursor, around the middle. The range stays within the data. */
  private zoom(factor: number): void {
    const { left = -1, top = -1 } = this.plot.cursor;
    const around = (scale: 'x' | 'y', at: number): [number, number] => {
      const [min, max] = this.range(scale);
      const centre = at < 0 ? (min + max) / 2 : this.plot.posToVal(at, scale);
      const [low, high] = this.full[scale];
      return [Math.max(low, centre + (min - centre) * factor), Math.min(high, centre + (max - centre) * factor)];
    };
    this.setRange(around('x', left), around('y', top));
  }

  private uplotOptions(): uPlot.Options {
    const { options } = this;
    return {
      width: 600,
      height: options.height,
      legend: { show: false },
      scales: { x: { time: false }, ...options.scales },
      axes: [axis(options.xLabel, 32), axis(options.yLabel, 60)],
      series: options.series,
      bands: options.bands,
      cursor: {
        drag: { x: true, y: options.zoomY ?? false, uni: options.zoomY ? 30 : undefined },
        bind: {
          dblclick: () => () => {
            this.reset();
            return null;
          },
        },
      },
      hooks: {
        // uPlot determines the ranges of its scales after the constructor has returned.
        ready: [
          () => {
            this.full = { x: this.range('x'), y: this.range('y') };
          },
        ],
        draw: options.draw ? [options.draw] : [],
        setCursor: [u => options.onCursor?.(u, (u.cursor.left ?? -1) >= 0)],
      },
    };
  }
}

function axis(label: string, size: number): uPlot.Axis {
  return {
    label,
    size,
    labelSize: 22,
    labelGap: 2,
    font: '12px system-ui, sans-serif',
    labelFont: '12px system-ui, sans-serif',
    stroke: () => colour('--muted'),
    grid: { stroke: () => colour('--grid'), width: 1 },
    ticks: { stroke: () => colour('--grid'), width: 1, size: 5 },
    values: (_, splits) => splits.map(v => tick(v)),
  };
}

function tick(value: number): string {
  return String(Number(value.toPrecision(8))).replace('-', '\u2212');
}

const redrawAll = () => charts.forEach(c => c.plot.redraw(false));
onColoursChanged(redrawAll);

// A canvas does not adapt to the narrower page and the light colours of a printout, so all plots are redrawn.
function print(printing: boolean): void {
  document.documentElement.classList.toggle('printing', printing);
  charts.forEach(c => c.fit());
  redrawAll();
}
addEventListener('beforeprint', () => print(true));
addEventListener('afterprint', () => print(false));

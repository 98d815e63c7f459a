import uPlot from 'uplot';
import { Chart } from './chart';
import type { Ink } from './theme';
import { colour } from './theme';
import { Legend } from './legend';
import { axisLabels } from './messages/plots';
import { format, lastUpTo } from './numbers';
import type { Playhead } from './playhead';
import type { Trace } from './traces';

export interface Quantity {
  name: string;
  unit: string;
}

export interface Mark {
  label: string;
  x: number;
}

/** A range of the horizontal axis. */
type Span = [from: number, to: number];

interface LinePlotOptions {
  description: string;
  height: number;
  yLabel: string;
  unit: string;
  traces: Trace[];
  /** Quantity of the horizontal axis. Default: time in seconds. */
  x?: Quantity;
  /** Labelled vertical lines. */
  marks?: Mark[];
  /** Ranges of the horizontal axis that are shaded. */
  spans?: Span[];
  /** Colour of the area between a trace and the following trace with `mirror`. */
  band?: Ink;
  /** Whether the vertical axis starts at 0. */
  fromZero?: boolean;
  /** Playhead that is shared with other plots over the same time. */
  playhead?: Playhead;
  /** Fixed range of the vertical axis, even if values exceed it. */
  yRange?: [from: number, to: number];
}

/** Plots signals over time or another quantity. Each signal has its own times. The legend shows the values at the cursor. */
export function linePlot(options: LinePlotOptions): { chart: Chart; legend: Legend } {
  const { traces, unit } = options;
  const data = uPlot.join(traces.map(t => [t.t, t.v] as uPlot.AlignedData));
  const entries = traces.map((trace, i) => ({ trace, i })).filter(e => !e.trace.mirror);

  const legend = new Legend(
    entries.map(({ trace, i }) => ({
      label: trace.label,
      look: trace.look,
      toggle: show => togglers(traces, i).forEach(s => chart.plot.setSeries(s, { show })),
    })),
  );
  const chart = new Chart({
    ...options,
    xLabel: labelOf(options.x ?? { name: axisLabels.time, unit: 's' }),
    data,
    series: [{}, ...traces.map(series)],
    bands: options.band ? bandsOf(traces, options.band) : undefined,
    scales: { y: { range: scaleOf(options) } },
    draw: u => {
      paintSpans(u, options.spans ?? []);
      traces.forEach((trace, i) => {
        if (trace.deviation && u.series[i + 1].show) paintDeviations(u, trace);
      });
      if (options.marks?.length) paintMarks(u, options.marks);
    },
    onCursor: (u, inside) => {
      if (!inside) return legend.show('');
      const time = u.posToVal(u.cursor.left!, 'x');
      options.playhead?.move(time, chart);
      const { x } = options;
      legend.show(
        x ? `${x.name} ${format(time, x.unit)}` : `t = ${time.toFixed(3)} s`,
        entries.map(e => format(valueAt(e.trace, time), unit)),
      );
    },
  });
  options.playhead?.follow((time, mover) => {
    if (mover !== chart) chart.pointAt(time);
  });
  return { chart, legend };
}

function scaleOf({ fromZero, yRange, traces }: LinePlotOptions): uPlot.Scale.Range {
  if (yRange) return yRange;
  // uPlot fits the range to the points only, which would cut off error bars.
  if (traces.some(t => t.deviation)) return barRange(traces, fromZero ?? false);
  return { min: { pad: 0.08, soft: 0, mode: fromZero ? 1 : 0 }, max: { pad: 0.08 } };
}

function barRange(traces: Trace[], fromZero: boolean): [number, number] {
  const ends = traces.flatMap(({ v, deviation }) =>
    v.flatMap((value, i) => {
      const half = deviation?.[i] ?? 0;
      return value == null ? [] : [value - half, value + half];
    }),
  );
  const min = Math.min(...ends, ...(fromZero ? [0] : []));
  const max = Math.max(...ends);
  const pad = 0.08 * (max - min || 1);
  return [fromZero && min >= 0 ? 0 : min - pad, max + pad];
}

function labelOf({ name, unit }: Quantity): string {
  return unit ? `${name} (${unit})` : name;
}

function paintSpans(u: uPlot, spans: Span[]): void {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.fillStyle = colour('--alarm');
  for (const span of spans) {
    const [from, to] = span.map(x => Math.min(bbox.left + bbox.width, Math.max(bbox.left, u.valToPos(x, 'x', true))));
    if (to > from) ctx.fillRect(from, bbox.top, to - from, bbox.height);
  }
  ctx.restore();
}

function paintMarks(u: uPlot, marks: Mark[]): void {
  const { ctx, bbox } = u;
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = colour('--muted');
  ctx.lineWidth = ratio;
  ctx.font = `600 ${12 * ratio}px system-ui, sans-serif`;
  ctx.textBaseline = 'alphabetic';
  ctx.setLineDash([2 * ratio, 3 * ratio]);
  for (const { label, x } of marks) {
    const at = u.valToPos(x, 'x', true);
    if (at < bbox.left || at > bbox.left + bbox.width) continue;
    ctx.beginPath();
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
    ctx.stroke();
    // Draws the label to the left of its line if there is space, because the data to the right of a limit are more important.
    const gap = 5 * ratio;
    const fits = at - gap - ctx.measureText(label).width >= bbox.left;
    ctx.textAlign = fits ? 'right' : 'left';
    ctx.fillText(label, fits ? at - gap : at + gap, bbox.top + 14 * ratio);
  }
  ctx.restore();
}

function paintDeviations(u: uPlot, { look, t, v, deviation }: Trace): void {
  const { ctx, bbox } = u;
  const ratio = devicePixelRatio;
  const cap = 4 * ratio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.strokeStyle = colour(look.ink);
  ctx.lineWidth = ratio;
  ctx.beginPath();
  t.forEach((time, i) => {
    const value = v[i];
    const half = deviation![i];
    if (value == null || half == null) return;
    const at = u.valToPos(time, 'x', true);
    const top = u.valToPos(value + half, 'y', true);
    const bottom = u.valToPos(value - half, 'y', true);
    ctx.moveTo(at, top);
    ctx.lineTo(at, bottom);
    for (const y of [top, bottom]) {
      ctx.moveTo(at - cap, y);
      ctx.lineTo(at + cap, y);
    }
  });
  ctx.stroke();
  ctx.restore();
}

function series(trace: Trace): uPlot.Series {
  const { look } = trace;
  return {
    label: trace.label,
    width: look.width,
    dash: look.dash,
    stroke: () => colour(look.ink),
    paths: trace.scattered ? () => null : trace.stepped ? uPlot.paths.stepped!({ align: 1 }) : undefined,
    points: pointsOf(trace),
  };
}

function pointsOf(trace: Trace): uPlot.Series.Points {
  if (trace.scattered) return { show: true, size: 5, width: 0, fill: () => colour(trace.look.ink) };
  if (trace.marked) return { show: true, size: 6, fill: () => colour(trace.look.ink) };
  return trace.stepped ? { show: u => hasRoom(u, trace), size: 5, fill: () => colour('--surface') } : { show: false };
}

/** Returns whether the points of a trace are far enough apart to be drawn individually. */
function hasRoom(u: uPlot, { t }: Trace): boolean {
  const { min = 0, max = 0 } = u.scales.x as { min?: number; max?: number };
  const interval = (t[t.length - 1] - t[0]) / Math.max(1, t.length - 1);
  return (max - min) / interval < u.over.clientWidth / 10;
}

function togglers(traces: Trace[], index: number): number[] {
  return traces[index + 1]?.mirror ? [index + 1, index + 2] : [index + 1];
}

function bandsOf(traces: Trace[], ink: Ink): uPlot.Band[] {
  const upper = traces.findIndex((_, i) => traces[i + 1]?.mirror);
  return [{ series: [upper + 1, upper + 2], fill: () => colour(ink) as unknown as CanvasRenderingContext2D['fillStyle'] }];
}

/** Returns the value of a trace at a given time: for a stepped trace the last value up to this time, otherwise the nearest value. */
function valueAt(trace: Trace, time: number): number | null {
  const { t, v } = trace;
  const last = lastUpTo(t, time);
  if (trace.stepped) return last < 0 ? null : v[last];
  const next = Math.min(last + 1, t.length - 1);
  return last < 0 || Math.abs(t[next] - time) < Math.abs(t[last] - time) ? v[next] : v[last];
}

import uPlot from 'uplot';
import { Chart } from './chart';
import { type FieldData, hasPoints, type OperatingPath } from './data';
import { Legend } from './legend';
import { axisLabels, traceLabels } from './messages/plots';
import { format, quantile } from './numbers';
import { colour } from './theme';
import { type Look, LOOKS } from './traces';

const FEW = 200;

export interface Path {
  label: string;
  look: Look;
  points: OperatingPath;
  shown: boolean;
}

/** Plots the operating points of a run: speed against latency, with and without compensation, and curves of equal error e = v·L. */
export function fieldPlot(field: FieldData, description: string): { chart: Chart; legend: Legend } {
  return operatingPlot(pathsOf(field), field.iso_mm ?? [], description);
}

/** Plots operating points and curves of equal error in mm. */
export function operatingPlot(paths: Path[], isoMm: number[], description: string): { chart: Chart; legend: Legend } {
  const { latency, speed } = extents(paths);

  const legend = new Legend([
    ...paths.map(path => ({
      label: path.label,
      look: path.look,
      toggle: (shown: boolean) => {
        path.shown = shown;
        chart.plot.redraw(false);
      },
    })),
    { label: traceLabels.equalError, look: LOOKS.bound },
  ]);
  const chart = new Chart({
    description,
    height: 340,
    xLabel: axisLabels.latency,
    yLabel: axisLabels.speed,
    // The points are drawn by paintPoints, because uPlot allows only one value per x, and two points can have the same latency.
    series: [{}, { show: false }],
    data: [
      [0, latency],
      [0, speed],
    ],
    scales: { x: { time: false, min: 0, max: latency }, y: { auto: false, min: 0, max: speed } },
    zoomY: true,
    draw: u => paint(u, paths, isoMm),
    onCursor: (u, inside) => legend.show(inside ? readout(u) : ''),
  });
  return { chart, legend };
}

export function pathsOf(field: FieldData): Path[] {
  const path = (label: string, look: Look, points: OperatingPath | null | undefined) =>
    hasPoints(points?.latency_ms) ? [{ label, look, points: points!, shown: true }] : [];
  return [
    ...path(traceLabels.uncompensated, LOOKS.holdPoints, field.hold),
    ...path(traceLabels.compensated, LOOKS.compensatedPoints, field.compensated),
  ];
}

/**
 * Returns the initial upper ends of the axes. At low speed, the latency that is computed from the error is arbitrary. The horizontal range
 * therefore covers 95 % of the points of the first path, which is the uncompensated one if there is one. The vertical range covers 99 % of the points
 * of each path.
 */
function extents(paths: Path[]): { latency: number; speed: number } {
  return {
    latency: 1.1 * quantile(paths[0].points.latency_ms, 0.95) || 1,
    speed: 1.1 * Math.max(...paths.map(path => quantile(path.points.speed, 0.99))) || 1,
  };
}

/** Returns the number of points outside the initial ranges. */
export function beyond(field: FieldData): number {
  const paths = pathsOf(field);
  const { latency, speed } = extents(paths);
  return paths.reduce((sum, { points }) => sum + points.latency_ms.filter((l, i) => l > latency || points.speed[i] > speed).length, 0);
}

function readout(u: uPlot): string {
  const latency = u.posToVal(u.cursor.left!, 'x');
  const speed = u.posToVal(u.cursor.top!, 'y');
  return `${format(latency, 'ms')} × ${format(speed, 'mm/s')} = ${format((latency * speed) / 1000, 'mm')}`;
}

function paint(u: uPlot, paths: Path[], errors: number[]): void {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  for (const error of errors) paintCurve(u, error);
  for (const path of paths) if (path.shown) paintPoints(u, path);
  for (const error of errors) paintLabel(u, error);
  ctx.restore();
}

function paintCurve(u: uPlot, error: number): void {
  const { ctx, bbox } = u;
  ctx.beginPath();
  for (let x = bbox.left; x <= bbox.left + bbox.width; x += 2) {
    const latency = u.posToVal(x - bbox.left, 'x', true);
    if (latency > 0) ctx.lineTo(x, u.valToPos((1000 * error) / latency, 'y', true));
  }
  ctx.strokeStyle = colour(LOOKS.bound.ink);
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash(LOOKS.bound.dash.map(d => d * devicePixelRatio));
  ctx.stroke();
  ctx.setLineDash([]);
}

/** Draws uncompensated points as hollow squares and compensated ones as filled squares, so that they also differ in shape. */
function paintPoints(u: uPlot, path: Path): void {
  const { ctx, bbox } = u;
  const { latency_ms, speed } = path.points;
  // Draws larger points if there are few.
  const isFew = latency_ms.length < FEW;
  const size = (isFew ? 7 : 4) * devicePixelRatio;
  const squares = new Path2D();
  // Draws at most one square per pixel, because in an hour of data, thousands of points coincide.
  const stride = Math.ceil(bbox.width) + 1;
  const taken = new Uint8Array(stride * (Math.ceil(bbox.height) + 1));
  for (let i = 0; i < latency_ms.length; i++) {
    const x = Math.round(u.valToPos(latency_ms[i], 'x', true) - bbox.left);
    const y = Math.round(u.valToPos(speed[i], 'y', true) - bbox.top);
    if (x < 0 || y < 0 || x > bbox.width || y > bbox.height || taken[y * stride + x]) continue;
    taken[y * stride + x] = 1;
    squares.rect(bbox.left + x - size / 2, bbox.top + y - size / 2, size, size);
  }
  ctx.globalAlpha = isFew ? 1 : 0.7;
  if (path.look.mark === 'hollow') {
    ctx.strokeStyle = colour(path.look.ink);
    ctx.lineWidth = (isFew ? 1.5 : 1) * devicePixelRatio;
    ctx.stroke(squares);
  } else {
    ctx.fillStyle = colour(path.look.ink);
    ctx.fill(squares);
  }
  ctx.globalAlpha = 1;
}

/** Draws the label of a curve of equal error where the curve crosses the diagonal of the plot, which it does exactly once. */
function paintLabel(u: uPlot, error: number): void {
  const { ctx, bbox } = u;
  const ratio = devicePixelRatio;
  const on = (scale: 'x' | 'y', t: number) => u.scales[scale].min! + t * (u.scales[scale].max! - u.scales[scale].min!);
  const errorAt = (t: number) => (on('x', t) * on('y', t)) / 1000;
  if (errorAt(0) >= error || errorAt(1) <= error) return;
  let low = 0;
  let high = 1;
  for (let i = 0; i < 30; i++) {
    const middle = (low + high) / 2;
    if (errorAt(middle) < error) low = middle;
    else high = middle;
  }
  const x = bbox.left + low * bbox.width;
  const y = bbox.top + (1 - low) * bbox.height;
  ctx.font = `600 ${11 * ratio}px system-ui, sans-serif`;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.lineJoin = 'round';
  ctx.lineWidth = 4 * ratio;
  ctx.strokeStyle = colour('--surface');
  ctx.strokeText(`${error} mm`, x, y);
  ctx.fillStyle = colour('--ink');
  ctx.fillText(`${error} mm`, x, y);
}

import { type ClockData, type ErrorData, type FieldData, hasPoints, type JointData, type LatencyData, type Signal, type Value } from './data';
import { beyond, fieldPlot, pathsOf } from './fieldPlot';
import { figure, type FigureOptions, notMeasured } from './plotBlock';
import { histogram } from './histogram';
import { linePlot } from './linePlot';
import { axisLabels, plotDescriptions, plotValueMessages, traceLabels } from './messages/plots';
import { claimMessages, claimSources, claimTitles, reportLabels, reportMessages } from './messages/report';
import { tableLabels } from './messages/tables';
import { format, statistics } from './numbers';
import type { Playhead } from './playhead';
import { factTable, statisticsTable } from './tables';
import { LOOKS, type Trace } from './traces';

export function errorSection(error: ErrorData | null | undefined, playhead?: Playhead): HTMLElement {
  const options: FigureOptions = { id: 'error', title: claimTitles.error, claim: claimMessages.error, source: claimSources.error };
  const traces = [
    trace(traceLabels.uncompensated, LOOKS.hold, error?.t, error?.hold),
    trace(traceLabels.compensated, LOOKS.compensated, error?.t, error?.compensated),
  ].flat();
  if (traces.length === 0) return notMeasured(options);
  const description = plotDescriptions.error(inWords(traces, 'mm'));
  return figure(
    options,
    [linePlot({ description, height: 300, yLabel: axisLabels.toolError, unit: 'mm', traces, playhead, fromZero: true })],
    numbersOf(reportLabels.toolError, 'mm', traces),
  );
}

export function jointSection(joint: JointData | null | undefined, playhead?: Playhead): HTMLElement {
  const options: FigureOptions = {
    id: 'joint',
    title: joint?.name ? claimTitles.jointNamed(joint.name) : claimTitles.joint,
    claim: claimMessages.joint,
    source: claimSources.joint,
  };
  const signal = (label: string, look: Trace['look'], s: Signal | null | undefined) => trace(label, look, s?.t, s?.v);
  const traces = [
    signal(traceLabels.groundTruth, LOOKS.truth, joint?.truth),
    signal(traceLabels.received, LOOKS.hold, joint?.received).map(t => ({ ...t, stepped: true })),
    signal(traceLabels.predicted, LOOKS.compensated, joint?.predicted),
  ].flat();
  if (traces.length === 0) return notMeasured(options);
  const unit = joint!.unit;
  const description = plotDescriptions.joint(joint!.name, inWords(traces, unit));
  return figure(
    options,
    [linePlot({ description, height: 300, yLabel: axisLabels.position(unit), unit, traces, playhead })],
    numbersOf(claimTitles.joint, unit, traces),
  );
}

export function fieldSection(field: FieldData | null | undefined): HTMLElement {
  const options: FigureOptions = { id: 'field', title: claimTitles.field, claim: claimMessages.field, source: claimSources.field };
  const paths = field ? pathsOf(field) : [];
  if (paths.length === 0) return notMeasured(options);
  const rows = paths.map(p => [p.label, statistics(p.points.latency_ms)] as const);
  const words = rows.map(([label, s]) => plotValueMessages.latency(label, format(s?.min), format(s?.max, 'ms'))).join(' ');
  const outside = beyond(field!);
  const note = outside > 0 ? ` ${reportMessages.pointsBeyond(outside)}` : '';
  const description = plotDescriptions.field(words + note);
  return figure(
    { ...options, claim: options.claim + note },
    [fieldPlot(field!, description)],
    statisticsTable(
      reportLabels.latencyOfPoints,
      'ms',
      rows.map(([label, s]) => [label, s]),
    ),
  );
}

export function clockSection(clock: ClockData | null | undefined, playhead?: Playhead): HTMLElement {
  const options: FigureOptions = { id: 'clock', title: claimTitles.clock, claim: claimMessages.clock, source: claimSources.clock };
  const negative = clock?.bound_us?.map(b => (b == null ? null : -b));
  const offset = trace(traceLabels.offset, LOOKS.compensated, clock?.t, clock?.offset_us);
  const error = [
    trace(traceLabels.bound, LOOKS.bound, clock?.t, clock?.bound_us),
    trace(traceLabels.negativeBound, LOOKS.bound, clock?.t, negative).map(t => ({ ...t, mirror: true })),
    trace(traceLabels.error, LOOKS.compensated, clock?.t, clock?.error_us),
  ].flat();
  if (offset.length + error.length === 0) return notMeasured(options);
  const extent = errorExtent(clock!);
  const widest = maxMagnitude(error.flatMap(t => t.v));
  const note = widest > extent ? ` ${reportMessages.errorBeyond(extent, widest)}` : '';
  const plots = [];
  if (offset.length > 0)
    plots.push(
      linePlot({
        description: plotDescriptions.clockOffset(inWords(offset, 'µs')),
        height: 200,
        yLabel: axisLabels.offset,
        unit: 'µs',
        traces: offset,
        playhead,
      }),
    );
  if (error.length > 0)
    plots.push(
      linePlot({
        description: plotDescriptions.clockError(inWords(error, 'µs') + note),
        height: 260,
        yLabel: axisLabels.offsetError,
        unit: 'µs',
        traces: error,
        playhead,
        yRange: [-extent, extent],
        band: error.some(t => t.mirror) ? '--band' : undefined,
      }),
    );
  return figure({ ...options, claim: options.claim + note }, plots, numbersOf(reportLabels.clock, 'µs', [...offset, ...error]));
}

/**
 * Returns the maximum of the axis for the clock error, µs: 1.5 times the maximum error after the clock has settled, but at least the 1 ms that the
 * paper reports. The bound and the error of the first exchanges are many times larger, so the settled error would look like a flat line.
 */
function errorExtent({ t, error_us: error }: ClockData): number {
  const settled = t[0] + Math.min(10, (t[t.length - 1] - t[0]) / 2);
  return Math.max(1000, 1.5 * maxMagnitude(error?.filter((_, i) => t[i] >= settled) ?? []));
}

function maxMagnitude(values: Value[]): number {
  return values.reduce<number>((max, v) => Math.max(max, Math.abs(v ?? 0)), 0);
}

export function latencySection(latency: LatencyData | null | undefined): HTMLElement {
  const options: FigureOptions = {
    id: 'latency',
    title: latency?.label || claimTitles.latency,
    claim: claimMessages.latency,
    source: claimSources.latency,
  };
  if (!hasPoints(latency?.bin_ms)) return notMeasured(options);
  const { bin_ms: bins, count } = latency!;
  const top = count.indexOf(count.reduce((a, b) => Math.max(a, b), 0));
  const total = count.reduce((a, b) => a + b, 0);
  const description = plotDescriptions.latency(total, bins[0], bins[bins.length - 1], bins[top]);
  return figure(
    options,
    [histogram(latency!, description)],
    factTable(
      tableLabels.samplesByLatency,
      bins.map((b, i) => [tableLabels.latencyFrom(format(b)), count[i] ?? 0]),
      [tableLabels.latency, tableLabels.samples],
    ),
  );
}

export function trace(label: string, look: Trace['look'], t?: number[] | null, v?: (number | null)[] | null): Trace[] {
  return hasPoints(t) && hasPoints(v) ? [{ label, look, t: t!, v: v! }] : [];
}

export function inWords(traces: Trace[], unit: string): string {
  return traces
    .filter(t => !t.mirror)
    .map(t => {
      const s = statistics(t.v);
      return s ? plotValueMessages.range(t.label, format(s.min), format(s.max, unit), format(s.rms, unit)) : plotValueMessages.none(t.label);
    })
    .join(' ');
}

export function numbersOf(caption: string, unit: string, traces: Trace[]): HTMLElement {
  return statisticsTable(
    caption,
    unit,
    traces.filter(t => !t.mirror).map(t => [t.label, statistics(t.v)]),
  );
}

import type { RangeData } from './data';
import { figure, type FigureOptions, notMeasured } from './plotBlock';
import { linePlot } from './linePlot';
import { axisLabels, plotDescriptions, plotValueMessages, traceLabels } from './messages/plots';
import { claimMessages, claimSources, claimTitles, reportLabels } from './messages/report';
import { format } from './numbers';
import type { Playhead } from './playhead';
import { inWords, numbersOf, trace } from './sections';
import { LOOKS } from './traces';

/** Creates the section with render time and visualisation latency over time. The time spans of alarms are shaded. */
export function rangeSection(range: RangeData, playhead?: Playhead): HTMLElement {
  const options: FigureOptions = { id: 'range', title: claimTitles.range, claim: claimMessages.range, source: claimSources.range };
  const render = trace(traceLabels.renderTime, LOOKS.compensated, range.t, range.render_ms);
  const visu = trace(traceLabels.visualisationLatency, LOOKS.compensated, range.t, range.visu_ms);
  if (render.length + visu.length === 0) return notMeasured(options);
  const ends = [range.t[0], range.t[range.t.length - 1]];
  const limit = range.limit_ms == null ? [] : trace(traceLabels.limit, LOOKS.hold, ends, [range.limit_ms, range.limit_ms]);
  const spans = range.alarms ?? [];
  const alarms =
    spans.length === 0 ? plotValueMessages.noAlarm : spans.map(([from, to]) => plotValueMessages.alarm(format(from), format(to, 's'))).join(' ');
  const plot = (what: string, yLabel: string, traces: typeof render) =>
    linePlot({
      description: plotDescriptions.ofEachFrame(what, `${inWords(traces, 'ms')} ${alarms}`),
      height: 220,
      yLabel,
      unit: 'ms',
      traces,
      spans,
      playhead,
      fromZero: true,
    });
  return figure(
    options,
    [
      plot(reportLabels.renderTime, axisLabels.renderTime, [...render, ...limit]),
      plot(reportLabels.visualisationLatency, axisLabels.visualisationLatency, visu),
    ],
    numbersOf(reportLabels.display, 'ms', [...render, ...visu]),
  );
}

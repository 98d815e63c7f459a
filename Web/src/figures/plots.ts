import { operatingPlot } from '../fieldPlot';
import { el } from '../dom';
import { type Plot, plotBlock } from '../plotBlock';
import { linePlot } from '../linePlot';
import { plotValueLabels } from '../messages/plots';
import { format, statistics } from '../numbers';
import type { PlotData } from './data';
import { lookOf, pointsOf } from './looks';

const LINES = 300;
const ONE_OF_SEVERAL = 220;

/**
 * Creates the plots of a figure, each with its title if there are several.
 * @param figure Name of the figure. The descriptions for screen readers begin with it.
 */
export function plotBlocks(plots: PlotData[], figure: string): HTMLElement[] {
  if (plots.length === 1) return [plotBlock(plotOf(plots[0], figure, false))];
  return plots.map(plot => el('div', { class: 'titled' }, el('h3', {}, plot.title), plotBlock(plotOf(plot, figure, true))));
}

function plotOf(plot: PlotData, figure: string, isOneOfSeveral: boolean): Plot {
  const description = `${figure}, ${plot.title}: ${inWords(plot)}`;
  if (plot.iso_mm) return operatingPlot(plot.traces.map(pathOf), plot.iso_mm, description);
  return linePlot({
    description,
    height: isOneOfSeveral ? ONE_OF_SEVERAL : LINES,
    x: plot.x,
    yLabel: plot.y.unit ? `${plot.y.name} (${plot.y.unit})` : plot.y.name,
    unit: plot.y.unit,
    fromZero: plot.from_zero,
    yRange: plot.y_range ?? undefined,
    marks: plot.marks,
    traces: plot.traces.map(t => ({
      label: t.label,
      look: t.scattered ? pointsOf(t.look) : lookOf(t.look),
      t: t.x,
      v: t.y,
      stepped: t.stepped,
      marked: t.marked,
      scattered: t.scattered,
      deviation: t.deviation ?? undefined,
    })),
  });
}

function pathOf({ label, look, x, y }: PlotData['traces'][number]) {
  return { label, look: pointsOf(look), points: { latency_ms: x, speed: y.map(v => v ?? 0) }, shown: true };
}

function inWords({ x, y, traces, iso_mm }: PlotData): string {
  const over = iso_mm ? x : y;
  return (
    traces
      .map(t => {
        const s = statistics(iso_mm ? t.x : t.y);
        return s ? plotValueLabels.range(t.label, over.name, format(s.min), format(s.max, over.unit)) : plotValueLabels.none(t.label);
      })
      .join('; ') + '.'
  );
}

import type { Chart } from './chart';
import { el } from './dom';
import type { Legend } from './legend';
import { plotLabels, plotMessages } from './messages/plots';
import { PAPER, paperLabels } from './messages/report';
import { term } from './terms';

export interface FigureOptions {
  id: string;
  title: string;
  /** Statement that the figure supports, in one sentence. */
  claim: string;
  /** Place in the paper to which the figure refers, for example "Fig. 16" or "Sect. 3". */
  source: string;
}

export interface Plot {
  chart: Chart;
  legend: Legend;
}

/** Creates a section with heading, claim, source, plots, and a table of their numbers. */
export function figure(options: FigureOptions, plots: Plot[], numbers: HTMLElement): HTMLElement {
  return section(options, ...plots.map(plotBlock), el('details', {}, el('summary', {}, plotLabels.numbers), numbers));
}

export function notMeasured(options: FigureOptions): HTMLElement {
  return section(options, el('p', { class: 'missing' }, plotMessages.notMeasured));
}

function section(options: FigureOptions, ...content: HTMLElement[]): HTMLElement {
  const heading = `${options.id}-heading`;
  return el(
    'section',
    { id: options.id, class: 'figure', 'aria-labelledby': heading },
    el('h2', { id: heading }, term(options.title)),
    el('p', { class: 'claim' }, options.claim, ' ', citation(options.source)),
    ...content,
  );
}

/** Creates the reference to a figure, an equation or a section of the paper. */
export function citation(place: string): HTMLElement {
  return el('span', { class: 'source' }, '(', el('a', { href: PAPER }, paperLabels.citation(place)), ')');
}

/** Creates the last paragraph of a page, with a link to the paper. */
export function credit(text: string): HTMLElement {
  const [before, after] = text.split(PAPER);
  return el('footer', {}, el('p', {}, before, el('a', { href: PAPER }, PAPER), after));
}

/** Creates the paragraph that explains how to use the plots. */
export function plotHint(): HTMLElement {
  return el('p', { class: 'hint' }, plotMessages.howToUse);
}

export function plotBlock({ chart, legend }: Plot): HTMLElement {
  const reset = el('button', { type: 'button', class: 'reset' }, plotLabels.resetZoom);
  reset.addEventListener('click', () => chart.reset());
  return el('div', { class: 'plot-block' }, el('div', { class: 'bar' }, legend.element, reset), chart.element);
}

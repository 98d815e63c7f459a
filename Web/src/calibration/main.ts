import 'uplot/dist/uPlot.min.css';
import '../report.css';
import '../paper/figures.css';
import './calibration.css';
import { el } from '../dom';
import { PAPER, plotBlock } from '../figures';
import { plotOf } from '../paper/plots';
import { dataTable } from '../paper/tables';
import { text } from '../paper/text';
import { factTable } from '../tables';
import { type CalibrationData, readCalibration, type SectionData } from './data';

function page(data: CalibrationData): Node[] {
  return [
    el('header', {}, el('h1', {}, data.title), el('p', { class: 'result' }, ...text(data.result))),
    el(
      'main',
      {},
      ...data.warnings.map(warning => el('p', { class: 'warning', role: 'note' }, ...text(warning))),
      el('section', { 'aria-label': 'Result' }, factTable('Result and conditions', data.facts)),
      el(
        'p',
        { class: 'hint' },
        'Drag across a plot to zoom, double-click to reset, point at it to read values; '
          + 'with the keyboard: arrow keys, plus, minus and 0. Names in a legend switch signals on and off.',
      ),
      ...data.sections.map(section),
    ),
    el(
      'footer',
      {},
      el(
        'p',
        {},
        'The method is that of M. Schnierle, S. Röck, “Latency and sampling compensation in mixed-reality-in-the-loop '
          + 'simulations of production systems”, Production Engineering (2022), ',
        el('a', { href: PAPER }, PAPER),
        ' (CC BY 4.0). Made by Nowpose.',
      ),
    ),
  ];
}

function section({ heading, source, words, plots, table }: SectionData, index: number): HTMLElement {
  const id = `section-${index + 1}`;
  const citation = source ? el('span', { class: 'source' }, '(', el('a', { href: PAPER }, `Schnierle & Röck 2022, ${source}`), ')') : null;
  const blocks = plots.map(plot => {
    const block = plotBlock(plotOf(plot, heading, plots.length > 1));
    return plots.length > 1 ? el('div', { class: 'titled' }, el('h3', {}, plot.title), block) : block;
  });
  return el(
    'section',
    { 'aria-labelledby': id },
    el('h2', { id }, heading),
    el('p', {}, ...text(words), ' ', citation),
    ...blocks,
    table ? el('details', {}, el('summary', {}, 'Numbers'), dataTable(heading, table)) : null,
  );
}

const data = readCalibration();
document.title = `${data.title} · Nowpose`;
document.getElementById('page')!.replaceChildren(...page(data));

import 'uplot/dist/uPlot.min.css';
import '../report.css';
import './figures.css';
import { el } from '../dom';
import { PAPER } from '../figures';
import { factTable } from '../tables';
import { contents } from './contents';
import { type FiguresData, readFigures } from './data';
import { figureSection } from './section';

function page(data: FiguresData): Node[] {
  const hint =
    'Drag across a plot to zoom, double-click to reset, point at it to read values; '
    + 'with the keyboard: arrow keys, plus, minus and 0. Names in a legend switch signals on and off.';
  const missing = data.missing.map(number => `Fig. ${number}`).join(', ');
  return [
    el('header', {}, el('h1', {}, data.title), el('p', {}, data.subtitle)),
    el(
      'main',
      {},
      el(
        'div',
        { class: 'first' },
        el(
          'section',
          { 'aria-label': 'Verdicts' },
          contents(data.figures),
          missing ? el('p', { class: 'missing' }, `Not computed, because the run was interrupted: ${missing}.`) : null,
        ),
        el(
          'section',
          { 'aria-label': 'Conditions' },
          factTable('Conditions of all figures, unless one says otherwise', data.conditions, ['Condition', 'Value']),
        ),
      ),
      el('p', { class: 'hint' }, hint),
      ...data.figures.map(figureSection),
    ),
    el(
      'footer',
      {},
      el(
        'p',
        {},
        'The figures’ numbers and claims are those of M. Schnierle, S. Röck, “Latency and sampling compensation in '
          + 'mixed-reality-in-the-loop simulations of production systems”, Production Engineering (2022), ',
        el('a', { href: PAPER }, PAPER),
        ' (CC BY 4.0). All data are computed by this run. Made by Nowpose.',
      ),
    ),
  ];
}

const data = readFigures();
document.title = data.title;
document.getElementById('page')!.replaceChildren(...page(data));
// The sections did not exist yet when the browser looked for the address's fragment.
document.getElementById(location.hash.slice(1))?.scrollIntoView();

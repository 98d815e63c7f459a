import 'uplot/dist/uPlot.min.css';
import '../report.css';
import './figures.css';
import { byId, el } from '../dom';
import { credit, plotHint } from '../plotBlock';
import { creditMessages, figuresLabels, figuresMessages, paperLabels } from '../messages/report';
import { tableLabels } from '../messages/tables';
import { factTable } from '../tables';
import { listTerms } from '../terms';
import { contents } from './contents';
import { type FiguresData, readFigures } from './data';
import { figureSection } from './section';

function page(data: FiguresData): Node[] {
  const missing = data.missing.map(number => paperLabels.figure(number)).join(', ');
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
          { 'aria-label': figuresLabels.verdicts },
          contents(data.figures),
          missing ? el('p', { class: 'missing' }, figuresMessages.notComputed(missing)) : null,
        ),
        el(
          'section',
          { 'aria-label': figuresLabels.conditionsOfAll },
          factTable(figuresLabels.conditions, data.conditions, [figuresLabels.condition, tableLabels.value]),
        ),
      ),
      plotHint(),
      ...data.figures.map(figureSection),
    ),
    credit(creditMessages.figures),
  ];
}

const data = readFigures();
document.title = data.title;
byId('page').replaceChildren(...page(data));
listTerms(byId('page'));
// Scrolls to the section in the fragment of the address. The sections did not exist yet when the browser tried this.
document.getElementById(location.hash.slice(1))?.scrollIntoView();

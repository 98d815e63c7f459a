import 'uplot/dist/uPlot.min.css';
import '../report.css';
import '../figures/figures.css';
import './calibration.css';
import { byId, el } from '../dom';
import { citation, credit, plotHint } from '../plotBlock';
import { calibrationLabels, creditMessages } from '../messages/report';
import { plotBlocks } from '../figures/plots';
import { dataTable } from '../figures/tables';
import { text } from '../figures/text';
import { factTable } from '../tables';
import { listTerms } from '../terms';
import { type CalibrationData, readCalibration, type SectionData } from './data';

function page(data: CalibrationData): Node[] {
  return [
    el('header', {}, el('h1', {}, data.title), el('p', { class: 'result' }, ...text(data.result))),
    el(
      'main',
      {},
      ...data.warnings.map(warning => el('p', { class: 'warning', role: 'note' }, ...text(warning))),
      el('section', { 'aria-label': calibrationLabels.result }, factTable(calibrationLabels.facts, data.facts)),
      plotHint(),
      ...data.sections.map(section),
    ),
    credit(creditMessages.calibration),
  ];
}

function section({ heading, source, words, plots, table }: SectionData, index: number): HTMLElement {
  const id = `section-${index + 1}`;
  return el(
    'section',
    { 'aria-labelledby': id },
    el('h2', { id }, heading),
    el('p', {}, ...text(words), ' ', source ? citation(source) : null),
    ...plotBlocks(plots, heading),
    table ? el('details', {}, el('summary', {}, calibrationLabels.numbers), dataTable(heading, table)) : null,
  );
}

const data = readCalibration();
document.title = calibrationLabels.title(data.title);
byId('page').replaceChildren(...page(data));
listTerms(byId('page'));

import 'uplot/dist/uPlot.min.css';
import './report.css';
import './figures/figures.css';
import './robot/robot.css';
import { hasPoints, readReport, type Report, type SummaryRow } from './data';
import { byId, el } from './dom';
import { credit, plotHint } from './plotBlock';
import { plotMessages } from './messages/plots';
import { creditMessages, reportLabels, reportMessages } from './messages/report';
import { format } from './numbers';
import { claimsSection } from './figures/claims';
import { figureSection } from './figures/section';
import { Playback } from './playback';
import { Playhead } from './playhead';
import { rangeSection } from './rangeSection';
import { clockSection, errorSection, fieldSection, jointSection, latencySection } from './sections';
import { factTable, reductionOf, summaryTable } from './tables';
import { listTerms } from './terms';

function headline(rows: SummaryRow[]): HTMLElement {
  const row = rows.find(r => reductionOf(r) != null);
  if (!row) return el('p', { class: 'missing' }, plotMessages.partNotMeasured(reportLabels.toolError));
  const reduction = reductionOf(row)!;
  return el(
    'p',
    { class: 'headline' },
    el('strong', {}, format(Math.abs(100 * reduction), '%')),
    el('span', {}, reduction >= 0 ? reportLabels.lessError : reportLabels.moreError),
    el('small', {}, `${row.label}: ${format(row.uncompensated, row.unit)} → ${format(row.compensated, row.unit)}`),
  );
}

function overview(report: Report): HTMLElement {
  const rows = report.summary ?? [];
  return el(
    'section',
    { class: 'overview', 'aria-labelledby': 'result-heading' },
    el('h2', { id: 'result-heading' }, reportLabels.result),
    headline(rows),
    hasPoints(rows) ? summaryTable(rows) : el('p', { class: 'missing' }, plotMessages.partNotMeasured(reportLabels.comparison)),
    el('p', { class: 'claim' }, reportMessages.uncompensatedAndCompensated),
  );
}

function facts(report: Report): HTMLElement {
  const table = (caption: string, rows: Report['facts']) =>
    hasPoints(rows) ? factTable(caption, rows!) : el('p', { class: 'missing' }, plotMessages.partNotMeasured(caption));
  return el(
    'section',
    { id: 'facts', 'aria-labelledby': 'facts-heading' },
    el('h2', { id: 'facts-heading' }, reportLabels.conditions),
    el('div', { class: 'columns' }, table(reportLabels.settings, report.settings), table(reportLabels.measured, report.facts)),
  );
}

/** Returns the paper's figures of this run, or the demo's sections if there are none. */
function ofPaper(report: Report, playhead?: Playhead): HTMLElement[] {
  if (!hasPoints(report.figures)) return [jointSection(report.joint, playhead), fieldSection(report.field), clockSection(report.clock, playhead)];
  const numbers = report.figures!.map(figure => figure.number);
  return [...(hasPoints(report.claims) ? [claimsSection(report.claims!, numbers)] : []), ...report.figures!.map(figureSection)];
}

function page(report: Report): Node[] {
  const playhead = hasPoints(report.playback?.t) ? new Playhead() : undefined;
  return [
    el('header', {}, el('h1', {}, report.title || reportLabels.title), report.subtitle ? el('p', {}, report.subtitle) : null),
    el(
      'main',
      {},
      el('div', { class: 'first' }, overview(report), errorSection(report.error, playhead)),
      plotHint(),
      playhead ? new Playback(report.playback!, playhead).element : null,
      ...ofPaper(report, playhead),
      latencySection(report.latency),
      report.range ? rangeSection(report.range, playhead) : null,
      facts(report),
    ),
    credit(creditMessages.report),
  ];
}

const report = readReport();
document.title = report.title || reportLabels.title;
byId('page').replaceChildren(...page(report));
listTerms(byId('page'));

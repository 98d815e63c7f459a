import { el } from '../dom';
import { figuresLabels, PAPER, paperLabels } from '../messages/report';
import type { DrawingData, FigureData } from './data';
import { plotBlocks } from './plots';
import { dataTable, textTable } from './tables';
import { text } from './text';
import { badge, criteria } from './verdict';

export function anchorOf(number: string): string {
  return `fig-${number}`;
}

/** Creates the section of a figure: the paper's claim and the measured result, then plots or drawings with their numbers. */
export function figureSection(figure: FigureData): HTMLElement {
  const id = anchorOf(figure.number);
  const heading = `${id}-heading`;
  const name = paperLabels.figure(figure.number);
  const pictures = [
    ...plotBlocks(figure.plots, name),
    figure.drawings.length > 0 ? el('div', { class: 'drawings' }, ...figure.drawings.map(drawing)) : null,
  ];
  return el(
    'section',
    { id, class: 'figure', 'aria-labelledby': heading },
    el('h2', { id: heading }, `${name}: ${figure.title}`, ' ', badge(figure.verdict)),
    el(
      'div',
      { class: figure.drawings.length > 0 ? '' : 'beside' },
      el(
        'div',
        { class: 'words' },
        el('h3', {}, figuresLabels.paperSays),
        el('p', {}, ...text(figure.claim), ' ', el('a', { class: 'source', href: PAPER }, `(${paperLabels.citation(name)})`)),
        el('h3', {}, figuresLabels.weMeasure),
        criteria(figure.criteria),
        figure.beyond ? el('h3', {}, figuresLabels.beyond) : null,
        figure.beyond ? el('p', {}, ...text(figure.beyond)) : null,
      ),
      el('div', { class: 'pictures' }, ...pictures),
    ),
    figure.summary ? textTable(figure.summary) : null,
    el('p', { class: 'conditions' }, ...text(figure.conditions)),
    el('details', {}, el('summary', {}, figuresLabels.dataFile(figure.file)), dataTable(figuresLabels.dataOf(name), figure.table)),
  );
}

function drawing({ title, description, svg }: DrawingData): HTMLElement {
  const picture = document.importNode(new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement, true);
  picture.setAttribute('role', 'img');
  picture.setAttribute('aria-label', description);
  return el('figure', {}, el('figcaption', {}, title), picture);
}

import { el } from '../dom';
import { figuresLabels, paperLabels } from '../messages/report';
import { header, scrollable } from '../tables';
import type { FigureData } from './data';
import { anchorOf } from './section';
import { badge } from './verdict';

/** Lists the figures with their verdicts. Each entry links to the figure's section. */
export function contents(figures: FigureData[]): HTMLElement {
  const caption = figuresLabels.figures;
  const rows = figures.map(f =>
    el(
      'tr',
      {},
      el('th', { scope: 'row' }, el('a', { href: `#${anchorOf(f.number)}` }, paperLabels.figure(f.number))),
      el('td', {}, f.title),
      el('td', {}, badge(f.verdict)),
    ),
  );
  return el(
    'nav',
    { 'aria-label': figuresLabels.contents },
    scrollable(
      caption,
      el(
        'table',
        { class: 'contents' },
        el('caption', {}, caption),
        header(figuresLabels.figure, figuresLabels.title, figuresLabels.claim),
        el('tbody', {}, ...rows),
      ),
    ),
  );
}

import { el } from '../dom';
import { figuresLabels, paperLabels } from '../messages/report';
import { tableOf } from '../tables';
import type { FigureData } from './data';
import { anchorOf } from './section';
import { badge } from './verdict';

/** Lists the figures with their verdicts. Each entry links to the figure's section. */
export function contents(figures: FigureData[]): HTMLElement {
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
    tableOf(figuresLabels.figures, { class: 'contents' }, [figuresLabels.figure, figuresLabels.title, figuresLabels.claim], rows),
  );
}

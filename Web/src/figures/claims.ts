import type { ClaimData } from '../data';
import { el } from '../dom';
import { figuresLabels, paperLabels } from '../messages/report';
import { tableOf } from '../tables';
import { anchorOf } from './section';
import { text } from './text';
import { badge } from './verdict';

/**
 * Lists the paper's claims with the paper's values, the measured values and the verdicts.
 * @param figures Numbers of the figures on the page. Claims of other figures have no link.
 */
export function claimsSection(claims: ClaimData[], figures: string[]): HTMLElement {
  const caption = figuresLabels.claimsAndRun;
  const name = (figure: string) => {
    const words = paperLabels.figure(figure);
    return figures.includes(figure) ? el('a', { href: `#${anchorOf(figure)}` }, words) : words;
  };
  const labels = [figuresLabels.figure, figuresLabels.claim, figuresLabels.paper, figuresLabels.measured, figuresLabels.verdict];
  const rows = claims.map(c =>
    el(
      'tr',
      {},
      el('th', { scope: 'row' }, name(c.figure)),
      el('td', {}, ...text(c.claim)),
      el('td', {}, c.paper || '–'),
      el('td', {}, c.measured),
      el('td', {}, badge(c.verdict)),
    ),
  );
  return el(
    'section',
    { id: 'claims', 'aria-labelledby': 'claims-heading' },
    el('h2', { id: 'claims-heading' }, caption),
    tableOf(figuresLabels.claims, { class: 'contents' }, labels, rows, caption),
  );
}

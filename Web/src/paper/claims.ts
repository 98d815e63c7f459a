import type { ClaimData } from '../data';
import { el } from '../dom';
import { figuresLabels } from '../messages/report';
import { header, scrollable } from '../tables';
import { anchorOf } from './section';
import { text } from './text';
import { badge } from './verdict';

/** Lists the paper's claims with its numbers, this run's numbers and the verdicts. */
export function claimsSection(claims: ClaimData[]): HTMLElement {
  const caption = figuresLabels.claimsAndRun;
  const rows = claims.map(c =>
    el(
      'tr',
      {},
      el('th', { scope: 'row' }, el('a', { href: `#${anchorOf(c.figure)}` }, `Fig. ${c.figure}`)),
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
    scrollable(
      caption,
      el(
        'table',
        { class: 'contents' },
        el('caption', {}, figuresLabels.claims),
        header('Figure', 'Claim', 'Paper', 'Measured', 'Verdict'),
        el('tbody', {}, ...rows),
      ),
    ),
  );
}

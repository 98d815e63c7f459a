import { el } from '../dom';
import type { CriterionData, Verdict } from './data';
import { text } from './text';

const CLASSES: Record<Verdict, string> = { holds: 'met', 'holds partly': 'partly', 'does not hold': 'unmet', 'not measured': 'unmet' };

/** Shows a verdict in words. Shape and colour only repeat it. */
export function badge(verdict: Verdict): HTMLElement {
  return el('span', { class: `badge ${CLASSES[verdict]}` }, verdict);
}

export function criteria(list: CriterionData[]): HTMLElement {
  return el(
    'ul',
    { class: 'criteria' },
    ...list.map(c =>
      el(
        'li',
        { class: c.is_met ? 'met' : 'unmet' },
        el('span', { class: 'sign', role: 'img', 'aria-label': c.is_met ? 'met:' : 'not met:' }, c.is_met ? '✓' : '✗'),
        el('span', {}, ...text(c.statement), ' ', el('span', { class: 'measured' }, ...text(`Measured: ${c.measured}.`))),
      ),
    ),
  );
}

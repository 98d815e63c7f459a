import { el } from '../dom';
import { criterionLabels } from '../messages/report';
import type { CriterionData, Verdict } from './data';
import { text } from './text';

const CLASSES: Record<Verdict, string> = {
  holds: 'met',
  'holds partly': 'partly',
  'does not hold': 'unmet',
  undecided: 'partly',
  'not measured': 'unmet',
};

/** Creates a badge with the words of a verdict. Shape and colour only repeat the words. */
export function badge(verdict: Verdict): HTMLElement {
  return el('span', { class: `badge ${CLASSES[verdict]}` }, verdict);
}

function signOf({ is_met: isMet, is_undecided: isUndecided }: CriterionData): { css: string; sign: string; words: string } {
  if (isUndecided) return { css: 'undecided', sign: '?', words: criterionLabels.undecided };
  if (isMet == null) return { css: 'unmeasured', sign: '–', words: criterionLabels.notMeasured };
  return isMet ? { css: 'met', sign: '✓', words: criterionLabels.met } : { css: 'unmet', sign: '✗', words: criterionLabels.notMet };
}

export function criteria(list: CriterionData[]): HTMLElement {
  return el(
    'ul',
    { class: 'criteria' },
    ...list.map(c => {
      const { css, sign, words } = signOf(c);
      const measured = c.is_met == null && !c.is_undecided ? c.measured : criterionLabels.measured(c.measured);
      return el(
        'li',
        { class: css },
        el('span', { class: 'sign', role: 'img', 'aria-label': `${words}:` }, sign),
        el('span', {}, ...text(c.statement), ' ', el('span', { class: 'measured' }, ...text(`${measured}.`))),
      );
    }),
  );
}

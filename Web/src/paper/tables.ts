import type { Value } from '../data';
import { el } from '../dom';
import { format } from '../numbers';
import { header, row, scrollable } from '../tables';
import type { SummaryData } from './data';

export function textTable({ caption, columns, rows }: SummaryData): HTMLElement {
  return scrollable(
    caption,
    el(
      'table',
      { class: 'numbers' },
      el('caption', {}, caption),
      header(...columns),
      el('tbody', {}, ...rows.map(([label, ...cells]) => row(label, ...cells))),
    ),
  );
}

export function dataTable(caption: string, { columns, rows }: { columns: string[]; rows: Value[][] }): HTMLElement {
  return scrollable(
    caption,
    el(
      'table',
      { class: 'numbers data' },
      el('caption', {}, caption),
      header(...columns),
      el('tbody', {}, ...rows.map(([first, ...rest]) => row(format(first), ...rest.map(v => format(v))))),
    ),
  );
}

import type { Value } from '../data';
import { format } from '../numbers';
import { row, tableOf } from '../tables';
import type { SummaryData } from './data';

export function textTable({ caption, columns, rows }: SummaryData): HTMLElement {
  const body = rows.map(([label, ...cells]) => row(label, ...cells));
  return tableOf(caption, { class: 'numbers' }, columns, body);
}

export function dataTable(caption: string, { columns, rows }: { columns: string[]; rows: Value[][] }): HTMLElement {
  const body = rows.map(([first, ...rest]) => row(format(first), ...rest.map(v => format(v))));
  return tableOf(caption, { class: 'numbers data' }, columns, body);
}

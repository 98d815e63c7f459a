import type { Fact, SummaryRow } from './data';
import { el } from './dom';
import { tableLabels } from './messages/tables';
import { format, type Statistics } from './numbers';
import { term } from './terms';

/**
 * Wraps a table in an element that scrolls if the table is wider than the window. It can be scrolled with the keyboard. Its name differs from that of
 * a section with the same heading, so that a list of landmarks has no name twice.
 */
export function scrollable(caption: string, table: HTMLTableElement): HTMLElement {
  return el('div', { class: 'table', role: 'region', 'aria-label': tableLabels.region(caption), tabindex: 0 }, table);
}

/**
 * Creates a table in an element that scrolls.
 * @param name Name of the scrolling element.
 */
export function tableOf(caption: string, style: { class: string }, labels: string[], rows: HTMLElement[], name = caption): HTMLElement {
  return scrollable(name, el('table', style, el('caption', {}, caption), header(labels), el('tbody', {}, ...rows)));
}

function header(labels: string[]): HTMLElement {
  return el('thead', {}, el('tr', {}, ...labels.map(label => el('th', { scope: 'col' }, term(label)))));
}

export function row(label: string, ...cells: string[]): HTMLElement {
  return el('tr', {}, el('th', { scope: 'row' }, term(label)), ...cells.map(cell => el('td', {}, cell)));
}

export function summaryTable(rows: SummaryRow[]): HTMLElement {
  const labels = [tableLabels.quantity, tableLabels.uncompensated, tableLabels.compensated, tableLabels.change];
  const body = rows.map(r => row(r.unit ? `${r.label} (${r.unit})` : r.label, format(r.uncompensated), format(r.compensated), change(r)));
  return tableOf(tableLabels.comparison, { class: 'numbers' }, labels, body);
}

function change(row: SummaryRow): string {
  const reduction = reductionOf(row);
  return reduction == null ? '–' : `${reduction > 0 ? '\u2212' : '+'}${format(Math.abs(100 * reduction), '%')}`;
}

/** Returns 1 − compensated / uncompensated; null if a value is missing or the uncompensated value is 0. */
export function reductionOf(row: SummaryRow): number | null {
  const { uncompensated, compensated } = row;
  return uncompensated == null || compensated == null || uncompensated === 0 ? null : 1 - compensated / uncompensated;
}

export function factTable(caption: string, facts: Fact[], labels = [tableLabels.name, tableLabels.value]): HTMLElement {
  const body = facts.map(([label, value]) => row(String(label), value == null ? '–' : String(value)));
  return tableOf(caption, { class: 'facts' }, labels, body);
}

export function statisticsTable(name: string, unit: string, rows: [string, Statistics | null][]): HTMLElement {
  const labels = [tableLabels.signal, tableLabels.points, tableLabels.minimum, tableLabels.maximum, tableLabels.rms, tableLabels.p95];
  const body = rows.map(([label, s]) => row(label, format(s?.count ?? 0), format(s?.min), format(s?.max), format(s?.rms), format(s?.p95)));
  return tableOf(`${name} (${unit})`, { class: 'numbers' }, labels, body);
}

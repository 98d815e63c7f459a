import { el, setText } from '../dom';
import { scrollable } from '../tables';
import { columnLabels, meanings } from '../messages/terms';
import { term } from '../terms';

export interface Column<T> {
  label: string;
  /** Returns the text of the cell. */
  cell: (item: T) => string;
  /** Whether the text is aligned to the right. */
  isNumber?: boolean;
  /** Whether the text can wrap. */
  isLong?: boolean;
  /** Returns the level, which determines the style. The cell becomes a badge with an icon unless the level is empty. */
  level?: (item: T) => string;
}

/** A table that reuses the elements of its rows when the text changes, so that focus and scroll position are kept. */
export class LiveTable<T> {
  readonly element: HTMLElement;
  private readonly table: HTMLTableElement;
  private readonly rows = new Map<string, { body: HTMLElement; cells: HTMLElement[]; note: HTMLElement }>();
  private readonly none: HTMLElement;

  /**
   * @param key Returns the unique key of a row.
   * @param head Creates the content of a row's first cell. Called once per row.
   * @param noteOf Returns text that is too long for a column. It is shown in a line below the row unless it is empty.
   */
  constructor(
    private readonly caption: string,
    private readonly columns: Column<T>[],
    private readonly key: (item: T) => string,
    none: string,
    private readonly head: (key: string) => Node | string = name => name,
    first = columnLabels.name,
    private readonly noteOf: (item: T) => string = () => '',
  ) {
    // Hidden until the items are known, because the text states that there are none.
    this.none = el('p', { class: 'missing', hidden: true }, none);
    const labels = [
      el('th', { scope: 'col' }, term(first, meanings)),
      ...columns.map(c => el('th', { scope: 'col', class: c.isNumber ? 'n' : null }, term(c.label, meanings))),
    ];
    this.table = el('table', {}, el('caption', {}, caption), el('thead', {}, el('tr', {}, ...labels)));
    this.element = el('div', { class: 'live' }, scrollable(this.caption, this.table), this.none);
  }

  show(items: T[]): void {
    const wanted = new Set(items.map(this.key));
    for (const [key, { body }] of this.rows) {
      if (wanted.has(key)) continue;
      body.remove();
      this.rows.delete(key);
    }
    items.forEach((item, place) => this.fill(item, place));
    (this.element.firstElementChild as HTMLElement).hidden = items.length === 0;
    this.none.hidden = items.length > 0;
  }

  private fill(item: T, place: number): void {
    const key = this.key(item);
    let entry = this.rows.get(key);
    if (!entry) this.rows.set(key, (entry = this.entryOf(key)));
    const { body, cells, note } = entry;
    const present = this.table.tBodies[place];
    if (present !== body) this.table.insertBefore(body, present ?? null);
    this.columns.forEach((column, i) => {
      const level = column.level?.(item) ?? '';
      // The badge is a separate element within the cell, so that the cell keeps its role in the table.
      const badge = column.level ? cells[i].firstElementChild! : cells[i];
      if (column.level) badge.className = level ? `level ${level}` : '';
      setText(badge, column.cell(item));
    });
    const text = this.noteOf(item);
    setText(note.querySelector('p')!, text);
    note.hidden = text === '';
  }

  // Each item has its own table body, so that its note moves together with it.
  private entryOf(key: string) {
    const cells = this.columns.map(c => el('td', { class: c.isNumber ? 'n' : c.isLong ? 'long' : null }, c.level ? el('span') : null));
    const note = el('tr', { class: 'note', hidden: true }, el('td', { colspan: 1 + cells.length }, el('p')));
    return { body: el('tbody', {}, el('tr', {}, el('th', { scope: 'row' }, this.head(key)), ...cells), note), cells, note };
  }
}

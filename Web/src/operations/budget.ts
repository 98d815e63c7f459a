import { el } from '../dom';
import { emptyMessages, hopMeanings } from '../messages/operations';
import { captionLabels, columnLabels } from '../messages/terms';
import { format } from '../numbers';
import { type Column, LiveTable } from './liveTable';
import { type Headset, HOPS } from './state';

/** Shows the hops of the latency of each headset, as numbers and as a bar. */
export class Budget {
  readonly element: HTMLElement;
  private readonly bars = new Map<string, HTMLElement>();
  private readonly table: LiveTable<Headset>;

  constructor() {
    const columns: Column<Headset>[] = HOPS.map(hop => ({ label: columnLabels.hop(hop), isNumber: true, cell: h => format(h.budget_ms?.[hop]) }));
    this.table = new LiveTable<Headset>(
      captionLabels.hops,
      [...columns, { label: columnLabels.total, isNumber: true, cell: h => format(totalOf(h)) }],
      headset => headset.name,
      emptyMessages.latencies,
      name => this.barOf(name),
      columnLabels.headset,
    );
    const legend = HOPS.map(hop => el('li', {}, el('span', { class: `hop ${hop}`, 'aria-hidden': 'true' }), `${hop}: ${hopMeanings[hop]}`));
    this.element = el('div', {}, el('ul', { class: 'hops' }, ...legend), this.table.element);
  }

  show(headsets: Headset[]): void {
    const known = headsets.filter(h => totalOf(h) != null);
    this.table.show(known);
    const longest = Math.max(1, ...known.map(h => totalOf(h)!));
    for (const headset of known) {
      const spans = this.bars.get(headset.name)!.children as HTMLCollectionOf<HTMLElement>;
      HOPS.forEach((hop, i) => {
        spans[i].style.width = `${(100 * (headset.budget_ms?.[hop] ?? 0)) / longest}%`;
      });
    }
    for (const name of this.bars.keys()) if (!known.some(h => h.name === name)) this.bars.delete(name);
  }

  private barOf(name: string): Node {
    const bar = el('div', { class: 'stack', 'aria-hidden': 'true' }, ...HOPS.map(hop => el('span', { class: `hop ${hop}` })));
    this.bars.set(name, bar);
    return el('div', {}, name, bar);
  }
}

/** Returns the sum of the known parts of a headset's latency; null if none is known. */
function totalOf(headset: Headset): number | null {
  const known = HOPS.map(hop => headset.budget_ms?.[hop]).filter((v): v is number => v != null);
  return known.length === 0 ? null : known.reduce((a, b) => a + b, 0);
}

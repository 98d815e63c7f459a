import { el } from '../dom';
import { emptyMessages, hopMeanings } from '../messages/operations';
import { captionLabels, columnLabels } from '../messages/terms';
import { format } from '../numbers';
import { type Column, LiveTable } from './liveTable';
import { type Headset, HOPS, numberOf } from './state';

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
    const known = headsets.filter(h => HOPS.some(hop => h.budget_ms?.[hop] != null));
    this.table.show(known);
    const longest = Math.max(1, ...known.map(h => totalOf(h) ?? 0));
    for (const headset of known) {
      const spans = this.bars.get(headset.name)!.children as HTMLCollectionOf<HTMLElement>;
      HOPS.forEach((hop, i) => {
        // A bar without one of the hops would look like that of a shorter latency.
        spans[i].style.width = isComplete(headset) ? `${(100 * Math.max(0, headset.budget_ms?.[hop] ?? 0)) / longest}%` : '0';
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

/** Returns the end-to-end latency of a headset, which is the sum of the hops; null if a part of it is unknown. */
function totalOf(headset: Headset): number | null {
  const [application, visualisation] = [numberOf(headset, 'l_app_ms'), numberOf(headset, 'l_visu_ms')];
  return application == null || visualisation == null ? null : application + visualisation;
}

/** Returns whether the hops add up to the end-to-end latency. Without the render time, the last hop contains it. */
const isComplete = (headset: Headset) => HOPS.every(hop => hop === 'render' || headset.budget_ms?.[hop] != null);

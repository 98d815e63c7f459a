import { el } from '../dom';
import { emptyMessages, operationsLabels } from '../messages/operations';
import { LiveTable } from './liveTable';
import { eventWords } from './overall';
import type { StatusEvent } from './state';
import { lengthWords, localTime } from './times';

/** Shows the faults with their start and end in a table. Active faults come first. */
export class Events {
  readonly element: HTMLElement;
  private readonly table = new LiveTable<StatusEvent>(
    'Events',
    [
      { label: 'State', cell: e => (e.until_utc ? 'ended' : 'active'), level: e => (e.until_utc ? 'over' : e.level) },
      { label: 'Start', cell: e => localTime(e.since_utc) },
      { label: 'End', cell: e => (e.until_utc ? localTime(e.until_utc) : '–') },
      { label: 'Duration', cell: e => (e.until_utc ? lengthWords((Date.parse(e.until_utc) - Date.parse(e.since_utc)) / 1000) : '–') },
      { label: 'Event', cell: e => eventWords(e), isLong: true },
    ],
    e => String(e.id),
    emptyMessages.events,
    undefined,
    'No.',
  );

  constructor() {
    const link = (format: string) =>
      el('a', { href: `/operations/events?format=${format}`, download: `nowpose-events.${format}` }, format.toUpperCase());
    this.element = el(
      'div',
      {},
      this.table.element,
      el('p', { class: 'downloads' }, `${operationsLabels.downloadEvents} `, link('csv'), ' or ', link('json'), '.'),
    );
  }

  show(events: StatusEvent[]): void {
    this.table.show([...events.filter(e => !e.until_utc), ...events.filter(e => e.until_utc)]);
  }
}

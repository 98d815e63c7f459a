import { el } from '../dom';
import { emptyMessages, operationsLabels } from '../messages/operations';
import { levelLabels, stateLabels } from '../messages/states';
import { captionLabels, columnLabels } from '../messages/terms';
import { LiveTable } from './liveTable';
import { eventWords } from './overall';
import type { StatusEvent } from './state';
import { lengthWords, localTime } from './times';

/** Shows the faults with their start and end in a table. Active faults come first. */
export class Events {
  readonly element: HTMLElement;
  private readonly table = new LiveTable<StatusEvent>(
    captionLabels.events,
    [
      {
        label: columnLabels.state,
        cell: e => stateLabels.event(levelLabels[e.level], e.until_utc ? stateLabels.ended : stateLabels.active),
        level: e => (e.until_utc ? 'over' : e.level),
      },
      { label: columnLabels.start, cell: e => localTime(e.since_utc) },
      { label: columnLabels.end, cell: e => (e.until_utc ? localTime(e.until_utc) : '–') },
      { label: columnLabels.duration, cell: e => (e.until_utc ? lengthWords((Date.parse(e.until_utc) - Date.parse(e.since_utc)) / 1000) : '–') },
      { label: columnLabels.event, cell: e => eventWords(e), isLong: true },
    ],
    e => String(e.id),
    emptyMessages.events,
    undefined,
    columnLabels.number,
  );

  constructor() {
    const link = (format: string) =>
      el('a', { href: `/operations/events?format=${format}`, download: `nowpose-events.${format}` }, format.toUpperCase());
    this.element = el(
      'div',
      {},
      this.table.element,
      el('p', { class: 'downloads' }, `${operationsLabels.downloadEvents} `, link('csv'), ` ${operationsLabels.or} `, link('json'), '.'),
    );
  }

  show(events: StatusEvent[]): void {
    this.table.show([...events.filter(e => !e.until_utc), ...events.filter(e => e.until_utc)]);
  }
}

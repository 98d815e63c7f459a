import { byId, el, setText } from '../dom';
import { ask } from '../gateway';
import { emptyMessages, operationsMessages, recorderLabels } from '../messages/operations';
import { captionLabels, columnLabels } from '../messages/terms';
import { format } from '../numbers';
import { LiveTable } from './liveTable';
import type { State, StatusEvent, StoredRecording } from './state';
import { localTime } from './times';

const POLL_MS = 5000;

/** Maximum number of deleted recordings that are named. The list of events has the others. */
const MAX_DELETED = 5;

/** Lists the recordings in the gateway's folder with their sizes and download links. Only for operators. */
export class Recordings {
  private readonly note = byId('recordings-note');
  private readonly table = new LiveTable<StoredRecording>(
    captionLabels.recordings,
    [
      { label: columnLabels.size, isNumber: true, cell: file => format(file.bytes / 1e6) },
      { label: columnLabels.lastWritten, cell: file => localTime(file.changed_utc) },
    ],
    file => file.name,
    emptyMessages.recordings,
    linkTo,
    columnLabels.file,
  );
  private listed = new Set<string>();
  private trouble = '';
  private asked = -Infinity;
  private file = '';

  constructor() {
    byId('recordings').append(this.table.element);
  }

  show({ recording, role, events }: State): void {
    const can = recording?.can ?? false;
    const may = role === 'operator';
    byId('recordings-section').hidden = !can;
    this.table.element.hidden = !may;
    if (!can) return;
    if (!may) return setText(this.note, operationsMessages.listAsOperator);
    setText(this.note, this.trouble || deletedWords(events ?? [], this.listed));
    const file = `${recording?.on} ${recording?.file}`;
    if (file === this.file && performance.now() - this.asked < POLL_MS) return;
    this.file = file;
    this.asked = performance.now();
    void this.read();
  }

  private async read(): Promise<void> {
    const answer = await ask<StoredRecording[]>('/operations/recordings');
    this.trouble = 'trouble' in answer ? operationsMessages.notListed(answer.trouble) : '';
    if ('trouble' in answer) return;
    this.listed = new Set(answer.value.map(file => file.name));
    this.table.show(answer.value);
  }
}

/**
 * Names the recordings that were deleted last. Uses the gateway's events, because a file can also be missing from the list because newer files fill it,
 * or because the gateway was started with another folder.
 */
function deletedWords(events: StatusEvent[], listed: Set<string>): string {
  const names = events
    .filter(({ kind, what, which }) => kind === 'recording' && what === recorderLabels.wasDeleted && !listed.has(which))
    .map(({ which }) => which);
  return names.length === 0 ? '' : recorderLabels.deleted([...new Set(names)].slice(0, MAX_DELETED).join(', '));
}

function linkTo(name: string): Node {
  return el('a', { href: `/operations/recordings/${encodeURIComponent(name)}`, download: name }, name);
}

import { el } from '../dom';
import { emptyMessages, operationsMessages, recorderLabels } from '../messages/operations';
import { captionLabels, columnLabels } from '../messages/terms';
import { format } from '../numbers';
import { byId } from '../pairing/elements';
import { LiveTable, setText } from './liveTable';
import { ask, type State, type StoredRecording } from './state';
import { localTime } from './times';

const POLL_MS = 5000;

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
  private deleted = '';
  private asked = -Infinity;
  private file = '';

  constructor() {
    byId('recordings').append(this.table.element);
  }

  show({ recording, role }: State): void {
    const can = recording?.can ?? false;
    const may = role === 'operator';
    byId('recordings-section').hidden = !can;
    this.table.element.hidden = !may;
    if (!can) return;
    if (!may) return setText(this.note, operationsMessages.listAsOperator);
    const file = `${recording?.on} ${recording?.file}`;
    if (file === this.file && performance.now() - this.asked < POLL_MS) return;
    this.file = file;
    this.asked = performance.now();
    void this.read();
  }

  private async read(): Promise<void> {
    const answer = await ask<StoredRecording[]>('recordings');
    if ('trouble' in answer) return setText(this.note, operationsMessages.notListed(answer.trouble));
    const names = new Set(answer.value.map(file => file.name));
    const deleted = [...this.listed].filter(name => !names.has(name));
    // The names of deleted files stay on the page until further files are deleted.
    if (deleted.length > 0) this.deleted = recorderLabels.deleted(deleted.join(', '));
    setText(this.note, this.deleted);
    this.listed = names;
    this.table.show(answer.value);
  }
}

function linkTo(name: string): Node {
  return el('a', { href: `/operations/recordings/${encodeURIComponent(name)}`, download: name }, name);
}

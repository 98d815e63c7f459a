import { el } from '../dom';
import { emptyMessages, operationsLabels } from '../messages/operations';
import { captionLabels, columnLabels } from '../messages/terms';
import { LiveTable } from './liveTable';
import { type CellFrame, type Signal, type State } from './state';
import { lengthWords, localTime } from './times';

const FAULTS = ['refused', 'fault', 'missing'];

const levelOf = (state: string) => (state === 'live' || state === 'stationary' ? 'ok' : FAULTS.includes(state) ? 'error' : 'warning');

/** Returns the reason for the state of an object or signal that is not current, and the start of the state. */
function noteOf({ reason, since_utc: since }: CellFrame | Signal): string {
  return reason && since ? operationsLabels.since(reason, localTime(since)) : (reason ?? '');
}

/** Shows the cell's objects and signals in two tables. */
export class Cell {
  readonly element: HTMLElement;
  private readonly frames = new LiveTable<CellFrame>(
    captionLabels.objects,
    [
      { label: columnLabels.state, cell: frame => frame.state, level: frame => levelOf(frame.state) },
      { label: columnLabels.parent, cell: frame => frame.parent ?? '–' },
      { label: columnLabels.age, cell: frame => lengthWords(frame.age_s), isNumber: true },
      { label: columnLabels.source, cell: frame => frame.source },
    ],
    frame => frame.name,
    emptyMessages.frames,
    undefined,
    undefined,
    noteOf,
  );
  private readonly signals = new LiveTable<Signal>(
    captionLabels.signals,
    [
      { label: columnLabels.state, cell: signal => signal.state, level: signal => levelOf(signal.state) },
      { label: columnLabels.value, cell: signal => (signal.value == null ? '–' : String(signal.value)), isNumber: true },
      { label: columnLabels.valueFor, cell: signal => lengthWords(signal.age_s), isNumber: true },
      { label: columnLabels.source, cell: signal => signal.source },
    ],
    signal => signal.name,
    emptyMessages.signals,
    undefined,
    undefined,
    noteOf,
  );

  constructor() {
    this.element = el('div', {}, this.frames.element, this.signals.element);
  }

  show(state: State): void {
    this.frames.show(state.frames ?? []);
    this.signals.show(state.signals ?? []);
  }
}

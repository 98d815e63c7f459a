import { el } from '../dom';
import { emptyMessages } from '../messages/operations';
import { LiveTable } from './liveTable';
import { type CellFrame, type Signal, type State } from './state';

const seconds = (age: number | null | undefined) => (age == null ? '–' : age < 10 ? `${age.toFixed(1)}\u00a0s` : `${Math.round(age)}\u00a0s`);

const FAULTS = ['refused', 'fault', 'missing'];

const levelOf = (state: string) => (state === 'live' || state === 'stationary' ? 'ok' : FAULTS.includes(state) ? 'error' : 'warning');

/** Shows the cell's objects and signals in two tables. */
export class Cell {
  readonly element: HTMLElement;
  private readonly frames = new LiveTable<CellFrame>(
    'Objects',
    [
      { label: 'State', cell: frame => frame.state, level: frame => levelOf(frame.state) },
      { label: 'Parent', cell: frame => frame.parent ?? '–' },
      { label: 'Age', cell: frame => seconds(frame.age_s), isNumber: true },
      { label: 'Source', cell: frame => frame.source },
    ],
    frame => frame.name,
    emptyMessages.frames,
    undefined,
    undefined,
    frame => frame.reason ?? '',
  );
  private readonly signals = new LiveTable<Signal>(
    'Signals',
    [
      { label: 'State', cell: signal => signal.state, level: signal => levelOf(signal.state) },
      { label: 'Value', cell: signal => (signal.value == null ? '–' : String(signal.value)), isNumber: true },
      { label: 'For', cell: signal => seconds(signal.age_s), isNumber: true },
      { label: 'Source', cell: signal => signal.source },
    ],
    signal => signal.name,
    emptyMessages.signals,
    undefined,
    undefined,
    signal => signal.reason ?? '',
  );

  constructor() {
    this.element = el('div', {}, this.frames.element, this.signals.element);
  }

  show(state: State): void {
    this.frames.show(state.frames ?? []);
    this.signals.show(state.signals ?? []);
  }
}

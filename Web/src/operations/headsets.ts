import { el } from '../dom';
import { emptyMessages, operationsLabels } from '../messages/operations';
import { stateLabels } from '../messages/states';
import { captionLabels, columnLabels } from '../messages/terms';
import { format } from '../numbers';
import type { HeadsetKey } from './headsetKeys';
import { LiveTable } from './liveTable';
import { type Headset, isSilent, numberOf, textOf } from './state';
import { stateWords } from './stateWords';
import { lengthWords } from './times';

const number = (label: string, key: HeadsetKey, digits = (v: number) => v) => ({
  label,
  isNumber: true,
  cell: (headset: Headset) => {
    const v = numberOf(headset, key);
    return format(v == null ? null : digits(v));
  },
});

/** Shows the diagnostics of the headsets in a table. One headset is selected for the plots and the view of the robot. */
export class Headsets {
  readonly element: HTMLElement;
  private chosenName: string | null = null;
  private readonly table: LiveTable<Headset>;

  constructor(private readonly chosenChanged: () => void) {
    this.table = new LiveTable<Headset>(
      captionLabels.headsets,
      [
        { label: columnLabels.clock, cell: headset => stateOf(headset) },
        { label: columnLabels.pose, cell: poseOf, level: poseLevel },
        number(columnLabels.current, 'current_share', v => 100 * v),
        number(columnLabels.error, 'error_mm'),
        number(columnLabels.uncompensated, 'error_mm_hold'),
        number(columnLabels.reduction, 'reduction', v => 100 * v),
        number(columnLabels.clockWithin, 'error_bound_us'),
        number(columnLabels.roundTrip, 'rtt_ms'),
        number(columnLabels.applicationLatency, 'l_app_ms'),
        number(columnLabels.visualisationLatency, 'l_visu_ms'),
        { label: columnLabels.renderTime, cell: headset => rangeOf(headset) },
        number(columnLabels.samples, 'samples'),
        number(columnLabels.dropped, 'dropped'),
      ],
      headset => headset.name,
      emptyMessages.headsets,
      name => this.choiceOf(name),
      columnLabels.shown,
      noteOf,
    );
    this.element = this.table.element;
  }

  get chosen(): string | null {
    return this.chosenName;
  }

  show(headsets: Headset[]): void {
    this.table.show(headsets);
    // Keeps the selection while the headset is not connected, because its history would be lost.
    if (headsets.length > 0) this.choose(this.chosenName ?? headsets[0].name);
  }

  private choose(name: string): void {
    if (name === this.chosenName) return;
    this.chosenName = name;
    for (const input of this.element.querySelectorAll('input')) input.checked = input.value === name;
    this.chosenChanged();
  }

  private choiceOf(name: string): Node {
    const input = el('input', { type: 'radio', name: 'headset', value: name, checked: name === this.chosenName });
    input.addEventListener('change', () => this.choose(name));
    return el('label', {}, input, name);
  }
}

function stateOf(headset: Headset): string {
  return isSilent(headset) ? stateLabels.silent(lengthWords(headset.seen_s_ago)) : withError(headset, 'state') || stateLabels.notKnown;
}

/** Returns the state of the clock or of the pose as text. For a coarse clock, adds the error that the headset reports. */
function withError(headset: Headset, key: HeadsetKey): string {
  return stateWords(textOf(headset, key), numberOf(headset, 'estimated_error_us'), numberOf(headset, 'error_bound_us'));
}

function poseOf(headset: Headset): string {
  return isSilent(headset) ? stateLabels.notKnown : withError(headset, 'pose') || stateLabels.notReported;
}

function poseLevel(headset: Headset): string {
  if (isSilent(headset)) return 'warning';
  const pose = textOf(headset, 'pose');
  return pose === '' ? '' : pose === 'current' || pose === 'coarse' ? 'ok' : 'warning';
}

function noteOf(headset: Headset): string {
  const missing = textOf(headset, 'missing_joints').split(',').filter(Boolean).join(', ');
  const mismatch = textOf(headset, 'profile_mismatch');
  const withheld = textOf(headset, 'error_withheld');
  return [
    missing && operationsLabels.missingJoints(missing),
    ...partsOf(headset, 'object_status/', 'objects_not_current', operationsLabels.object, operationsLabels.objectsNotListed),
    ...partsOf(headset, 'signal_status/', 'signals_not_current', operationsLabels.signal, operationsLabels.signalsNotListed),
    mismatch && operationsLabels.profileMismatch(mismatch),
    withheld && operationsLabels.errorWithheld(withheld),
  ]
    .filter(Boolean)
    .join('; ');
}

/** Returns the objects or signals that are not current on a headset: those that the headset lists, and the number of the others. */
function partsOf(
  headset: Headset,
  prefix: 'object_status/' | 'signal_status/',
  count: HeadsetKey,
  label: (name: string, state: string) => string,
  notListed: (count: number) => string,
): string[] {
  const listed = Object.keys(headset).filter((key): key is HeadsetKey => key.startsWith(prefix));
  const others = (numberOf(headset, count) ?? 0) - listed.length;
  return [...listed.map(key => label(key.slice(prefix.length), textOf(headset, key))), ...(others > 0 ? [notListed(others)] : [])];
}

function rangeOf(headset: Headset): string {
  if (isSilent(headset)) return stateLabels.notKnown;
  const range = textOf(headset, 'range');
  const word = range === 'inside' ? stateLabels.inRange : range === 'outside' ? stateLabels.outOfRange : range || stateLabels.noRange;
  const render = numberOf(headset, 'render_ms');
  return render == null ? word : `${word}, ${format(render, 'ms')}`;
}

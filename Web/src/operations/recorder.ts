import { byId, setText } from '../dom';
import { ask } from '../gateway';
import { operationsMessages, recorderLabels } from '../messages/operations';
import { format } from '../numbers';
import type { Recording, State } from './state';

/** Starts and stops the recorder, and shows its state. */
export class Recorder {
  private readonly button = byId<HTMLButtonElement>('record');
  private isOn = false;

  /** @param changed Called after the recorder has been started or stopped, to request the state again. */
  constructor(changed: () => void) {
    this.button.addEventListener('click', () => void this.turn(changed));
  }

  show({ recording, role }: State): void {
    this.isOn = recording?.on ?? false;
    const may = role === 'operator';
    const can = recording?.can ?? false;
    this.button.hidden = !can;
    this.button.disabled = !may || !can;
    this.button.classList.toggle('on', this.isOn);
    setText(this.button, this.isOn ? recorderLabels.stop : recorderLabels.record);
    setText(byId('recording'), wordsOf(recording, can));
    setText(byId('may-record'), may || !can ? '' : operationsMessages.recordAsOperator);
  }

  private async turn(changed: () => void): Promise<void> {
    // Not disabled, because a disabled button loses the focus.
    if (this.button.ariaDisabled === 'true') return;
    this.button.ariaDisabled = 'true';
    const isWanted = !this.isOn;
    const answer = await ask<Recording>('/operations/recording', { on: String(isWanted) });
    this.button.ariaDisabled = null;
    const trouble = 'trouble' in answer ? answer.trouble : '';
    setText(byId('record-fault'), trouble);
    setText(byId('record-done'), trouble ? '' : isWanted ? recorderLabels.hasStarted : recorderLabels.hasStopped);
    changed();
  }
}

function wordsOf(recording: Recording | null | undefined, can: boolean): string {
  if (!recording || !can) return operationsMessages.noFolder;
  const written = recorderLabels.size(format(recording.lines ?? 0), format((recording.bytes ?? 0) / 1e6, 'MB'), recording.files ?? 0);
  const size = recording.lost ? `${written}, ${recorderLabels.lost(format(recording.lost))}` : written;
  const state = recording.on
    ? recorderLabels.recording(recording.file ?? '', size)
    : recording.file
      ? recorderLabels.stopped(recording.file, recording.deleted ? recorderLabels.fileDeleted : size)
      : recorderLabels.off;
  return recording.problem ? recorderLabels.problem(state, recording.problem) : state;
}

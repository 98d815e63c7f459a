import { operationsLabels, operationsMessages } from '../messages/operations';
import { format } from '../numbers';
import { byId } from '../pairing/elements';
import { setText } from './liveTable';
import { ask, type Recording, type State } from './state';

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
    setText(this.button, this.isOn ? 'Stop recording' : 'Record');
    setText(byId('recording'), wordsOf(recording, can));
    setText(byId('may-record'), may || !can ? '' : operationsMessages.recordAsOperator);
  }

  private async turn(changed: () => void): Promise<void> {
    this.button.disabled = true;
    const answer = await ask<Recording>('recording', { on: String(!this.isOn) });
    setText(byId('record-fault'), 'trouble' in answer ? answer.trouble : '');
    changed();
  }
}

function wordsOf(recording: Recording | null | undefined, can: boolean): string {
  if (!recording || !can) return operationsMessages.noFolder;
  const size = `${format(recording.lines ?? 0)} lines, ${format((recording.bytes ?? 0) / 1e6, 'MB')}`;
  const lost = recording.lost ? `, ${format(recording.lost)} lines are missing` : '';
  const state = recording.on
    ? `recording ${recording.file ?? ''}: ${size}${lost}`
    : recording.file
      ? `stopped; last ${recording.file}: ${recording.deleted ? operationsLabels.recordingDeleted : `${size}${lost}`}`
      : 'off';
  return recording.problem ? `${state}. Problem: ${recording.problem}` : state;
}

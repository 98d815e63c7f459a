import { el } from '../dom';
import { operationsLabels, operationsMessages } from '../messages/operations';
import { byId } from '../pairing/elements';
import { setText } from './liveTable';
import type { Level, State, StatusEvent } from './state';
import { localTime } from './times';

const WORDS: Record<Level | 'unknown', string> = { ok: 'OK', warning: 'Warning', error: 'Fault', unknown: 'Not known' };
const MAX_ALARMS = 8;

/** Shows title, status line and alarms at the top of the page. */
export class Overall {
  private readonly line = byId('status');
  private readonly alarms = byId('alarms');

  show({ cell, host, version, status, events }: State): void {
    setText(byId('cell'), cell || 'Operations');
    setText(byId('place'), [host && `host ${host}`, version && `Nowpose gateway ${version}`].filter(Boolean).join(' · '));
    const level = status?.level ?? 'unknown';
    const title = [cell || 'Operations', host, version && `Nowpose ${version}`].filter(Boolean).join(' · ');
    document.title = level === 'ok' ? title : `${WORDS[level]}: ${title}`;
    this.setLine(level, status ? `${WORDS[level]}: ${status.text}` : operationsMessages.stateNotReported);
    this.showAlarms((events ?? []).filter(event => !event.until_utc));
  }

  /** Shows that the state is unknown. Called when the gateway does not respond. */
  lose(): void {
    document.title = `Not known: ${document.title.replace(/^(Warning|Fault|Not known): /, '')}`;
    this.setLine('unknown', operationsMessages.noState);
  }

  private setLine(level: Level | 'unknown', text: string): void {
    this.line.className = `level ${level}`;
    setText(this.line, text);
  }

  private showAlarms(active: StatusEvent[]): void {
    const worst = [...active].sort((a, b) => Number(b.level === 'error') - Number(a.level === 'error'));
    const lines = worst
      .slice(0, MAX_ALARMS)
      .map(event => ({ level: event.level, text: `${eventWords(event)} – since ${localTime(event.since_utc)}` }));
    if (worst.length > MAX_ALARMS) lines.push({ level: 'warning', text: operationsLabels.moreEvents(worst.length - MAX_ALARMS) });
    this.alarms.hidden = lines.length === 0;
    while (this.alarms.children.length > lines.length) this.alarms.lastElementChild!.remove();
    while (this.alarms.children.length < lines.length) this.alarms.append(el('li'));
    lines.forEach(({ level, text }, i) => {
      this.alarms.children[i].className = `level ${level}`;
      setText(this.alarms.children[i], text);
    });
  }
}

/** Returns the text of an event: fault, place, reason and remedy. Composes it from its parts if the gateway is older and does not send it. */
export function eventWords({ kind, which, what, reason, text }: StatusEvent): string {
  return text ?? `${kind} ${which} ${what}${reason ? `: ${reason}` : ''}`;
}

import { byId, el, setText } from '../dom';
import { operationsLabels, operationsMessages } from '../messages/operations';
import { levelLabels } from '../messages/states';
import type { Level, State, StatusEvent } from './state';
import { localTime, zone } from './times';

const MAX_ALARMS = 8;

/** Shows title, status line and alarms at the top of the page. */
export class Overall {
  private readonly line = byId('status');
  private readonly condition = byId('condition');
  private readonly detail = byId('detail');
  private readonly alarms = byId('alarms');
  private readonly bareTitle = document.title;
  private title = this.bareTitle;

  show({ cell, host, version, status, events }: State): void {
    setText(byId('cell'), cell || operationsLabels.operations);
    const parts = [host && operationsLabels.host(host), version && operationsLabels.gateway(version), operationsLabels.timesIn(zone())];
    setText(byId('place'), parts.filter(Boolean).join(' · '));
    const level = status?.level ?? 'unknown';
    this.title = [cell || operationsLabels.operations, host, version && operationsLabels.product(version)].filter(Boolean).join(' · ');
    document.title = level === 'ok' ? this.title : `${levelLabels[level]}: ${this.title}`;
    this.setLine(
      level,
      status ? operationsLabels.level(levelLabels[level], withSince(status.text, status.since_utc)) : operationsMessages.stateNotReported,
      status && (level === 'ok' ? levelLabels.ok : operationsLabels.level(levelLabels[level], status.text)),
    );
    this.alarms.classList.remove('stale');
    this.showAlarms((events ?? []).filter(event => !event.until_utc));
  }

  /** Removes all data after a log-out, because the next person at a shared computer must not see them. */
  clear(): void {
    setText(byId('cell'), operationsLabels.operations);
    setText(byId('place'), '');
    this.title = this.bareTitle;
    this.alarms.hidden = true;
  }

  /** Shows that the state is unknown. Called when the gateway does not respond. */
  lose(): void {
    document.title = `${levelLabels.unknown}: ${this.title}`;
    this.setLine('unknown', operationsMessages.noState);
    this.alarms.classList.add('stale');
  }

  /**
   * @param condition Start of the text, whose changes a screen reader reads out. It contains no counts while the state is OK, because they change often.
   */
  private setLine(level: Level | 'unknown', text: string, condition = text): void {
    this.line.className = `level ${level}`;
    setText(this.condition, condition);
    setText(this.detail, text.slice(condition.length));
  }

  private showAlarms(active: StatusEvent[]): void {
    const worst = [...active].sort((a, b) => Number(b.level === 'error') - Number(a.level === 'error'));
    const lines = worst
      .slice(0, MAX_ALARMS)
      .map(event => ({ level: event.level, text: operationsLabels.level(levelLabels[event.level], withSince(eventWords(event), event.since_utc)) }));
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

function withSince(text: string, since: string | undefined): string {
  return since ? operationsLabels.since(text, localTime(since)) : text;
}

/** Returns the text of an event: fault, place, reason and remedy. Composes it from its parts if the gateway is older and does not send it. */
export function eventWords({ kind, which, what, reason, text }: StatusEvent): string {
  return text ?? `${kind} ${which} ${what}${reason ? `: ${reason}` : ''}`;
}

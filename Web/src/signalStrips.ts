import { type CellSignal, hasPoints, type Signal, type Value } from './data';
import { el, svg } from './dom';
import { reportLabels, reportMessages } from './messages/report';
import { lastUpTo } from './numbers';

/** Height of a strip in units of its drawing. The true value is in the upper half, the displayed value in the lower half. */
const HEIGHT = 20;
const HALF = HEIGHT / 2;
const BAR = 8;

interface Row {
  signal: CellSignal;
  lamp: HTMLElement;
  words: HTMLElement;
  line: HTMLElement;
}

/** Shows the signals of the cell over the session, and their values at the moment of the playback. */
export class SignalStrips {
  readonly element: HTMLElement;
  private readonly rows: Row[];

  /**
   * @param from Time of the left edge, s.
   * @param to Time of the right edge, s.
   */
  constructor(
    signals: CellSignal[],
    private readonly from: number,
    private readonly to: number,
  ) {
    this.rows = signals.map(signal => ({
      signal,
      lamp: el('span', { class: 'lamp', 'aria-hidden': 'true' }),
      words: el('span', { class: 'words' }),
      line: el('span', { class: 'line' }),
    }));
    this.element = el(
      'div',
      { class: 'signals', role: 'group', 'aria-label': reportLabels.signals },
      el('p', { class: 'claim' }, reportMessages.signals),
      el('ul', {}, ...this.rows.map(row => this.itemOf(row))),
    );
  }

  /** Shows the values at a time, s. */
  show(time: number): void {
    for (const { signal, lamp, words, line } of this.rows) {
      const [truth, displayed] = [valueAt(signal.truth, time), valueAt(signal.displayed, time)];
      lamp.classList.toggle('on', displayed !== null && displayed !== 0);
      lamp.classList.toggle('unknown', displayed === null);
      words.textContent = truth === displayed ? wordOf(displayed) : reportLabels.displayedAndTrue(wordOf(displayed), wordOf(truth));
      line.style.left = `${100 * this.shareOf(time)}%`;
    }
  }

  private itemOf({ signal, lamp, words, line }: Row): HTMLElement {
    const drawing = svg(
      'svg',
      { viewBox: `0 0 1 ${HEIGHT}`, preserveAspectRatio: 'none' },
      ...this.bars(signal.truth, 0),
      ...this.bars(signal.displayed, HALF),
    );
    return el('li', {}, el('span', { class: 'name' }, lamp, signal.name), words, el('div', { class: 'strip', 'aria-hidden': 'true' }, drawing, line));
  }

  // Draws a bar for each interval in which the value is not 0.
  private bars({ t, v }: Signal, top: number): Node[] {
    return t.flatMap((time, i) => {
      if (!v[i]) return [];
      const x = this.shareOf(time);
      return [svg('rect', { class: top === 0 ? 'truth' : 'displayed', x, y: top + 1, width: this.shareOf(t[i + 1] ?? this.to) - x, height: BAR })];
    });
  }

  private shareOf(time: number): number {
    return this.to > this.from ? (time - this.from) / (this.to - this.from) : 0;
  }
}

/** Returns the strips; null for a session without signals. */
export function signalStrips(signals: CellSignal[] | null | undefined, from: number, to: number): SignalStrips | null {
  return hasPoints(signals) ? new SignalStrips(signals!, from, to) : null;
}

// The values are those of Booleans in the messages of a cell, or any numbers.
function wordOf(value: Value): string {
  if (value === null) return reportLabels.valueUnknown;
  return value === 0 ? reportLabels.off : value === 1 ? reportLabels.on : String(value);
}

function valueAt({ t, v }: Signal, time: number): Value {
  const i = lastUpTo(t, time);
  return i < 0 ? null : v[i];
}

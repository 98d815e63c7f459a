import { logMessages } from './messages/gateway';

/** Rate limit for each subject: MAX_LINES lines in PERIOD_MS. A state may change with each value that arrives. */
const MAX_LINES = 10;
const PERIOD_MS = 60_000;

/** Logs to standard error: one line per change of state, without secrets. */
export class Log {
  readonly #last = new Map<string, string>();
  readonly #lately = new Map<string, { lines: number; newest: string }>();
  readonly #secrets: string[];

  /** @param later Calls a function after a time, unless the process has ended by then. */
  constructor(
    readonly name: string,
    secrets: string[],
    readonly write: (line: string) => void,
    readonly later: (ms: number, then: () => void) => void = (ms, then) => void setTimeout(then, ms).unref(),
  ) {
    this.#secrets = secrets.filter(secret => secret.length > 0);
  }

  line(text: string): void {
    this.write(`[${this.name}] ${this.clean(text)}\n`);
  }

  /** Writes a line only if the state of this subject has changed. */
  change(subject: string, state: string, text = state): void {
    if (this.#last.get(subject) === state) return;
    this.#last.set(subject, state);
    this.#write(subject, text);
  }

  /** Writes a line if this subject has a logged state, and removes that state. */
  resume(subject: string, text: string): void {
    if (this.#last.delete(subject)) this.#write(subject, text);
  }

  /** Removes the logged state of a subject, so that its next state is always logged. */
  forget(subject: string): void {
    this.#last.delete(subject);
  }

  #write(subject: string, text: string): void {
    const lately = this.#lately.get(subject) ?? { lines: 0, newest: '' };
    if (lately.lines === 0) this.later(PERIOD_MS, () => this.#sumUp(subject));
    this.#lately.set(subject, { lines: lately.lines + 1, newest: text });
    if (lately.lines < MAX_LINES) this.line(text);
  }

  #sumUp(subject: string): void {
    const { lines, newest } = this.#lately.get(subject)!;
    this.#lately.delete(subject);
    if (lines > MAX_LINES) this.line(logMessages.moreLines(newest, lines - MAX_LINES, PERIOD_MS / 1000));
  }

  /** Converts any string, for example one from a plant, to one line of printable characters without secrets. */
  clean(text: string): string {
    const bare = this.#secrets.reduce((rest, secret) => rest.replaceAll(secret, '***'), text);
    return bare
      .replace(/\p{Cc}+/gu, ' ')
      .replace(/(\w+:\/\/)[^/@\s]+@/g, '$1***@')
      .slice(0, 1000);
  }
}

import { logMessages } from './messages/gateway';

/** Rate limit per subject, whose state may change as often as its values arrive. */
const MAX_LINES = 10;
const PERIOD_MS = 60_000;

/** Logs to standard error, one line per change of state, without secrets. */
export class Log {
  readonly #last = new Map<string, string>();
  readonly #lately = new Map<string, { lines: number; newest: string }>();
  readonly #secrets: string[];

  /** @param later Schedules a function, which does not run if the process ends first. */
  constructor(
    readonly name: string,
    secrets: string[],
    readonly write: (line: string) => void = line => void process.stderr.write(line),
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
    this.#tell(subject, text);
  }

  /** Writes a line if this subject has a logged state, and removes that state. */
  resume(subject: string, text: string): void {
    if (this.#last.delete(subject)) this.#tell(subject, text);
  }

  /** Removes the logged state, so that the next one is always logged. */
  forget(subject: string): void {
    this.#last.delete(subject);
  }

  #tell(subject: string, text: string): void {
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

  /** Returns one line of printable characters without secrets, for any text of a peer. */
  clean(text: string): string {
    const bare = this.#secrets.reduce((rest, secret) => rest.replaceAll(secret, '***'), text);
    return bare
      .replace(/\p{Cc}+/gu, ' ')
      .replace(/(\w+:\/\/)[^/@\s]+@/g, '$1***@')
      .slice(0, 1000);
  }
}

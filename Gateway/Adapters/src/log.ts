/** Of one subject, which may change as often as its values come. */
const MOST_LINES = 10, PERIOD_MS = 60_000;

/** Standard error, a line per change of state, without secrets. */
export class Log {
  readonly #last = new Map<string, string>();
  readonly #lately = new Map<string, { lines: number; newest: string }>();
  readonly #secrets: string[];

  /** @param later Does something after a while, unless the process ends before. */
  constructor(
    readonly name: string, secrets: string[], readonly write: (line: string) => void = line => void process.stderr.write(line),
    readonly later: (ms: number, then: () => void) => void = (ms, then) => void setTimeout(then, ms).unref(),
  ) {
    this.#secrets = secrets.filter(secret => secret.length > 0);
  }

  line(text: string): void {
    this.write(`[${this.name}] ${this.clean(text)}\n`);
  }

  /** A line only when the state of this subject is another one than last time. */
  change(subject: string, state: string, text = state): void {
    if (this.#last.get(subject) === state) return;
    this.#last.set(subject, state);
    this.#tell(subject, text);
  }

  /** A line when something was told of this subject, which then has nothing to tell. */
  resume(subject: string, text: string): void {
    if (this.#last.delete(subject)) this.#tell(subject, text);
  }

  /** What is told of this subject next is told, whatever was told last. */
  forget(subject: string): void {
    this.#last.delete(subject);
  }

  #tell(subject: string, text: string): void {
    const lately = this.#lately.get(subject) ?? { lines: 0, newest: '' };
    if (lately.lines === 0) this.later(PERIOD_MS, () => this.#sumUp(subject));
    this.#lately.set(subject, { lines: lately.lines + 1, newest: text });
    if (lately.lines < MOST_LINES) this.line(text);
  }

  #sumUp(subject: string): void {
    const { lines, newest } = this.#lately.get(subject)!;
    this.#lately.delete(subject);
    if (lines > MOST_LINES) this.line(`${newest} (the newest of ${lines - MOST_LINES} more lines within ${PERIOD_MS / 1000} s)`);
  }

  /** One line of printable characters in which no secret stands, whatever a peer put into its messages. */
  clean(text: string): string {
    const bare = this.#secrets.reduce((rest, secret) => rest.replaceAll(secret, '***'), text);
    return bare.replace(/[\u0000-\u001f\u007f-\u009f]+/g, ' ').replace(/(\w+:\/\/)[^/@\s]+@/g, '$1***@').slice(0, 1000);
  }
}

import { Log } from '../log';

/** Of the connection to the plant; waiting means between two attempts. */
export type PlantState = 'connecting' | 'connected' | 'refused' | 'waiting';

const MOST_REASONS = 32;

/** What became of the plant and its values: counted here, told once a second, logged once per change. */
export class AdapterStatus {
  #state: PlantState = 'connecting';
  #reason = '';
  #samples = 0;
  #reconnects = 0;
  readonly #refused = new Map<string, number>();
  readonly #details: Record<string, string> = {};

  constructor(kind: string, readonly log: Log) {
    this.#details.kind = kind;
  }

  get state(): PlantState { return this.#state; }
  get samples(): number { return this.#samples; }
  get reconnects(): number { return this.#reconnects; }

  /** @param reason Why, and what to do; empty while all is well. */
  enter(state: PlantState, reason = ''): void {
    const clean = this.log.clean(reason);
    // An attempt is no news: what comes of it is.
    if (state !== 'connecting') this.log.change('plant', clean === '' ? state : `${state}: ${clean}`);
    this.#state = state;
    this.#reason = clean;
  }

  /** A fact that does not change often, such as security or sampling_ms; null: it is none any more. */
  detail(key: string, value: string | number | null): void {
    if (value === null) delete this.#details[key];
    else this.#details[key] = this.log.clean(String(value));
  }

  sampled(): void { this.#samples++; }

  reconnected(): void { this.#reconnects++; }

  /**
   * A value that is not passed on.
   * @param reason One of few words; counted as refused/REASON.
   * @param what For the log: the joint, its value and what was allowed.
   */
  refuse(reason: string, subject: string, what: string): void {
    this.count(reason);
    this.log.change(`value of ${subject}`, reason, `${subject} refused (${reason}): ${what}`);
  }

  /** A value that was lost before it came here, or one that `refuse` has a word for. */
  count(reason: string): void {
    const known = this.#refused.has(reason) || this.#refused.size < MOST_REASONS ? reason : 'other';
    this.#refused.set(known, (this.#refused.get(known) ?? 0) + 1);
  }

  /** The values of this subject are good again. */
  accept(subject: string): void {
    this.log.resume(`value of ${subject}`, `${subject} is good again`);
  }

  refusals(reason: string): number { return this.#refused.get(reason) ?? 0; }

  values(): Record<string, string> {
    const refused = [...this.#refused];
    return {
      ...this.#details,
      state: this.#state,
      ...(this.#reason === '' ? {} : { reason: this.#reason }),
      samples: String(this.#samples),
      refused: String(refused.reduce((sum, [, count]) => sum + count, 0)),
      ...Object.fromEntries(refused.map(([reason, count]) => [`refused/${reason}`, String(count)])),
      reconnects: String(this.#reconnects),
    };
  }
}

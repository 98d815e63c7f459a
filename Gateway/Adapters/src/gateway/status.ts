import { Log } from '../log';
import { JointConditions } from './jointConditions';

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
  /** Why the plant is not connected since the last connection, or the start; empty before the first failure. */
  #failure = '';
  /** What a person should see although positions come; null for nothing. */
  #notice: string | null = null;
  readonly joints: JointConditions;

  /** @param changed Called after each change of the plant's state or of a joint's. */
  constructor(kind: string, readonly log: Log, readonly changed: () => void = () => {}) {
    this.#details.kind = kind;
    this.joints = new JointConditions(log, changed);
  }

  get state(): PlantState { return this.#state; }
  get samples(): number { return this.#samples; }
  get reconnects(): number { return this.#reconnects; }

  /** @param reason Why, and what to do; empty while all is well. */
  enter(state: PlantState, reason = ''): void {
    const clean = this.log.clean(reason);
    // An attempt is no news: what comes of it is.
    if (state !== 'connecting') this.log.change('plant', clean === '' ? state : `${state}: ${clean}`);
    if (state === 'waiting' || state === 'refused') {
      this.#failure = clean === '' ? 'the plant is not connected' : clean;
      this.joints.disconnected(this.#failure);
    } else if (state === 'connected') {
      this.#failure = '';
    }
    const isChanged = this.#state !== state || this.#reason !== clean;
    this.#state = state;
    this.#reason = clean;
    if (isChanged) this.changed();
  }

  /**
   * Level of a DiagnosticStatus: 0 when the plant is connected and each joint is live or at rest, 1 while connecting, with a notice, or when it is
   * not certain that a joint rests, 2 otherwise.
   */
  get level(): 0 | 1 | 2 {
    if (this.#state === 'connecting' && this.#failure === '') return 1;
    if (this.#state !== 'connected' || this.joints.trouble !== null) return 2;
    return this.joints.uncertainty === null && this.#notice === null ? 0 : 1;
  }

  /** The plant's state or, while it is connected, the first joint with a trouble. */
  get message(): string {
    if (this.#state === 'connecting' && this.#failure !== '') return `waiting: ${this.#failure}`;
    if (this.#state !== 'connected') return this.#reason === '' ? this.#state : `${this.#state}: ${this.#reason}`;
    if (this.joints.trouble === null && this.#notice !== null) return `${this.#state}: ${this.#notice}`;
    if (this.joints.trouble === null) return this.joints.uncertainty === null ? this.#state : `${this.joints.uncertainty[0]} may not be at rest: ${this.joints.uncertainty[1]}`;
    const [joint, { state, reason }] = this.joints.trouble;
    return `${joint} ${state}: ${reason}`;
  }

  /** A fact that does not change often, such as security or sampling_ms; null: it is none any more. */
  detail(key: string, value: string | number | null): void {
    if (value === null) delete this.#details[key];
    else this.#details[key] = this.log.clean(String(value));
  }

  /** A state of the plant that a person should see, although its positions are good; null: it is over. */
  notice(text: string | null): void {
    const clean = text === null ? null : this.log.clean(text);
    if (clean === this.#notice) return;
    const before = this.#notice;
    this.#notice = clean;
    this.detail('notice', clean);
    if (clean === null) this.log.resume('notice', `over: ${before}`);
    else this.log.change('notice', clean);
    this.changed();
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
    if (this.joints.has(subject)) this.joints.refused(subject, what);
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
      ...this.joints.values(),
    };
  }
}

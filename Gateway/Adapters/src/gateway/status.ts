import { Log } from '../log';
import { unixTimeMs } from '../times';
import { byImportance, type Condition, Conditions } from './conditions';
import { stateMessages } from '../messages/values';

/** State of the connection to the plant. It is "waiting" between two connection attempts. */
type PlantState = 'connecting' | 'connected' | 'refused' | 'waiting';

const MAX_REASONS = 32;

/** Time in ms for which a dropped message counts. The gateway reports each message that it drops. */
const REFUSED_MS = 5000;

/** The status of the plant and its values. Counts values and refusals, and logs each change once. The gateway receives it once per second. */
export class AdapterStatus {
  #state: PlantState = 'connecting';
  #reason = '';
  #samples = 0;
  #reconnects = 0;
  readonly #refused = new Map<string, number>();
  readonly #details: Record<string, string> = {};
  /** The reason for the newest connection failure; empty if the last attempt succeeded or none has failed. */
  #failure = '';
  /** Reason for which the gateway last dropped a message, and the time in ms; null if it has dropped none. */
  #gatewayRefusal: { reason: string; at: number } | null = null;
  /** Notices for the user while positions arrive, by subject. */
  readonly #notices = new Map<string, string>();
  readonly joints: Conditions;
  readonly frames: Conditions;
  readonly signals: Conditions;

  /**
   * @param changed Called after each change of the state of the plant, a joint, a frame or a signal.
   * @param now Unix time in milliseconds.
   */
  constructor(
    kind: string,
    readonly log: Log,
    readonly changed: () => void = () => {},
    now: () => number = unixTimeMs,
  ) {
    this.#details.kind = kind;
    this.joints = new Conditions('joint', log, changed, now);
    this.frames = new Conditions('frame', log, changed, now);
    this.signals = new Conditions('signal', log, changed, now);
  }

  get state(): PlantState {
    return this.#state;
  }

  /**
   * Sets the state of the connection to the plant.
   * @param reason The reason and the remedy; empty without an error.
   */
  enter(state: PlantState, reason = ''): void {
    const clean = this.log.clean(reason);
    // Does not log attempts, only their results.
    if (state !== 'connecting') this.log.change('plant', clean === '' ? state : `${state}: ${clean}`);
    if (state === 'waiting' || state === 'refused') {
      this.#failure = clean === '' ? stateMessages.disconnected : clean;
      for (const each of this.#all) each.disconnected(this.#failure);
    } else if (state === 'connected') {
      this.#failure = '';
      for (const each of this.#all) each.reconnected();
    }
    const isChanged = this.#state !== state || this.#reason !== clean;
    this.#state = state;
    this.#reason = clean;
    if (isChanged) this.changed();
  }

  /**
   * Level of the DiagnosticStatus. 0: the plant is connected, and each joint, frame and signal is live or at rest. 1: the first connection is being
   * made, there is a notice, or a joint or frame may not be at rest. 2: otherwise, and while the gateway drops messages.
   */
  get level(): 0 | 1 | 2 {
    if (this.#state === 'connecting' && this.#failure === '') return 1;
    if (this.#state !== 'connected' || this.#trouble !== null || this.#droppedBecause !== null) return 2;
    return this.#uncertainty === null && this.#notice === null ? 0 : 1;
  }

  /**
   * Description of the plant's state or, while the plant is connected, of the first joint, frame or signal with a fault, or of the reason for which the
   * gateway drops messages.
   */
  get message(): string {
    if (this.#state === 'connecting' && this.#failure !== '') return `waiting: ${this.#failure}`;
    if (this.#state !== 'connected') return this.#reason === '' ? this.#state : `${this.#state}: ${this.#reason}`;
    const trouble = this.#trouble;
    if (trouble === null && this.#droppedBecause !== null) return stateMessages.droppedByGateway(this.#droppedBecause);
    if (trouble === null && this.#notice !== null) return `${this.#state}: ${this.#notice}`;
    const uncertainty = this.#uncertainty;
    if (trouble === null) return uncertainty === null ? this.#state : stateMessages.uncertainRest(...uncertainty);
    const [name, { state, reason }] = trouble;
    return `${name} ${state}: ${reason}`;
  }

  /** Reason for which the gateway drops messages; null if it drops none. */
  get #droppedBecause(): string | null {
    return this.#gatewayRefusal !== null && performance.now() - this.#gatewayRefusal.at < REFUSED_MS ? this.#gatewayRefusal.reason : null;
  }

  get #all(): Conditions[] {
    return [this.joints, this.frames, this.signals];
  }

  /** The first joint, frame or signal that is neither live nor at rest; null if there is none. */
  get #trouble(): [string, Condition] | null {
    return this.joints.trouble ?? this.frames.trouble ?? this.signals.trouble;
  }

  /** The first joint or frame that may not be at rest, with the reason; null if there is none. */
  get #uncertainty(): [string, string] | null {
    return this.joints.uncertainty ?? this.frames.uncertainty;
  }

  /** Sets a value that rarely changes, such as security or sampling_ms; null removes it. */
  detail(key: string, value: string | number | null): void {
    if (value === null) delete this.#details[key];
    else this.#details[key] = this.log.clean(String(value));
  }

  /** Sets the notice about a subject for the user while positions are valid; null removes it. The first notice is shown. */
  notice(text: string | null, subject = 'notice'): void {
    const clean = text === null ? null : this.log.clean(text);
    const before = this.#notices.get(subject) ?? null;
    if (clean === before) return;
    if (clean === null) this.#notices.delete(subject);
    else this.#notices.set(subject, clean);
    this.detail('notice', this.#notice);
    if (clean === null) this.log.resume(subject, `ended: ${before}`);
    else this.log.change(subject, clean);
    this.changed();
  }

  get #notice(): string | null {
    return this.#notices.values().next().value ?? null;
  }

  /**
   * Reports that the gateway has dropped a message, for example because another source publishes its joints.
   * @param at Time of the report, in ms since the start of the process.
   */
  refusedByGateway(reason: string, at = performance.now()): void {
    const isFirst = this.#droppedBecause === null;
    this.#gatewayRefusal = { reason: this.log.clean(reason), at };
    if (isFirst) this.changed();
  }

  sampled(): void {
    this.#samples++;
  }

  reconnected(): void {
    this.#reconnects++;
  }

  /**
   * Reports a value that is not forwarded.
   * @param reason One of a fixed set of words. The refusal is counted as refused/REASON.
   * @param subject Name of the joint, frame or signal.
   * @param what Description for the log, with the value and the allowed range.
   * @param of The states that include `subject`: those of the joints, frames or signals.
   */
  refuse(reason: string, subject: string, what: string, of: Conditions = this.joints): void {
    this.count(reason);
    if (of.has(subject)) of.refused(subject, { reason, text: what });
    this.log.change(`value of ${subject}`, reason, `${subject} refused (${reason}): ${what}`);
  }

  /** Counts a refused value, or a value that was lost before it arrived, by reason. */
  count(reason: string): void {
    const known = this.#refused.has(reason) || this.#refused.size < MAX_REASONS ? reason : 'other';
    this.#refused.set(known, (this.#refused.get(known) ?? 0) + 1);
  }

  /** Counts a value that is not forwarded because the source has more joints, frames or signals than an adapter forwards. */
  tooMany(kind: string, most: number): void {
    this.count('too-many');
    this.notice(stateMessages.tooMany(kind, most), `number of ${kind}`);
  }

  /** Reports that the values of this subject are valid again. */
  accept(subject: string): void {
    this.log.resume(`value of ${subject}`, stateMessages.validAgain(subject));
  }

  /** Number of joints, frames and signals. */
  get size(): number {
    return this.#all.reduce((sum, { size }) => sum + size, 0);
  }

  /**
   * Gets all values for the diagnostics.
   * @param longest Maximum length of a reason of a joint, frame or signal.
   * @param count Maximum number of joints, frames and signals. The most important ones are included.
   */
  values(longest = Infinity, count = Infinity): Record<string, string> {
    const refused = [...this.#refused];
    // During an attempt, the reason of the last one still applies.
    const reason = this.#state === 'connecting' && this.#reason === '' ? this.#failure : this.#reason;
    // Joints come first, because the gateway takes one that is not reported for one that the adapter no longer has.
    const [joints, ...others] = this.#all.map(each => each.reports(longest));
    const reports = [...joints.sort(byImportance), ...others.flat().sort(byImportance)];
    return {
      ...this.#details,
      state: this.#state,
      ...(reason === '' ? {} : { reason }),
      samples: String(this.#samples),
      refused: String(refused.reduce((sum, [, count]) => sum + count, 0)),
      ...Object.fromEntries(refused.map(([word, count]) => [`refused/${word}`, String(count)])),
      reconnects: String(this.#reconnects),
      ...Object.fromEntries(reports.slice(0, count).flatMap(({ values }) => values)),
    };
  }
}

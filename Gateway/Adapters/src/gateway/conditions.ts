import type { Log } from '../log';
import { stateMessages } from '../messages/values';
import type { Refusal } from '../samples/stampRule';
import { unixTimeMs } from '../times';

/** The kind of object to which a value belongs. It is also the prefix of the object's key in the diagnostics. */
type ConditionKind = 'joint' | 'frame' | 'signal';

/**
 * The state of a joint, frame or signal. live: samples arrive. rest: no samples arrive, and the joint is assumed to be at rest. refused: values
 * arrive but are invalid. fault: the data have stopped. missing: no valid value has arrived since the start.
 */
export type State = 'live' | 'rest' | 'refused' | 'fault' | 'missing';

export interface Condition {
  state: State;
  /** Start of the state, as Unix time of this machine in milliseconds. */
  since: number;
  /** The reason for the state as one sentence; empty while live. */
  reason: string;
  /** One word for the reason, from a fixed set; empty while live or at rest. */
  word: string;
  /** The reason why a joint in the state rest may not be at rest; empty if there is none. */
  uncertainty: string;
}

/** The diagnostics of one joint, frame or signal. */
interface Report {
  /** 0 if it is neither live nor at rest, 1 if it is at rest, 2 if it is live. */
  rank: 0 | 1 | 2;
  since: number;
  values: string[][];
}

/** Sorts reports by their importance: faults before the others, and the newest before older ones. A receiver may keep only a part of the list. */
export const byImportance = (a: Report, b: Report): number => a.rank - b.rank || b.since - a.since;

/** Two reports with start times that differ by less than this describe the same state. The transmission time causes the difference. */
const SAME_SINCE_MS = 2000;

/** The word for a fault because of the connection to the control system. */
const NOT_CONNECTED = 'not-connected';

const isGood = ({ state }: Condition): boolean => state === 'live' || state === 'rest';

/** Shortens a text, but not to an empty one, which would have another meaning. */
const shortened = (text: string, longest: number): string => (text.length <= longest ? text : `${text.slice(0, longest)}…`);

/** The states of all joints, frames or signals, with their reasons. Logs the start and the end of each fault once. */
export class Conditions {
  readonly #known = new Map<string, Condition>();
  /** Names that have had no value since a connection was lost, with the reason of this loss. */
  readonly #lost = new Map<string, string>();

  /**
   * @param changed Called after each change of a state or a reason.
   * @param now Unix time in milliseconds.
   */
  constructor(
    readonly kind: ConditionKind,
    readonly log: Log,
    readonly changed: () => void = () => {},
    readonly now: () => number = unixTimeMs,
  ) {}

  /** Adds an expected name. Its state is missing until its first valid value. */
  expect(name: string): void {
    if (this.#known.has(name)) return;
    const since = this.now();
    this.#known.set(name, { state: 'missing', since, reason: stateMessages.noValueYet, word: 'never-received', uncertainty: '' });
  }

  has(name: string): boolean {
    return this.#known.has(name);
  }

  stateOf(name: string): State | undefined {
    return this.#known.get(name)?.state;
  }

  conditionOf(name: string): Condition | undefined {
    return this.#known.get(name);
  }

  reasonOf(name: string): string | undefined {
    return this.#known.get(name)?.reason;
  }

  /** The first entry that is neither live nor at rest; null if there is none. */
  get trouble(): [string, Condition] | null {
    return [...this.#known].find(([, condition]) => !isGood(condition)) ?? null;
  }

  /** The first name in the state rest that may not be at rest, with the reason; null if there is none. */
  get uncertainty(): [string, string] | null {
    const found = [...this.#known].find(([, { uncertainty }]) => uncertainty !== '');
    return found === undefined ? null : [found[0], found[1].uncertainty];
  }

  live(name: string): void {
    if (this.stateOf(name) === 'live') return;
    this.#enter(name, 'live', '', '', this.now());
    this.log.resume(`${this.kind} ${name}`, stateMessages.liveAgain(name));
  }

  /**
   * Sets the state rest.
   * @param since Time of the last sample.
   * @param basis The reason why the joint is assumed to be at rest.
   * @param uncertainty The reason why the joint may not be at rest; empty if there is none.
   */
  rest(name: string, since: number, basis: string, uncertainty = ''): void {
    const known = this.#known.get(name);
    const reason = stateMessages.assumedAtRest(basis, this.kind, uncertainty);
    if (known?.state === 'rest' && known.reason === reason) return;
    this.#enter(name, 'rest', reason, '', since, uncertainty);
    this.log.resume(`${this.kind} ${name}`, stateMessages.restWithoutFault(name));
  }

  fault(name: string, reason: Refusal, since = this.now()): void {
    this.#trouble(name, 'fault', reason, since, true);
  }

  /** Sets the reason for the state of a name that is neither live nor at rest. */
  explain(name: string, reason: Refusal): void {
    const known = this.#known.get(name);
    if (known !== undefined && !isGood(known)) this.#trouble(name, known.state, reason, known.since, true);
  }

  /** Sets the state refused. The caller logs the refusal. */
  refused(name: string, reason: Refusal): void {
    this.#trouble(name, 'refused', reason, this.now(), false);
  }

  /** Sets a condition: one that the gateway to which the source is connected reports, or one that a name had earlier. */
  report(name: string, { state, since, reason: text, word, uncertainty }: Condition): void {
    const known = this.#known.get(name);
    const reason = this.log.clean(text);
    const isSame = known?.state === state && known.reason === reason && known.uncertainty === uncertainty;
    if (isSame && Math.abs(known.since - since) < SAME_SINCE_MS) return;
    this.#enter(name, state, reason, word, since, uncertainty);
    if (state === 'rest' || state === 'live')
      this.log.resume(`${this.kind} ${name}`, state === 'rest' ? stateMessages.restWithoutFault(name) : stateMessages.liveAgain(name));
    else this.log.change(`${this.kind} ${name}`, `${state} ${reason}`, `${name} ${state}: ${reason}`);
  }

  /** Removes a name that is no longer expected. */
  forget(name: string): void {
    if (!this.#known.delete(name)) return;
    this.#lost.delete(name);
    this.log.resume(`${this.kind} ${name}`, stateMessages.notExpected(name));
    this.changed();
  }

  /** Reports the end of the connection to the source. The states live, rest and refused become fault, because no values arrive. */
  disconnected(reason: string): void {
    for (const [name, condition] of this.#known) {
      const first = condition.word === NOT_CONNECTED ? this.#lost.get(name) : undefined;
      if (first !== undefined) this.#enter(name, condition.state, first, condition.word, condition.since);
      else if (isGood(condition) || condition.state === 'refused') {
        this.#enter(name, 'fault', reason, NOT_CONNECTED, this.now());
        this.#lost.set(name, reason);
      }
    }
  }

  /** Reports a new connection to the source. The names without a value keep their fault, and its reason states that the connection exists again. */
  reconnected(): void {
    for (const [name, reason] of this.#lost) {
      const known = this.#known.get(name);
      if (known?.word === NOT_CONNECTED) this.#enter(name, known.state, stateMessages.noValueAgain(reason), known.word, known.since);
      else this.#lost.delete(name);
    }
  }

  get size(): number {
    return this.#known.size;
  }

  /**
   * Gets the diagnostics of all names.
   * @param longest Maximum length of a reason.
   */
  reports(longest: number): Report[] {
    return [...this.#known].map(([name, { state, since, reason, word, uncertainty }]) => ({
      rank: state === 'live' ? 2 : state === 'rest' ? 1 : 0,
      since,
      values: [
        [`${this.kind}/${name}`, `${state} ${(since / 1000).toFixed(3)}${reason === '' ? '' : ` ${shortened(reason, longest)}`}`],
        // These keys name no kind, and the gateway uses them for joints only. The text of the state has the uncertainty, too.
        ...(word === '' || this.kind !== 'joint' ? [] : [[`reason/${name}`, word]]),
        ...(uncertainty === '' || this.kind !== 'joint' ? [] : [[`uncertain/${name}`, shortened(uncertainty, longest)]]),
      ],
    }));
  }

  #trouble(name: string, state: State, { reason: word, text }: Refusal, since: number, isLogged: boolean): void {
    const reason = this.log.clean(text);
    const { state: before, reason: previous, since: began } = this.#known.get(name) ?? {};
    // The state stays 'missing' until the first valid value arrives. Until then, the reason describes the newest invalid value.
    const entered = before === 'missing' ? 'missing' : state;
    if (before === entered && previous === reason) return;
    // A further reason for the same state is not a new start. For a fault, the caller knows the start.
    this.#enter(name, entered, reason, word, before === entered && entered !== 'fault' ? began! : since);
    if (isLogged) this.log.change(`${this.kind} ${name}`, `${entered} ${reason}`, `${name} ${entered}: ${reason}`);
  }

  #enter(name: string, state: State, reason: string, word: string, since: number, uncertainty = ''): void {
    this.#known.set(name, { state, since, reason, word, uncertainty });
    this.changed();
  }
}

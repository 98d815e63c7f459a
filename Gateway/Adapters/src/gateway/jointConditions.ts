import type { Log } from '../log';

/**
 * live: samples arrive. rest: silent and assumed to be at rest. refused: values arrive but are invalid. fault: the data have stopped.
 * missing: no valid value since the start.
 */
export type JointState = 'live' | 'rest' | 'refused' | 'fault' | 'missing';

export interface JointCondition {
  state: JointState;
  /** Unix time of this machine in milliseconds. */
  since: number;
  /** One sentence; empty while live. */
  reason: string;
  /** The reason why the rest of the joint is uncertain; empty for none. */
  uncertainty: string;
}

/** Smaller differences between start times are caused by the transmission of the message. */
const SAME_SINCE_MS = 2000;

const isGood = ({ state }: JointCondition): boolean => state === 'live' || state === 'rest';

/** State of each joint with its reason. Logs the start and the end of each fault once. */
export class JointConditions {
  readonly #joints = new Map<string, JointCondition>();

  /**
   * @param changed Called after each change of a state or a reason.
   * @param now Unix time in milliseconds.
   */
  constructor(
    readonly log: Log,
    readonly changed: () => void = () => {},
    readonly now: () => number = Date.now,
  ) {}

  /** Expects a joint, which is missing until its first usable value. */
  expect(joint: string): void {
    if (!this.#joints.has(joint))
      this.#joints.set(joint, { state: 'missing', since: this.now(), reason: 'no value has arrived since the start', uncertainty: '' });
  }

  has(joint: string): boolean {
    return this.#joints.has(joint);
  }

  stateOf(joint: string): JointState | undefined {
    return this.#joints.get(joint)?.state;
  }

  /** The first joint that is neither live nor at rest; null when there is none. */
  get trouble(): [string, JointCondition] | null {
    return [...this.#joints].find(([, condition]) => !isGood(condition)) ?? null;
  }

  /** The first joint whose rest is uncertain, with the reason; null if there is none. */
  get uncertainty(): [string, string] | null {
    const found = [...this.#joints].find(([, { uncertainty }]) => uncertainty !== '');
    return found === undefined ? null : [found[0], found[1].uncertainty];
  }

  live(joint: string): void {
    if (this.stateOf(joint) === 'live') return;
    this.#enter(joint, 'live', '', this.now());
    this.log.resume(`joint ${joint}`, `${joint} is live again`);
  }

  /**
   * @param since Time of the last sample.
   * @param uncertainty The reason why the rest is uncertain; empty for none.
   */
  rest(joint: string, since: number, uncertainty = ''): void {
    const known = this.#joints.get(joint);
    if (known?.state === 'rest' && known.uncertainty === uncertainty) return;
    this.#enter(
      joint,
      'rest',
      `no change is reported; the joint is assumed at rest${uncertainty === '' ? '' : `; ${uncertainty}`}`,
      since,
      uncertainty,
    );
    this.log.resume(`joint ${joint}`, `${joint} is at rest without a fault`);
  }

  fault(joint: string, reason: string, since = this.now()): void {
    this.#trouble(joint, 'fault', reason, since, true);
  }

  missing(joint: string, reason: string): void {
    this.#trouble(joint, 'missing', reason, this.now(), true);
  }

  /** The caller logs the refusal. */
  refused(joint: string, reason: string): void {
    this.#trouble(joint, 'refused', reason, this.now(), false);
  }

  /** Applies the report of the gateway that has the joint. */
  report(joint: string, { state, since, reason: text, uncertainty }: JointCondition): void {
    const known = this.#joints.get(joint);
    const reason = this.log.clean(text);
    const isSame = known?.state === state && known.reason === reason && known.uncertainty === uncertainty;
    if (isSame && Math.abs(known.since - since) < SAME_SINCE_MS) return;
    this.#enter(joint, state, reason, since, uncertainty);
    if (state === 'rest' || state === 'live')
      this.log.resume(`joint ${joint}`, `${joint} is ${state === 'rest' ? 'at rest, without fault' : 'live again'}`);
    else this.log.change(`joint ${joint}`, `${state} ${reason}`, `${joint} ${state}: ${reason}`);
  }

  /** Removes a joint that is no longer expected. */
  forget(joint: string): void {
    if (!this.#joints.delete(joint)) return;
    this.log.resume(`joint ${joint}`, `${joint} is no longer expected`);
    this.changed();
  }

  /** Reports the end of the connection to the source: good states become faults. */
  disconnected(reason: string): void {
    for (const [joint, condition] of this.#joints) if (isGood(condition)) this.#enter(joint, 'fault', reason, this.now());
  }

  /** Gets the diagnostics of each joint; faulty joints come first, in case the receiver keeps only a part. */
  values(): Record<string, string> {
    const sorted = [...this.#joints].sort(([, a], [, b]) => Number(isGood(a)) - Number(isGood(b)));
    return Object.fromEntries(
      sorted.flatMap(([joint, { state, since, reason, uncertainty }]) => [
        [`joint/${joint}`, `${state} ${(since / 1000).toFixed(3)}${reason === '' ? '' : ` ${reason}`}`],
        ...(uncertainty === '' ? [] : [[`uncertain/${joint}`, uncertainty]]),
      ]),
    );
  }

  #trouble(joint: string, state: JointState, text: string, since: number, isLogged: boolean): void {
    const reason = this.log.clean(text);
    const { state: before, reason: previous } = this.#joints.get(joint) ?? {};
    // A joint without any valid value stays missing; the reason describes the invalid value.
    const entered = before === 'missing' ? 'missing' : state;
    if (before === entered && previous === reason) return;
    this.#enter(joint, entered, reason, since);
    if (isLogged) this.log.change(`joint ${joint}`, `${entered} ${reason}`, `${joint} ${entered}: ${reason}`);
  }

  #enter(joint: string, state: JointState, reason: string, since: number, uncertainty = ''): void {
    this.#joints.set(joint, { state, since, reason, uncertainty });
    this.changed();
  }
}

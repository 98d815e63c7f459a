import { TF } from '../cell/messages';
import type { Conditions } from '../gateway/conditions';
import { REFUSED_EVERY_MS } from '../gateway/keptMessages';
import type { LinkEvents, Publisher } from '../gateway/link';
import { JOINT_STATES } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';

/** The newest sample of a joint or frame: a message and the index of the joint or frame in it. */
interface Newest {
  topic: string;
  message: Record<string, unknown>;
  index: number;
  conditions: Conditions;
  name: string;
}

const NAMED = new RegExp(`(${JOINT_STATES}|${TF}) `);

/**
 * Publishes the newest samples of joints and frames at rest again, with their own time stamps, if the gateway may not have them: after a connection, and
 * while messages are lost or refused. Only for a source that does not confirm values, because the samples of other sources are repeated all the time.
 */
export class SampleRepeater implements LinkEvents {
  readonly #newest = new Map<string, Newest>();
  /** Joints and frames whose newest sample may be lost. */
  #suspect = new Set<string>();
  #suspected = -Infinity;
  /** Whether a sample has been refused since `#suspect` was filled, and the number of dropped messages at that time. */
  #isRefused = false;
  #dropped = 0;

  /**
   * @param isConfirmed Whether the source confirms values.
   * @param counter Monotonic clock in ms.
   */
  constructor(
    readonly status: Pick<AdapterStatus, 'joints' | 'frames'>,
    readonly gateway: Pick<Publisher, 'publish' | 'dropped'>,
    readonly isConfirmed: () => boolean,
    readonly counter: () => number = () => performance.now(),
  ) {}

  readonly published = (topic: string, msg: object): void => {
    if (this.isConfirmed()) return;
    const message = msg as Record<string, unknown> & { name?: string[]; transforms?: ({ child_frame_id?: string } | null)[] };
    const robot = topic.slice(1, -JOINT_STATES.length);
    const { joints, frames } = this.status;
    message.name?.forEach((name, index) =>
      this.#store({ topic, message, index, conditions: joints, name: robot === '' ? name : `${robot}/${name}` }),
    );
    message.transforms?.forEach((one, index) => this.#store({ topic, message, index, conditions: frames, name: one?.child_frame_id ?? '' }));
  };

  readonly opened = (): void => this.#suspectAll();

  readonly refused = (reason: string): void => {
    this.#isRefused ||= NAMED.test(reason);
  };

  /** Publishes the samples that are due. Called several times per second. */
  check(): void {
    const isLost = this.#isRefused || this.gateway.dropped > this.#dropped;
    if (isLost && this.counter() - this.#suspected >= REFUSED_EVERY_MS) this.#suspectAll();
    const due = new Map<Record<string, unknown>, { topic: string; indices: number[] }>();
    for (const key of this.#suspect) {
      const { topic, message, index, conditions, name } = this.#newest.get(key)!;
      // A joint or frame that moves sends newer samples.
      if (conditions.stateOf(name) === 'rest') due.set(message, { topic, indices: [...(due.get(message)?.indices ?? []), index] });
    }
    for (const [message, { topic, indices }] of due) this.gateway.publish(topic, partOf(message, indices));
  }

  /** Discards all samples, because the connection to the source is a new one, or the clock of their stamps has stepped. */
  forget(): void {
    this.#newest.clear();
    this.#suspect.clear();
  }

  #store(newest: Newest): void {
    const { conditions, name } = newest;
    const key = `${conditions.kind}/${name}`;
    this.#suspect.delete(key);
    // A broker may send any number of names, but only expected ones have a state.
    if (conditions.has(name)) this.#newest.set(key, newest);
  }

  #suspectAll(): void {
    [this.#suspected, this.#isRefused, this.#dropped] = [this.counter(), false, this.gateway.dropped];
    this.#suspect = new Set(this.#newest.keys());
  }
}

/** Gets the message with only some of its joints or transforms. */
function partOf(message: Record<string, unknown>, indices: number[]): object {
  const { length } = (message.transforms ?? message.name) as unknown[];
  const part = ([key, value]: [string, unknown]) => [
    key,
    Array.isArray(value) && value.length === length ? indices.map(i => value[i] as unknown) : value,
  ];
  return Object.fromEntries(Object.entries(message).map(part));
}

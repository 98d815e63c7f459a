import type { DataValue } from 'node-opcua-client';
import { isDeepStrictEqual } from 'node:util';
import { isGone, isGood, statusRefusal } from './nodeValues';
import type { NotificationReader } from './notificationReader';
import type { NodeValue, ReadOnlySession } from './readOnlySession';

/** A node is read when nothing has come of it for this long. */
const SILENT_MS = 60;

/** Reads differ from the last notification for this long, and for this multiple of what a change takes to arrive: the server no longer notifies. */
const DIFFERENT_MS = 400, DELAYS = 2;

interface NodeState {
  heardAt: number;
  /** The newest notification; null before the first. */
  value: DataValue | null;
  /** The server has no such node, or does not monitor it. */
  isGone: boolean;
  /** Its value was not usable when it was read, and no notification said so. */
  isBad: boolean;
  /** When the first of the reads was made that all differ from the last notification; null: the last one does not differ. */
  differsSince: number | null;
}

/** Reads the nodes that a server is silent about: it is silent about a value at rest and, often, about a deleted node. */
export class SilentNodes {
  /** Milliseconds that a change takes to arrive at most. */
  delayMs = 0;
  readonly #nodes: NodeState[];

  /** @param ids Of the joints' nodes, at this server. @param nameOf The entry of the configuration that names a node. */
  constructor(
    readonly session: Pick<ReadOnlySession, 'readAll' | 'monitorAgain'>, readonly reader: NotificationReader, readonly ids: string[],
    readonly nameOf: (node: number) => string, readonly now: () => number = () => performance.now(),
  ) {
    this.#nodes = ids.map(() => ({ heardAt: now(), value: null, isGone: false, isBad: false, differsSince: null }));
  }

  heard(values: NodeValue[]): void {
    for (const { node, value } of values)
      if (node < this.#nodes.length) this.#nodes[node] = { heardAt: this.now(), value, isGone: isGone(value.statusCode), isBad: false, differsSince: null };
  }

  /** The server does not monitor this node. */
  refused(node: number, reason: string): void {
    this.#nodes[node].isGone = true;
    this.reader.lose(node, reason);
  }

  /** Reads each silent node. Returns those that still have the value of their last notification. */
  async read(): Promise<Set<number>> {
    const began = this.now();
    const silent = this.#nodes.flatMap(({ heardAt, isGone }, node) => isGone || began - heardAt >= SILENT_MS ? [node] : []);
    const values = silent.length === 0 ? [] : await this.session.readAll(silent.map(node => this.ids[node]));
    const unchanged = new Set<number>();
    for (const [i, node] of silent.entries())
      if (this.#nodes[node].heardAt < began && await this.#isUnchanged(node, values[i])) unchanged.add(node);
    return unchanged;
  }

  async #isUnchanged(node: number, value: DataValue): Promise<boolean> {
    const state = this.#nodes[node];
    if (isGone(value.statusCode)) {
      if (!state.isGone) this.refused(node, `${this.nameOf(node)}: value ${this.reader.nodes[node]}; the server has no such node any more (${value.statusCode.name})`);
      return false;
    }
    const isSame = state.value !== null && isGood(state.value.statusCode) === isGood(value.statusCode)
      && isDeepStrictEqual(state.value.value?.value, value.value?.value);
    if (!isGood(value.statusCode)) {
      if (!isSame && !state.isBad) this.reader.refuse(node, statusRefusal(value)!);
      state.isBad = !isSame;
      return false;
    }
    const now = this.now();
    state.differsSince = isSame ? null : state.differsSince ?? now;
    // A new monitored item brings the value with its stamp at once.
    const isNew = state.isGone || state.isBad
      || state.differsSince !== null && now - state.differsSince >= Math.max(DIFFERENT_MS, DELAYS * this.delayMs);
    if (isNew) await this.#monitorAgain(node);
    return isSame && !isNew;
  }

  async #monitorAgain(node: number): Promise<void> {
    this.#nodes[node] = { heardAt: this.now(), value: null, isGone: false, isBad: false, differsSince: null };
    this.reader.expectFirst(node);
    const refusal = await this.session.monitorAgain(node, this.ids[node]);
    if (refusal !== null) this.refused(node, `${this.nameOf(node)}: the server says ${refusal}`);
  }
}

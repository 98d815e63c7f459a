import type { DataValue } from 'node-opcua-client';
import { isDeepStrictEqual } from 'node:util';
import { isGone, isGood, statusRefusal } from './nodeValues';
import type { NotificationReader } from './notificationReader';
import type { NodeValue, ReadOnlySession } from './readOnlySession';
import type { SourceStop } from '../samples/jointOutput';
import { Renewals } from './renewals';
import { sourceStamp } from './stamps';
import { nodeMessages } from '../messages/opcua';

/** Time without a notification after which a node is read. */
const SILENT_MS = 60;

/**
 * If reads differ from the last notification for this time and for this multiple of the normal delay, the server has stopped sending
 * notifications.
 */
const DIFFERENT_MS = 400;
const DELAYS = 2;

interface NodeState {
  heardAt: number;
  /** The newest notification; null before the first. */
  value: DataValue | null;
  /** Whether the server does not have the node, or does not monitor it. */
  isGone: boolean;
  /** Whether a read found its value unusable although the server had sent no notification of it. */
  isBad: boolean;
  /** Time of the first of the consecutive reads that differ from the last notification; null if the last one does not differ. */
  differsSince: number | null;
}

/** Reads the nodes for which a server sends nothing: their value is at rest or, often, the node was deleted. */
export class SilentNodes {
  /** Maximum delay of a change, ms. */
  delayMs = 0;
  readonly #nodes: NodeState[];
  readonly #renewals: Renewals;

  /**
   * @param ids The nodes of the values at this server.
   * @param nameOf Gets the configuration entry of a node.
   */
  constructor(
    readonly session: Pick<ReadOnlySession, 'readAll' | 'monitorAgain'>,
    readonly reader: NotificationReader,
    readonly ids: string[],
    readonly nameOf: (node: number) => string,
    readonly now: () => number = () => performance.now(),
  ) {
    this.#nodes = ids.map(() => ({ heardAt: now(), value: null, isGone: false, isBad: false, differsSince: null }));
    this.#renewals = new Renewals(ids.length, now);
  }

  /** Gets when the source stopped writing the node; null if it has not, or if it is unknown. */
  stopOf(node: number): SourceStop | null {
    return this.#renewals.stopOf(node);
  }

  heard(values: NodeValue[]): void {
    for (const { node, value } of values) {
      if (node >= this.#nodes.length) continue;
      if (isSameValue(this.#nodes[node].value, value)) this.#renewals.unchanged(node, sourceStamp(value));
      else this.#renewals.changed(node, sourceStamp(value));
      this.#nodes[node] = { heardAt: this.now(), value, isGone: isGone(value.statusCode), isBad: false, differsSince: null };
    }
  }

  /** Reports that the server does not monitor this node. */
  refused(node: number, reason: string): void {
    this.#nodes[node].isGone = true;
    this.reader.lose(node, reason);
  }

  /** Reads each silent node. Returns those that still have the value of their last notification. */
  async read(): Promise<Set<number>> {
    const began = this.now();
    const silent = this.#nodes.flatMap(({ heardAt, isGone }, node) => (isGone || began - heardAt >= SILENT_MS ? [node] : []));
    const values = silent.length === 0 ? [] : await this.session.readAll(silent.map(node => this.ids[node]));
    const unchanged = new Set<number>();
    for (const [i, node] of silent.entries())
      if (this.#nodes[node].heardAt < began && (await this.#isUnchanged(node, values[i]))) unchanged.add(node);
    return unchanged;
  }

  async #isUnchanged(node: number, value: DataValue): Promise<boolean> {
    const state = this.#nodes[node];
    if (isGone(value.statusCode)) {
      if (!state.isGone) this.refused(node, nodeMessages.gone(this.nameOf(node), this.reader.nodes[node], value.statusCode.name));
      return false;
    }
    const isSame = isSameValue(state.value, value);
    if (!isGood(value.statusCode)) {
      if (!isSame && !state.isBad) this.reader.refuse(node, statusRefusal(value)!);
      state.isBad = !isSame;
      return false;
    }
    const now = this.now();
    state.differsSince = isSame ? null : (state.differsSince ?? now);
    const hasEnded = this.reader.hasEnded(node);
    const isWrittenAgain = isSame && this.#renewals.unchanged(node, sourceStamp(value), hasEnded) && hasEnded;
    // A new monitored item immediately sends the value with its stamp.
    const isNew =
      isWrittenAgain
      || state.isGone
      || state.isBad
      || (state.differsSince !== null && now - state.differsSince >= Math.max(DIFFERENT_MS, DELAYS * this.delayMs));
    if (isNew) await this.#monitorAgain(node);
    return isSame && !isNew;
  }

  async #monitorAgain(node: number): Promise<void> {
    this.#nodes[node] = { heardAt: this.now(), value: null, isGone: false, isBad: false, differsSince: null };
    this.reader.expectFirst(node);
    const refusal = await this.session.monitorAgain(node, this.ids[node]);
    if (refusal !== null) this.refused(node, nodeMessages.notMonitored(this.nameOf(node), refusal));
  }
}

const isSameValue = (one: DataValue | null, other: DataValue): boolean =>
  one !== null && isGood(one.statusCode) === isGood(other.statusCode) && isDeepStrictEqual(one.value?.value, other.value?.value);

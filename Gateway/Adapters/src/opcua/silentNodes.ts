import type { DataValue } from 'node-opcua-client';
import { isDeepStrictEqual } from 'node:util';
import { isGone, isGood, NODE_GONE, reasonNotMonitored, statusRefusal } from './nodeValues';
import type { NotificationReader } from './notificationReader';
import type { NodeValue, ReadOnlySession } from './readOnlySession';
import type { SourceStop } from '../samples/jointTrack';
import { isUnnotified, SILENT_MS } from '../samples/silentValues';
import type { Refusal } from '../samples/stampRule';
import { Renewals } from './renewals';
import { sourceStamp } from './stamps';
import { nodeMessages } from '../messages/opcua';

interface NodeState {
  heardAt: number;
  /** The value of the newest notification; null before the first one. */
  value: DataValue | null;
  /** Whether the server does not have the node, or does not monitor it. */
  isGone: boolean;
  /** Whether a read returned an unusable value of which the server had sent no notification. */
  isBad: boolean;
  /** Time of the first of the latest consecutive reads that differ from the last notification; null if the last read does not differ. */
  differsSince: number | null;
}

/** Reads the nodes for which no notifications arrive, to distinguish a value at rest from a deleted node. */
export class SilentNodes {
  /** Maximum delay of a change, ms. */
  delayMs = 0;
  /** Time without a notification after which a node is read, ms. */
  silentMs = SILENT_MS;
  readonly #nodes: NodeState[];
  readonly #renewals: Renewals;

  /**
   * @param ids Node ids of the values on this server.
   * @param nameOf Gets the position of a node in the configuration, for messages.
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

  /** Gets the phase in which the source stopped writing a node; null if it has not stopped, or if this is unknown. */
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

  /** Reports that the server does not monitor this node. Each call of `read` then reads the node. */
  refused(node: number, refusal: Refusal): void {
    this.#nodes[node].isGone = true;
    this.reader.lose(node, refusal);
  }

  /** Whether `read` would read a node now. */
  get hasSilent(): boolean {
    return this.#silentAt(this.now()).length > 0;
  }

  /** Reads each node without recent notifications. Returns the nodes that still have the value of their last notification. */
  async read(): Promise<Set<number>> {
    const began = this.now();
    const silent = this.#silentAt(began);
    const values = silent.length === 0 ? [] : await this.session.readAll(silent.map(node => this.ids[node]));
    const unchanged = new Set<number>();
    for (const [i, node] of silent.entries())
      if (this.#nodes[node].heardAt < began && (await this.#isUnchanged(node, values[i]))) unchanged.add(node);
    return unchanged;
  }

  #silentAt(now: number): number[] {
    return this.#nodes.flatMap(({ heardAt, isGone }, node) => (isGone || now - heardAt >= this.silentMs ? [node] : []));
  }

  async #isUnchanged(node: number, value: DataValue): Promise<boolean> {
    const state = this.#nodes[node];
    if (isGone(value.statusCode)) {
      const text = nodeMessages.gone(this.nameOf(node), this.reader.map.nodes[node], value.statusCode.name);
      if (!state.isGone) this.refused(node, { reason: NODE_GONE, text });
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
    // Creates a new monitored item in these cases, because the server then sends the current value with its stamp at once.
    const isNew = isWrittenAgain || state.isGone || state.isBad || isUnnotified(state.differsSince, now, this.delayMs);
    if (isNew) await this.#monitorAgain(node);
    return isSame && !isNew;
  }

  async #monitorAgain(node: number): Promise<void> {
    this.#nodes[node] = { heardAt: this.now(), value: null, isGone: false, isBad: false, differsSince: null };
    this.reader.expectFirst(node);
    const status = await this.session.monitorAgain(node, this.ids[node]);
    if (status !== null) this.refused(node, { reason: reasonNotMonitored(status), text: nodeMessages.notMonitored(this.nameOf(node), status) });
  }
}

const isSameValue = (one: DataValue | null, other: DataValue): boolean =>
  one !== null && isGood(one.statusCode) === isGood(other.statusCode) && isDeepStrictEqual(one.value?.value, other.value?.value);

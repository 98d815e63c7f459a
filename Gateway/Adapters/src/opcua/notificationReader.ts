import type { AdapterContext } from '../adapter';
import type { SourceStop } from '../samples/jointTrack';
import type { PlantValue } from '../samples/plantOutput';
import type { Refusal } from '../samples/stampRule';
import { ofMilliseconds, type Nanoseconds } from '../times';
import type { DataValue } from 'node-opcua-client';
import { NodeMap } from './nodeMap';
import { isGone, isOverflown, NODE_GONE, statusRefusal, valueOf } from './nodeValues';
import type { NodeValue } from './readOnlySession';
import type { OpcUaSettings } from './kind';
import { StampComparison } from './stampComparison';
import { serverStamp, sourceStamp, timeIn } from './stamps';
import { type CycleTime, TimeVariable } from './timeVariable';
import { nodeMessages } from '../messages/opcua';

/** Minimum difference of time stamps up to which a value and a time belong to the same cycle. */
const MIN_TOLERANCE_MS = 0.5;

/** Converts notifications of the server to plant values. */
export class NotificationReader {
  readonly map: NodeMap;
  readonly #time: TimeVariable | null;
  /** Nodes whose newest value in this connection was good. The next value of any other node may be old. */
  readonly #received = new Set<number>();
  /** For each node that cannot be read, the reason that was counted. It is kept when the adapter reconnects, so that a deletion is counted once. */
  readonly #lost = new Map<number, string>();
  /** The newest time in the notifications so far. */
  #known: Nanoseconds | null = null;
  #silence: Nanoseconds = 0n;
  readonly #comparison = new StampComparison(text => this.context.status.notice(text, 'time stamps'));

  constructor(
    readonly context: Pick<AdapterContext, 'configuration' | 'output' | 'status' | 'clock'>,
    readonly settings: OpcUaSettings,
  ) {
    this.map = new NodeMap(context.configuration, settings.time?.node ?? null);
    const tolerance = ofMilliseconds(Math.max(settings.groupMs, MIN_TOLERANCE_MS));
    this.#time = settings.time === null ? null : new TimeVariable(tolerance);
  }

  /** Resets the state for a new connection. */
  restart(): void {
    this.#received.clear();
    this.#known = null;
    this.context.output.restart();
  }

  /** Sets the sampling interval of the server, which is the minimum interval between two changes of a value. */
  set samplingMs(ms: number) {
    this.#silence = ofMilliseconds(3 * ms);
    this.context.output.samplingS = ms / 1000;
  }

  read(values: NodeValue[]): void {
    const timeNode = this.map.valueNodes.length;
    // Reads the times first, because the values of a cycle may precede its time in a notification.
    const times = values.filter(v => v.node === timeNode).flatMap(({ value }) => this.#cycleTimeIn(value) ?? []);
    this.#time?.learn(times);
    const found = values.filter(v => v.node < timeNode).flatMap(({ node, value }) => this.#valuesOf(node, value));
    // Confirms unchanged values up to the time of the previous notification. Earlier changes would be in this notification.
    if (this.#known !== null) this.hold(this.#known, new Set(values.filter(v => v.node < timeNode).flatMap(v => this.map.valuesOf(v.node))));
    this.context.output.publish(found);
    this.#note(this.#time === null ? found.filter(({ refusal }) => refusal === undefined).map(({ stamp }) => stamp) : times.map(({ time }) => time));
  }

  /** Confirms unchanged values at a control time up to which all changes are known. */
  hold(time: Nanoseconds, except: ReadonlySet<number> = new Set()): void {
    this.context.output.hold(time, this.#silence, except);
  }

  /** Confirms that these nodes, and no others, still had their last value at a control time. */
  holdNodes(time: Nanoseconds, nodes: ReadonlySet<number>): void {
    this.hold(time, new Set(this.map.valueNodes.flatMap((_, node) => (nodes.has(node) ? [] : this.map.valuesOf(node)))));
  }

  /** Reports that the server does not have this node, or does not monitor it. */
  lose(node: number, refusal: Refusal): void {
    this.#countLost(node, refusal.reason);
    for (const value of this.map.valuesOf(node)) this.context.output.lose(value, refusal);
  }

  /** Reports that the value of this node is invalid. */
  refuse(node: number, refusal: Refusal): void {
    for (const value of this.map.valuesOf(node)) this.context.output.refuse(value, refusal);
  }

  /** Sets the function that returns the phase in which the source stopped writing a node, or null if it has not stopped. */
  set stopOf(stopOf: (node: number) => SourceStop | null) {
    this.context.output.sourceStopOf = value => stopOf(this.map.nodeOf(value));
  }

  /** Whether the data of a joint that is read from this node have ended during a motion. */
  hasEnded(node: number): boolean {
    return this.map.valuesOf(node).some(value => this.context.output.hasEnded(value));
  }

  /** Marks the next value of this node as the first of a new monitored item. */
  expectFirst(node: number): void {
    this.#received.delete(node);
  }

  #note(times: (Nanoseconds | null)[]): void {
    const { now } = this.context.clock;
    for (const time of times)
      if (time !== null && now !== null && time <= now && (this.#known === null || time > this.#known || this.#known > now)) this.#known = time;
  }

  /** Gets the time in the time variable; null if it is invalid. */
  #cycleTimeIn(value: DataValue): CycleTime | null {
    const { status } = this.context;
    const { node, unit } = this.settings.time!;
    const label = labelOf(value);
    const refusal = statusRefusal(value);
    const time = refusal === null ? timeIn(value.value, unit) : null;
    if (refusal !== null) status.refuse(refusal.reason, node, refusal.text);
    else if (time === null || label === null) status.refuse('time-type', node, nodeMessages.notTime);
    else return { label, time };
    return null;
  }

  #valuesOf(node: number, value: DataValue): PlantValue[] {
    const { status } = this.context;
    if (isOverflown(value.statusCode)) status.count('overflow');
    if (isGone(value.statusCode)) {
      const refusal = { reason: NODE_GONE, text: nodeMessages.missing(this.map.nodes[node], value.statusCode.name) };
      this.#countLost(node, refusal.reason);
      return this.map.valuesOf(node).map(index => ({ index, value: null, stamp: null, refusal, isLost: true }));
    }
    this.#lost.delete(node);
    const isFirst = !this.#received.has(node) && this.#hasStamp(value);
    const bad = statusRefusal(value);
    // The first good value after a bad one may have the old stamp again, because a server may keep the stamp of a value at rest.
    if (bad === null) this.#received.add(node);
    else this.#received.delete(node);
    const stamp = bad === null ? this.#stampOf(value) : null;
    // The first value may have changed long ago.
    if (bad === null && !isFirst && this.settings.timestamp === 'source') this.#comparison.add(stamp, serverStamp(value), this.context.clock.now);
    const refusal = bad ?? (stamp === null && !isFirst && this.#time !== null && this.#hasStamp(value) ? this.#unmatched : null);
    return this.map.valuesOf(node).map((index): PlantValue => {
      const found = refusal ?? valueOf(this.map.addressOf(index), value);
      if ('value' in found) return { index, value: found.value, stamp, isFirst };
      return { index, value: null, stamp, refusal: found };
    });
  }

  /** Counts a lost node once, although both a notification and a read request may report it. */
  #countLost(node: number, reason: string): void {
    if (this.#lost.get(node) === reason) return;
    this.#lost.set(node, reason);
    this.context.status.count(reason);
  }

  get #unmatched(): Refusal {
    const { time, groupMs } = this.settings;
    return { reason: 'time-unmatched', text: nodeMessages.noTimeOfCycle(time!.node, String(groupMs)) };
  }

  /** Whether a value has a stamp. The age of a value without a stamp is unknown. */
  #hasStamp(value: DataValue): boolean {
    return (this.#time === null ? this.#stampOf(value) : labelOf(value)) !== null;
  }

  #stampOf(value: DataValue): Nanoseconds | null {
    switch (this.settings.timestamp) {
      case 'source':
        return sourceStamp(value);
      case 'server':
        return serverStamp(value);
      case 'variable': {
        const label = labelOf(value);
        return label === null ? null : this.#time!.at(label);
      }
    }
  }
}

const labelOf = (value: DataValue): Nanoseconds | null => sourceStamp(value) ?? serverStamp(value);

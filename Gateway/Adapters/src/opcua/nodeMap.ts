import type { Configuration } from '../configuration/configuration';
import type { NodeAddress } from './nodeValues';

/**
 * Maps each node of the server to the joints, frames and signals that are read from it. A number of a joint, frame or signal is identified by its
 * index among the values of the configuration, and a node by its index in `nodes`.
 */
export class NodeMap {
  /** All nodes to read, each once. The time variable is the last one. */
  readonly nodes: string[];
  /** All nodes except the time variable. */
  readonly valueNodes: string[];
  readonly #values: number[][];

  /** @param time Node id of the time variable; null if there is none. */
  constructor(
    readonly configuration: Pick<Configuration, 'values' | 'where'>,
    time: string | null,
  ) {
    const { values } = configuration;
    this.valueNodes = [...new Set(values.map(({ address }) => address.node!))];
    this.nodes = time === null ? this.valueNodes : [...this.valueNodes, time];
    this.#values = this.valueNodes.map(node => values.flatMap(({ address }, i) => (address.node === node ? [i] : [])));
  }

  /** Gets the values that are read from a node. */
  valuesOf(node: number): readonly number[] {
    return this.#values[node];
  }

  /** Gets the node from which a value is read. */
  nodeOf(value: number): number {
    return this.#values.findIndex(values => values.includes(value));
  }

  addressOf(value: number): NodeAddress {
    return this.configuration.values[value].address as NodeAddress;
  }

  /** Gets the position of a node in the configuration, for messages. */
  whereIs(node: number): string {
    const { values, where } = this.configuration;
    return where(node === this.valueNodes.length ? ['plant', 'time', 'node'] : [...values[this.#values[node][0]].path, 'node']);
  }
}

import type { Path } from './yamlFile';

/** A number that is read from the control system. Its address there is specific to the kind. */
export interface Value {
  /** Description for messages, such as the name of a joint, or a frame with its component. */
  label: string;
  /** Its entry in the configuration. */
  path: Path;
  address: Address;
}

/**
 * The address of a variable: a node and its index for OPC UA, a symbol for ADS, a field with its index and bit for RTDE, a topic and a field of its
 * messages for MQTT, and with the type of the messages for ROS.
 */
export interface Address {
  node?: string;
  index?: number;
  symbol?: string;
  field?: string;
  bit?: number;
  topic?: string;
  type?: string;
}

/** The entries of an address by the kind of plant, the required one first. */
export const ADDRESS: Record<string, (keyof Address)[]> = {
  opcua: ['node', 'index'],
  ads: ['symbol'],
  rtde: ['field', 'index', 'bit'],
  mqtt: ['topic', 'field'],
};

/** Gets the address in an entry of the configuration. */
export const addressIn = ({ node, index, symbol, field, bit, topic, type }: Address): Address => ({ node, index, symbol, field, bit, topic, type });

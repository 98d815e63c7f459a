import type { Path } from './yamlFile';

/** A number that is read from the control system. The form of its address depends on the kind of plant. */
export interface Value {
  /** Description for messages, such as the name of a joint, or of a frame and its component. */
  label: string;
  /** Path of its entry in the configuration. */
  path: Path;
  address: Address;
  /** The unit in which the number is read, such as deg; absent if it has none, or if only a factor is known. */
  unit?: string;
}

/**
 * The address of a variable: node and index for OPC UA; symbol for ADS; field, index and bit for RTDE; topic and field for MQTT; topic, type and
 * field for ROS.
 */
export interface Address {
  node?: string;
  index?: number;
  symbol?: string;
  field?: string | (string | number)[];
  bit?: number;
  topic?: string;
  type?: string;
}

/** Gets the address in an entry of the configuration. */
export const addressIn = ({ node, index, symbol, field, bit, topic, type }: Address): Address => ({ node, index, symbol, field, bit, topic, type });

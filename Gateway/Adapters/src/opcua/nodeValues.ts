import { DataType, type DataValue, type StatusCode, VariantArrayType } from 'node-opcua-client';
import type { Refusal } from '../samples/stampRule';
import { numberIn } from './stamps';
import { nodeMessages } from '../messages/opcua';

/** The address of a value: a node and, for an array, the index in it. */
export interface NodeAddress {
  node: string;
  index?: number;
}

/** The info bit of a status code for an overflow of the server's queue. */
const OVERFLOW = 0x80;

/** The severity is in the two highest bits. With its info bits, a good status may differ from the library's Good. */
const severity = (status: StatusCode): number => status.value >>> 30;

export const isGood = (status: StatusCode): boolean => severity(status) === 0;

const GONE = ['BadNodeIdUnknown', 'BadNodeIdInvalid'];

/** Whether the server does not have the node, or no longer has it. */
export const isGone = (status: StatusCode): boolean => GONE.includes(status.name);

export const isOverflown = (status: StatusCode): boolean => (status.value & OVERFLOW) !== 0;

/** Gets the reason why a value is unusable by its status. Uncertain is refused, too: it may be the last value before a fault. */
export function statusRefusal(value: DataValue): Refusal | null {
  // A server may send a status without a value, and Null for a variable that has never been written.
  const isThere = value.value && value.value.dataType !== DataType.Null;
  if (isGood(value.statusCode)) return isThere ? null : { reason: 'type', text: nodeMessages.noValue };
  const kind = severity(value.statusCode) === 1 ? 'uncertain' : 'bad';
  return { reason: `status-${kind}`, text: nodeMessages.badStatus(value.statusCode.name, value.statusCode.description) };
}

/** Gets the number at an address from a node's value. The caller checks that it is a number. */
export function valueOf(address: NodeAddress, value: DataValue): { value: unknown } | Refusal {
  const { value: variant } = value;
  const isArray = variant.arrayType !== VariantArrayType.Scalar;
  if (address.index === undefined) return isArray ? { reason: 'type', text: nodeMessages.array(address.node) } : { value: numberIn(variant) };
  if (!isArray) return { reason: 'type', text: nodeMessages.notArray(address.node) };
  const elements = variant.value as ArrayLike<unknown> | null;
  const length = elements?.length ?? 0;
  if (address.index >= length) return { reason: 'index', text: nodeMessages.index(address.node, length) };
  const element = elements![address.index];
  return { value: numberIn({ dataType: variant.dataType, value: element } as typeof variant) };
}

import { DataType, type DataValue, type StatusCode, VariantArrayType } from 'node-opcua-client';
import type { Refusal } from '../samples/stampRule';
import { contentOf } from './stamps';
import { nodeMessages } from '../messages/opcua';

/** The address of a value: a node and, if its value is an array, the index of the element. */
export interface NodeAddress {
  node: string;
  index?: number;
}

/** The info bit of a status code that shows an overflow of the server's queue. */
const OVERFLOW = 0x80;

/** Gets the severity in the two highest bits. A good status with info bits is not equal to the library's constant Good. */
const severity = (status: StatusCode): number => status.value >>> 30;

export const isGood = (status: StatusCode): boolean => severity(status) === 0;

/** A node that is not a variable, such as an object, has no value. */
const GONE = ['BadNodeIdUnknown', 'BadNodeIdInvalid', 'BadAttributeIdInvalid'];

/** Reasons for a node without values: the server does not have the node, or it does not monitor the node for another reason. */
export const NODE_GONE = 'node-gone';
const NOT_MONITORED = 'not-monitored';

/** Gets the reason for a node that the server does not monitor, from the name of the status that the server returned. */
export const reasonNotMonitored = (status: string): string => (GONE.includes(status) ? NODE_GONE : NOT_MONITORED);

/** Whether the status means that the server does not have the node. */
export const isGone = (status: StatusCode): boolean => GONE.includes(status.name);

export const isOverflown = (status: StatusCode): boolean => (status.value & OVERFLOW) !== 0;

/**
 * Refuses a value whose status is not good; returns null for a good value. Uncertain is refused, because the value may be the last before a fault.
 */
export function statusRefusal(value: DataValue): Refusal | null {
  // The value may be missing, because a server may send a status alone, or Null for a variable that was never written.
  const isThere = value.value && value.value.dataType !== DataType.Null;
  if (isGood(value.statusCode)) return isThere ? null : { reason: 'type', text: nodeMessages.noValue };
  const kind = severity(value.statusCode) === 1 ? 'uncertain' : 'bad';
  return { reason: `status-${kind}`, text: nodeMessages.badStatus(value.statusCode.name, value.statusCode.description) };
}

/** Gets the value at an address from the value of its node. The caller checks whether it is a number. */
export function valueOf(address: NodeAddress, value: DataValue): { value: unknown } | Refusal {
  const { value: variant } = value;
  const isArray = variant.arrayType !== VariantArrayType.Scalar;
  if (address.index === undefined) return isArray ? { reason: 'type', text: nodeMessages.array(address.node) } : { value: contentOf(variant) };
  if (!isArray) return { reason: 'type', text: nodeMessages.notArray(address.node) };
  const elements = variant.value as ArrayLike<unknown> | null;
  const length = elements?.length ?? 0;
  if (address.index >= length) return { reason: 'index', text: nodeMessages.index(address.node, length) };
  const element = elements![address.index];
  return { value: contentOf({ dataType: variant.dataType, value: element } as typeof variant) };
}

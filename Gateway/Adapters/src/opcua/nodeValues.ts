import { DataType, type DataValue, type StatusCode, VariantArrayType } from 'node-opcua-client';
import type { Joint } from '../configuration/configuration';
import type { Refusal } from '../samples/stampRule';
import { numberIn } from './stamps';

/** What a joint of kind opcua names: a node and, of an array, the place in it. */
export interface NodeJoint extends Joint {
  node: string;
  index?: number;
}

/** The info bit of a status code that says that the server's queue was too short. */
const OVERFLOW = 0x80;

/** The severity is in the two highest bits: with its info bits a status may be good without being the library's Good. */
const severity = (status: StatusCode): number => status.value >>> 30;

export const isGood = (status: StatusCode): boolean => severity(status) === 0;

const GONE = ['BadNodeIdUnknown', 'BadNodeIdInvalid'];

/** Whether the server has no such node (any more). */
export const isGone = (status: StatusCode): boolean => GONE.includes(status.name);

export const isOverflown = (status: StatusCode): boolean => (status.value & OVERFLOW) !== 0;

/** Why there is no value to be used, by its own status; Uncertain is refused too: it may be the last value before a fault. */
export function statusRefusal(value: DataValue): Refusal | null {
  // A server may send a status and no value, Null for a variable that nobody has written yet.
  const isThere = value.value && value.value.dataType !== DataType.Null;
  if (isGood(value.statusCode)) return isThere ? null : { reason: 'type', text: 'it has no value' };
  const kind = severity(value.statusCode) === 1 ? 'uncertain' : 'bad';
  return { reason: `status-${kind}`, text: `the server says ${value.statusCode.name}, ${value.statusCode.description}` };
}

/** The joint's own number in a node's value; what is none is found out by whoever takes it. */
export function valueOf(joint: NodeJoint, value: DataValue): { value: unknown } | Refusal {
  const { value: variant } = value, isArray = variant.arrayType !== VariantArrayType.Scalar;
  if (joint.index === undefined)
    return isArray ? { reason: 'type', text: `${joint.node} is an array; add index` } : { value: numberIn(variant) };
  if (!isArray) return { reason: 'type', text: `${joint.node} is no array; take index out` };
  const elements = variant.value as ArrayLike<unknown> | null, length = elements?.length ?? 0;
  if (joint.index >= length) return { reason: 'index', text: `${joint.node} has ${length} elements; allowed is an index from 0 to ${length - 1}` };
  const element = elements![joint.index];
  return { value: numberIn({ dataType: variant.dataType, value: element } as typeof variant) };
}

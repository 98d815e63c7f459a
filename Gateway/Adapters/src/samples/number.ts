import { shown } from '../configuration/problem';
import type { Refusal } from './stampRule';

/** Gets the number in a read value, a 64-bit one as the nearest double; the refusal of any other value. */
export function numberIn(value: unknown): number | Refusal {
  const number = typeof value === 'bigint' ? Number(value) : value;
  if (typeof number !== 'number') return { reason: 'type', text: `value ${shown(value)} is not a number; name a numeric variable` };
  return Number.isFinite(number) ? number : { reason: 'not-finite', text: `value ${number} is not a position` };
}

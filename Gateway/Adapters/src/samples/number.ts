import type { Refusal } from './stampRule';
import { refusalMessages } from '../messages/values';

/** Gets the number in a read value, a 64-bit one as the nearest double; the refusal of any other value. */
export function numberIn(value: unknown): number | Refusal {
  const number = typeof value === 'bigint' ? Number(value) : value;
  if (typeof number !== 'number') return { reason: 'type', text: refusalMessages.notNumber(value) };
  return Number.isFinite(number) ? number : { reason: 'not-finite', text: refusalMessages.notPosition(String(number)) };
}

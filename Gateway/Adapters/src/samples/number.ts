import type { Refusal } from './stampRule';
import { refusalMessages } from '../messages/values';

/** Converts a value to a number, a 64-bit number to the nearest double. Returns a refusal for a value that is not a finite number. */
export function numberIn(value: unknown): number | Refusal {
  const number = typeof value === 'bigint' ? Number(value) : value;
  if (typeof number !== 'number') return { reason: 'type', text: refusalMessages.notNumber(value) };
  return Number.isFinite(number) ? number : { reason: 'not-finite', text: refusalMessages.notPosition(String(number)) };
}

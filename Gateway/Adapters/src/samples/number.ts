import type { Refusal } from './stampRule';
import { refusalMessages } from '../messages/values';

/** Converts a value to a number, a 64-bit number to the nearest double. Returns a refusal for a value that is not a finite number. */
export function numberIn(value: unknown): number | Refusal {
  const number = typeof value === 'bigint' ? Number(value) : value;
  if (typeof number !== 'number') return { reason: 'type', text: refusalMessages.notNumber(value) };
  return Number.isFinite(number) ? number : { reason: 'not-finite', text: refusalMessages.notPosition(String(number)) };
}

/** Gets a bit of a whole number, 0 or 1. Bit 0 is the least significant one. */
export function bitIn(value: unknown, bit: number): number | Refusal {
  const number = numberIn(value);
  if (typeof number !== 'number') return number;
  if (typeof value !== 'bigint' && !Number.isSafeInteger(number)) return { reason: 'type', text: refusalMessages.noBits(number) };
  return Number((BigInt(value as number | bigint) >> BigInt(bit)) & 1n);
}

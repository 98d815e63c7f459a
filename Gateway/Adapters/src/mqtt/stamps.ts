import { ofCount, ofFraction, type TimeUnit } from '../samples/timeUnit';
import { type Nanoseconds, ofMilliseconds } from '../times';

/** Formats of a time in a message: a number in a unit, or a string in ISO 8601 format (iso). */
export type MqttTimeUnit = TimeUnit | 'iso';

/** Matches an ISO 8601 date with time and zone. The zone is required, because without one, the time would depend on the location. */
const ISO = /^(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d)(?:[.,](\d{1,9})\d*)?(Z|[+-]\d\d:\d\d)$/;

/** Matches a string with a whole number. Senders use strings because a JSON number has a precision of only 53 bits. */
const COUNT = /^\d{1,20}$/;

/** Gets the time in a field of a message; null if the value is not a time in this unit. */
export function stampIn(value: unknown, unit: MqttTimeUnit): Nanoseconds | null {
  if (unit === 'iso') return typeof value === 'string' ? ofIso(value) : null;
  if (typeof value === 'string') return COUNT.test(value) ? ofCount(BigInt(value), unit) : null;
  return typeof value === 'number' && Number.isFinite(value) ? ofFraction(value, unit) : null;
}

function ofIso(text: string): Nanoseconds | null {
  const [, seconds, fraction = '', zone] = ISO.exec(text) ?? [];
  const ms = seconds === undefined ? NaN : Date.parse(seconds + zone);
  return Number.isNaN(ms) ? null : ofMilliseconds(ms) + BigInt(fraction.padEnd(9, '0'));
}

import { ofCount, ofFraction, type TimeUnit } from '../samples/timeUnit';
import { type Nanoseconds, ofMilliseconds } from '../times';

/** Formats of a time in a message: a number in a unit, or a string in ISO 8601 format (iso). */
export type MqttTimeUnit = TimeUnit | 'iso';

/** Matches an ISO 8601 date with time and, if it states one, a zone. */
const ISO = /^(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d)(?:[.,](\d{1,9})\d*)?(Z|[+-]\d\d:\d\d)?$/;

/** Matches a string with a whole number. Senders use strings because a JSON number has a precision of only 53 bits. */
const COUNT = /^\d{1,20}$/;

/**
 * Gets the time in a field of a message; null if the value is not a time in this unit.
 * @param zone The zone of an ISO 8601 time that states none, in the same format; null if such a time is not allowed, because its meaning would depend
 * on the location.
 */
export function stampIn(value: unknown, unit: MqttTimeUnit, zone: string | null = null): Nanoseconds | null {
  if (unit === 'iso') return typeof value === 'string' ? ofIso(value, zone) : null;
  if (typeof value === 'string') return COUNT.test(value) ? ofCount(BigInt(value), unit) : null;
  return typeof value === 'number' && Number.isFinite(value) ? ofFraction(value, unit) : null;
}

/** Whether the value is an ISO 8601 time without a zone. */
export const hasNoZone = (value: unknown): boolean => stampIn(value, 'iso') === null && stampIn(value, 'iso', 'Z') !== null;

function ofIso(text: string, zone: string | null): Nanoseconds | null {
  const [, seconds, fraction = '', stated = zone] = ISO.exec(text) ?? [];
  const ms = seconds === undefined || stated === null ? NaN : Date.parse(seconds + stated);
  return Number.isNaN(ms) ? null : ofMilliseconds(ms) + BigInt(fraction.padEnd(9, '0'));
}

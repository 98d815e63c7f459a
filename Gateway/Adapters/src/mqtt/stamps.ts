import { ofCount, ofFraction, type TimeUnit } from '../samples/timeUnit';
import { type Nanoseconds, ofMilliseconds } from '../times';

/** Units of a time in a message: those of a number, or text of ISO 8601. */
export type MqttTimeUnit = TimeUnit | 'iso';

/** A date with a time and a zone. Without a zone, the time would depend on the place. */
const ISO = /^(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d)(?:[.,](\d{1,9})\d*)?(Z|[+-]\d\d:\d\d)$/;

/** A whole number that is written as text, because a JSON number has 53 bits. */
const COUNT = /^\d{1,20}$/;

/** Gets the time in a field of a message; null if it is none. */
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

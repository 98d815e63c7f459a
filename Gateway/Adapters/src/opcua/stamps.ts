import { DataType, type DataValue, type Variant } from 'node-opcua-client';
import { ofCount, ofFraction, type TimeUnit } from '../samples/timeUnit';
import { type Nanoseconds, NS_PER_MS } from '../times';

/**
 * Gets the time of a date from the library with its full resolution; null if the date is missing, or means "no time" in OPC UA.
 * @param picoseconds Fraction of the millisecond: the 100 ns units of the protocol and the picoseconds, if the server sends them.
 */
export function ofDate(date: Date | null | undefined, picoseconds = 0): Nanoseconds | null {
  if (!date || Number.isNaN(date.getTime())) return null;
  const ms = BigInt(date.getTime());
  // The minimum and the maximum date in OPC UA mean "no time".
  const isNone = date.getUTCFullYear() <= 1601 || date.getUTCFullYear() >= 9999;
  return isNone ? null : ms * NS_PER_MS + BigInt(Math.floor(picoseconds / 1000));
}

export const sourceStamp = (value: DataValue): Nanoseconds | null => ofDate(value.sourceTimestamp, value.sourcePicoseconds);

export const serverStamp = (value: DataValue): Nanoseconds | null => ofDate(value.serverTimestamp, value.serverPicoseconds);

/** Combines the two 32-bit halves in which the library returns a 64-bit number. */
const whole = (value: unknown, isSigned: boolean): bigint | null => {
  if (!Array.isArray(value) && !(value instanceof Uint32Array)) return null;
  const bits = (BigInt(value[0] >>> 0) << 32n) | BigInt(value[1] >>> 0);
  return isSigned ? BigInt.asIntN(64, bits) : bits;
};

/** Gets the value of a variant. A 64-bit number is returned as a bigint. */
export function contentOf(variant: Variant): unknown {
  switch (variant.dataType) {
    case DataType.Int64:
      return whole(variant.value, true) ?? variant.value;
    case DataType.UInt64:
      return whole(variant.value, false) ?? variant.value;
    default:
      return variant.value;
  }
}

/**
 * Gets the time in a variable of the control system; null if there is none. A DateTime needs no unit. The default unit is ns for whole numbers and
 * s for an LREAL, counted since 1970. Refuses a REAL, whose resolution is two minutes for current dates, and whole numbers of 32 bits, which wrap.
 */
export function timeIn(variant: Variant, unit: TimeUnit | null): Nanoseconds | null {
  if (variant.dataType === DataType.DateTime) {
    const date = variant.value as (Date & { picoseconds?: number }) | null;
    return ofDate(date, date?.picoseconds);
  }
  const value = contentOf(variant);
  if (typeof value === 'bigint') return ofCount(value, unit ?? 'ns');
  return variant.dataType === DataType.Double && Number.isFinite(value) ? ofFraction(value as number, unit ?? 's') : null;
}

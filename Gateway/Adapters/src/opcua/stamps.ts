import { DataType, type DataValue, type Variant } from 'node-opcua-client';
import { ofCount, ofFraction, type TimeUnit } from '../samples/timeUnit';
import { type Nanoseconds, NS_PER_MS } from '../times';

/**
 * Gets the time of a library date with its full resolution; null for none, or for one that OPC UA defines as no time.
 * @param picoseconds Fraction of a ms: the 100 ns of the protocol and, if the server sends them, its picoseconds.
 */
export function ofDate(date: Date | null | undefined, picoseconds = 0): Nanoseconds | null {
  if (!date || Number.isNaN(date.getTime())) return null;
  const ms = BigInt(date.getTime());
  // The earliest and the latest date of OPC UA mean "no time".
  const isNone = date.getUTCFullYear() <= 1601 || date.getUTCFullYear() >= 9999;
  return isNone ? null : ms * NS_PER_MS + BigInt(Math.floor(picoseconds / 1000));
}

export const sourceStamp = (value: DataValue): Nanoseconds | null => ofDate(value.sourceTimestamp, value.sourcePicoseconds);

export const serverStamp = (value: DataValue): Nanoseconds | null => ofDate(value.serverTimestamp, value.serverPicoseconds);

/** Gets a 64-bit number from the library's two halves. */
const whole = (value: unknown, isSigned: boolean): bigint | null => {
  if (!Array.isArray(value) && !(value instanceof Uint32Array)) return null;
  const bits = (BigInt(value[0] >>> 0) << 32n) | BigInt(value[1] >>> 0);
  return isSigned ? BigInt.asIntN(64, bits) : bits;
};

/** Gets a scalar number, as a bigint for 64 bits; any other value unchanged. */
export function numberIn(variant: Variant): unknown {
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
 * Gets the time in a variable of the control system. A DateTime needs no unit; the default is ns since 1970 for whole numbers, and s for an
 * LREAL. A REAL, with a resolution of two minutes for current dates, and 32-bit seconds are refused.
 */
export function timeIn(variant: Variant, unit: TimeUnit | null): Nanoseconds | null {
  if (variant.dataType === DataType.DateTime) {
    const date = variant.value as (Date & { picoseconds?: number }) | null;
    return ofDate(date, date?.picoseconds);
  }
  const value = numberIn(variant);
  if (typeof value === 'bigint') return ofCount(value, unit ?? 'ns');
  return variant.dataType === DataType.Double && Number.isFinite(value) ? ofFraction(value as number, unit ?? 's') : null;
}

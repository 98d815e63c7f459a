import { ofCount, ofFraction, type TimeUnit } from '../samples/timeUnit';
import type { Nanoseconds } from '../times';

type Reader = (data: Buffer) => number | bigint;

/** Elementary types by their ADS number (ADST_… of TcAdsDef.h), which is the same whatever a PLC calls an alias of it. */
const READERS: Record<number, { bytes: number; read: Reader }> = {
  2: { bytes: 2, read: data => data.readInt16LE() },
  3: { bytes: 4, read: data => data.readInt32LE() },
  4: { bytes: 4, read: data => data.readFloatLE() },
  5: { bytes: 8, read: data => data.readDoubleLE() },
  16: { bytes: 1, read: data => data.readInt8() },
  17: { bytes: 1, read: data => data.readUInt8() },
  18: { bytes: 2, read: data => data.readUInt16LE() },
  19: { bytes: 4, read: data => data.readUInt32LE() },
  20: { bytes: 8, read: data => data.readBigInt64LE() },
  21: { bytes: 8, read: data => data.readBigUInt64LE() },
};

/** The fixed-size structures that hold a time: two words of 32 bits, the lower one first. */
const STRUCTURE = 65;

const DOUBLE = 5;

/** Of a symbol as the PLC's table tells of it. */
export interface Declared {
  type: string;
  adsDataType: number;
  size: number;
  arrayDimension: number;
}

/** Whether one number lies there. */
export const isNumber = ({ adsDataType, size, arrayDimension }: Declared): boolean =>
  arrayDimension === 0 && READERS[adsDataType]?.bytes === size;

export const numberOf = (declared: Declared, data: Buffer): number => Number(READERS[declared.adsDataType].read(data));

/** What a type counts by its name; for others see `unitOf`. */
const UNIT_OF_TYPE: Record<string, TimeUnit> = {
  T_FILETIME: 'filetime', FILETIME: 'filetime', T_FILETIME64: 'filetime', FILETIME64: 'filetime',
  T_DCTIME: 'dctime', T_DCTIME64: 'dctime', DCTIME64: 'dctime',
};

/** What a variable counts where nobody says it: whole numbers ns, an LREAL s. */
export const unitOf = ({ type, adsDataType }: Declared): TimeUnit =>
  UNIT_OF_TYPE[type.toUpperCase().replace(/^.*\./, '')] ?? (adsDataType === DOUBLE ? 's' : 'ns');

/** Whether it can hold a time: 64 bits. A UDINT or DT knows whole seconds only, which are too coarse. */
export const canHoldTime = ({ adsDataType, size, arrayDimension }: Declared): boolean =>
  arrayDimension === 0 && size === 8 && [DOUBLE, 20, 21, STRUCTURE].includes(adsDataType);

/** @returns Null where the variable holds no time: nothing, or a number that is none. */
export function timeOf({ adsDataType }: Declared, unit: TimeUnit, data: Buffer): Nanoseconds | null {
  if (adsDataType === DOUBLE) {
    const value = data.readDoubleLE();
    return Number.isFinite(value) && value > 0 ? ofFraction(value, unit) : null;
  }
  const count = data.readBigInt64LE();
  return count > 0n ? ofCount(count, unit) : null;
}

import { ofCount, ofFraction, type TimeUnit } from '../samples/timeUnit';
import type { Nanoseconds } from '../times';

/** A number of the PLC; a bigint if it has 64 bits, whose low bits a double would lose. */
export type PlcNumber = number | bigint;

type Reader = (data: Buffer) => PlcNumber;

/** Readers of elementary types by ADS type number (ADST_… in TcAdsDef.h), which is the same for all aliases of a type in a PLC. */
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

/** Type number of a BOOL, which can be a signal but not a position. */
const BIT = 33;
const STATE: Record<number, { bytes: number; read: Reader }> = { ...READERS, [BIT]: { bytes: 1, read: data => Math.min(data.readUInt8(), 1) } };

/** Type number of structures. A structure that contains a time has two words of 32 bits, the lower word first. */
const STRUCTURE = 65;

const DOUBLE = 5;

/** Properties of a symbol in the PLC's symbol table. */
interface Declared {
  type: string;
  adsDataType: number;
  size: number;
  arrayDimension: number;
}

/** Whether the symbol is a single number. */
export const isNumber = ({ adsDataType, size, arrayDimension }: Declared): boolean => arrayDimension === 0 && READERS[adsDataType]?.bytes === size;

/** Whether the symbol is a single number or a BOOL. */
export const isState = ({ adsDataType, size, arrayDimension }: Declared): boolean => arrayDimension === 0 && STATE[adsDataType]?.bytes === size;

/** Reads the number in a symbol's data; 0 or 1 for a BOOL. */
export const numberOf = (declared: Declared, data: Buffer): PlcNumber => STATE[declared.adsDataType].read(data);

/** Units of time types by type name. For other types, see `unitOf`. */
const UNIT_OF_TYPE: Record<string, TimeUnit> = {
  T_FILETIME: 'filetime',
  FILETIME: 'filetime',
  T_FILETIME64: 'filetime',
  FILETIME64: 'filetime',
  T_DCTIME: 'dctime',
  T_DCTIME64: 'dctime',
  DCTIME64: 'dctime',
};

/** Gets the default time unit of a variable: the unit of its time type, s for an LREAL, ns for other types. */
export const unitOf = ({ type, adsDataType }: Declared): TimeUnit =>
  UNIT_OF_TYPE[type.toUpperCase().replace(/^.*\./, '')] ?? (adsDataType === DOUBLE ? 's' : 'ns');

/** Whether the symbol can contain a time, which needs 64 bits. The resolution of a UDINT or DT, one second, is too coarse. */
export const canHoldTime = ({ adsDataType, size, arrayDimension }: Declared): boolean =>
  arrayDimension === 0 && size === 8 && [DOUBLE, 20, 21, STRUCTURE].includes(adsDataType);

/** Reads the time in a symbol's data; null if it is not a valid time. */
export function timeOf({ adsDataType }: Declared, unit: TimeUnit, data: Buffer): Nanoseconds | null {
  if (adsDataType === DOUBLE) {
    const value = data.readDoubleLE();
    return Number.isFinite(value) && value > 0 ? ofFraction(value, unit) : null;
  }
  const count = data.readBigInt64LE();
  return count > 0n ? ofCount(count, unit) : null;
}

/** The elements of an RTDE field. All numbers are big-endian. */
interface Elements {
  count: number;
  /** Size of one element in bytes. */
  size: number;
  isWhole: boolean;
  read(from: Buffer, at: number): number | bigint;
}

const double = (count: number): Elements => ({ count, size: 8, isWhole: false, read: (from, at) => from.readDoubleBE(at) });
const byte: Elements = { count: 1, size: 1, isWhole: true, read: (from, at) => from.readUInt8(at) };
const int32 = (count: number): Elements => ({ count, size: 4, isWhole: true, read: (from, at) => from.readInt32BE(at) });
const uint32 = (count: number): Elements => ({ count, size: 4, isWhole: true, read: (from, at) => from.readUInt32BE(at) });

/** The data types in UR's RTDE guide. */
const TYPES = {
  BOOL: byte,
  UINT8: byte,
  UINT32: uint32(1),
  INT32: int32(1),
  UINT64: { count: 1, size: 8, isWhole: true, read: (from: Buffer, at: number) => from.readBigUInt64BE(at) },
  DOUBLE: double(1),
  VECTOR3D: double(3),
  VECTOR6D: double(6),
  VECTOR6INT32: int32(6),
  VECTOR6UINT32: uint32(6),
};

export type FieldType = keyof typeof TYPES;

export const isFieldType = (name: string): name is FieldType => Object.hasOwn(TYPES, name);

export const elementsOf = (type: FieldType): Elements => TYPES[type];

// Defines the symbols of a simulated PLC and encodes their entries of the symbol table (AdsSymbolEntry of TcAdsDef.h).
import { words } from './frames.mjs';

const primitive = (type, size, write) => ({ type, size, write });

/** Data types by their IEC 61131-3 names: ADST number, size in bytes, and the function that writes a value. */
export const types = {
  BOOL: primitive(33, 1, (b, v) => b.writeUInt8(v ? 1 : 0)),
  INT: primitive(2, 2, (b, v) => b.writeInt16LE(v)),
  DINT: primitive(3, 4, (b, v) => b.writeInt32LE(v)),
  UDINT: primitive(19, 4, (b, v) => b.writeUInt32LE(v)),
  LINT: primitive(20, 8, (b, v) => b.writeBigInt64LE(v)),
  ULINT: primitive(21, 8, (b, v) => b.writeBigUInt64LE(v)),
  REAL: primitive(4, 4, (b, v) => b.writeFloatLE(v)),
  LREAL: primitive(5, 8, (b, v) => b.writeDoubleLE(v)),
  DT: primitive(19, 4, (b, v) => b.writeUInt32LE(v)),
  LTIME: primitive(21, 8, (b, v) => b.writeBigUInt64LE(v)),
  T_FILETIME: primitive(65, 8, (b, v) => b.writeBigUInt64LE(v)),
  STRING: primitive(30, 81, (b, v) => b.write(`${v}\0`, 'latin1')),
};

/** A variable. `value` returns its content at a given time of the PLC (nanoseconds since 1970, BigInt). `count` > 0 makes it an array. */
export class PlcSymbol {
  constructor(name, typeName, value, { count = 0, first = 0 } = {}) {
    Object.assign(this, { name, typeName, value, count, first });
    this.item = types[typeName];
    this.size = this.item.size * Math.max(1, count);
  }

  get declaredType() {
    return this.count === 0 ? this.typeName : `ARRAY [${this.first}..${this.first + this.count - 1}] OF ${this.typeName}`;
  }

  image(nanoseconds) {
    const bytes = Buffer.alloc(this.size);
    const value = this.value(nanoseconds);
    const values = this.count === 0 ? [value] : value;
    values.forEach((item, index) => this.item.write(bytes.subarray(index * this.item.size), item));
    return bytes;
  }

  /** Returns the element with the given index. As in the PLC, indices start at `first`. */
  element(index) {
    const place = index - this.first;
    if (this.count === 0 || place < 0 || place >= this.count) return undefined;
    const one = new PlcSymbol(`${this.name}[${index}]`, this.typeName, time => this.value(time)[place]);
    one.offset = this.offset + place * this.item.size;
    return one;
  }
}

const text = string => Buffer.from(`${string}\0`, 'latin1');

/** Returns an AdsSymbolEntry: 30 bytes, then name, type and comment, each terminated by zero; for an array, then its first index and length. */
export function symbolEntry(symbol, indexGroup) {
  const isArray = symbol.count > 0;
  const lengths = Buffer.alloc(10);
  [0, isArray ? 1 : 0, symbol.name.length, symbol.declaredType.length, 0].forEach((value, index) => lengths.writeUInt16LE(value, 2 * index));
  const body = Buffer.concat([
    words(indexGroup, symbol.offset, symbol.size, symbol.item.type), lengths,
    text(symbol.name), text(symbol.declaredType), text(''), isArray ? words(symbol.first, symbol.count) : Buffer.alloc(0),
  ]);
  return Buffer.concat([words(4 + body.length), body]);
}

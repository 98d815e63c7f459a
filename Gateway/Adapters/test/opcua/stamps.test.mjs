import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DataType, DataValue, Variant, VariantArrayType } from './library.mjs';
import { parts } from '../parts.mjs';

const { ofDate, sourceStamp, timeIn } = await parts('opcua/stamps');
const T = 1_795_209_379_993_125_900n;
const halves = value => [Number(BigInt.asUintN(64, value) >> 32n), Number(value & 0xffffffffn)];
const variant = (dataType, value) => new Variant({ dataType, arrayType: VariantArrayType.Scalar, value });

describe('stamps of OPC UA', () => {
  it('SourceTimestamp_WithPicoseconds_KeepsTheResolutionOf100ns', () => {
    const sourceTimestamp = new Date(Number(T / 1_000_000n));

    assert.equal(sourceStamp(new DataValue({ sourceTimestamp, sourcePicoseconds: 125_900_000 })), T);
  });

  it('SourceTimestamp_Picoseconds_AreTruncatedToNanoseconds', () =>
    assert.equal(ofDate(new Date(0), 125_912_340), 125_912n));

  for (const [name, date] of [
    ['None', null], ['Earliest', new Date(Date.UTC(1601, 0, 1))], ['Latest', new Date(Date.UTC(9999, 11, 31))], ['Invalid', new Date(NaN)],
  ]) it(`Date_${name}_IsNotATime`, () => assert.equal(ofDate(date), null));

  for (const [name, value, unit, expected] of [
    ['DateTime', variant(DataType.DateTime, Object.assign(new Date(Number(T / 1_000_000n)), { picoseconds: 125_900_000 })), null, T],
    ['Int64', variant(DataType.Int64, halves(T)), null, T],
    ['UInt64', variant(DataType.UInt64, halves(T)), 'ns', T],
    ['Int64Before1970', variant(DataType.Int64, halves(-5n)), null, -5n],
    ['Int64Microseconds', variant(DataType.Int64, halves(T / 1000n)), 'us', T / 1000n * 1000n],
    ['UInt64FileTime', variant(DataType.UInt64, halves(T / 100n + 116_444_736_000_000_000n)), 'filetime', T],
    ['UInt64DistributedClock', variant(DataType.UInt64, halves(T - 946_684_800_000_000_000n)), 'dctime', T],
    ['UInt32Seconds', variant(DataType.UInt32, 1_795_209_379), 's', null],
    ['Real', variant(DataType.Float, 1_795_209_379), 's', null],
    ['Text', variant(DataType.String, '2026'), null, null],
    ['NaN', variant(DataType.Double, NaN), 's', null],
  ]) it(`TimeVariable_${name}_${expected === null ? 'IsNotATime' : 'IsRead'}`, () => assert.equal(timeIn(value, unit), expected));

  it('TimeVariable_SecondsAsLReal_HasTheAccuracyOfADouble', () => {
    const time = timeIn(variant(DataType.Double, Number(T) / 1e9), null);

    assert.ok(Math.abs(Number(time - T)) <= 240, `${time - T} ns`);
  });
});

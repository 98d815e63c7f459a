import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DataType, DataValue, StatusCodes, Variant, VariantArrayType } from './library.mjs';
import { parts } from '../parts.mjs';

const { statusRefusal, valueOf, isOverflown } = await parts('opcua/nodeValues');
const halves = value => [Number(BigInt.asUintN(64, value) >> 32n), Number(value & 0xffffffffn)];
const data = (dataType, value, arrayType = VariantArrayType.Scalar) => new DataValue({ value: new Variant({ dataType, arrayType, value }) });
const joint = index => ({ joint: 'a', node: 'ns=1;s=x', scale: 1, offset: 0, ...index === undefined ? {} : { index } });

describe('values of nodes', () => {
  for (const [name, value] of [
    ['Missing', Object.assign(new DataValue({}), { value: null })],
    ['Null', new DataValue({ value: new Variant({ dataType: DataType.Null }) })],
  ]) it(`Value_${name}WithGoodStatus_IsRefused`, () => assert.equal(statusRefusal(value).reason, 'type'));

  for (const [name, status, reason] of [
    ['Good', StatusCodes.Good, undefined],
    ['GoodClamped', StatusCodes.GoodClamped, undefined],
    ['GoodWithOverflow', StatusCodes.makeStatusCode('Good', 'Overflow'), undefined],
    ['Bad', StatusCodes.BadSensorFailure, 'status-bad'],
    ['Uncertain', StatusCodes.UncertainSubNormal, 'status-uncertain'],
  ]) {
    it(`Status_${name}_${reason === undefined ? 'IsAccepted' : 'IsRefused'}`, () => {
      const value = data(DataType.Double, 1);
      value.statusCode = status;

      assert.equal(statusRefusal(value)?.reason, reason);
    });
  }

  it('Status_WithOverflow_IsDetected', () => {
    assert.equal(isOverflown(StatusCodes.makeStatusCode('Good', 'Overflow')), true);
    assert.equal(isOverflown({ value: 0x480 }), true);
    assert.equal(isOverflown(StatusCodes.BadNoCommunication), false);
  });

  it('Value_ScalarOrArrayElement_IsFound', () => {
    const cases = [
      [data(DataType.Float, 0.5), undefined, 0.5],
      [data(DataType.UInt16, 7), undefined, 7],
      [data(DataType.Int64, halves(-12345678901n)), undefined, -12345678901n],
      [data(DataType.Double, Float64Array.of(1, 2, 3), VariantArrayType.Array), 2, 3],
      [data(DataType.Int64, [halves(5n), halves(-6n)], VariantArrayType.Array), 1, -6n],
    ];

    for (const [value, index, expected] of cases) assert.equal(valueOf(joint(index), value).value, expected);
  });

  it('Value_IndexInEmptyArray_IsNotFoundAndNoIndexIsAllowed', () => {
    const { reason, text } = valueOf(joint(0), data(DataType.Double, new Float64Array(), VariantArrayType.Array));

    assert.equal(reason, 'index');
    assert.doesNotMatch(text, /allowed/);
  });
});

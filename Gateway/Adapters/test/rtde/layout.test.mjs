// Compares the sent bytes with bytes that were written by hand from UR's RTDE guide, and tests streams that are not RTDE.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { seeded } from '../seeded.mjs';
import { byte, doubles, int, packageOf } from './bytes.mjs';
import { messages } from '../messages.mjs';

const { fieldMessages } = messages;

const { PackageReader, NotRtdeError, Recipe, RecipeError, MissingFieldsError, fieldsOf, ...packages } = await parts('rtde/packages', 'rtde/recipe');

const hex = buffer => buffer.toString('hex');

const NAMES = 'timestamp,actual_q,actual_qd,target_q,target_qd,runtime_state,robot_mode,safety_mode,safety_status_bits';
const TYPES = 'DOUBLE,VECTOR6D,VECTOR6D,VECTOR6D,VECTOR6D,UINT32,INT32,INT32,UINT32';

const answer = (types, id = 1) => Buffer.concat([byte(id), Buffer.from(types)]);

const recipe = () => new Recipe(fieldsOf('actual'), answer(TYPES));

const PAYLOAD = Buffer.concat([
  byte(1), doubles(1234.568), doubles(0.1, -1.5, 2.25, 0, 3, -3), doubles(1, 2, 3, 4, 5, 6),
  doubles(0.1, -1, 2.25, 0.5, 3, -3), doubles(-1, -2, -3, -4, -5, -6), int(2), int(-1), int(3), int(0x404),
]);

describe('rtde layout', () => {
  it('Request_OfEachType_HasTheBytesOfTheGuide', () => {
    assert.equal(hex(packages.protocolVersion(2)), '0005' + '56' + '0002');
    assert.equal(hex(packages.controllerVersion()), '0003' + '76');
    // 125 Hz is 405f400000000000 as a double. The names are in ASCII without a terminator.
    assert.equal(hex(packages.setUpOutputs(125, ['timestamp', 'actual_q'])), '001d' + '4f' + '405f400000000000' + '74696d657374616d70' + '2c' + '61637475616c5f71');
    assert.equal(hex(packages.start()), '0003' + '53');
  });

  it('Reader_PackagesInPieces_ReturnsCompletePackages', () => {
    const stream = Buffer.concat([packageOf('V', byte(1)), packageOf('S', byte(1)), packageOf('U', PAYLOAD), packageOf('v', ...[5, 11, 1, 7].map(int))]);

    for (let size = 1; size <= stream.length; size++) {
      const reader = new PackageReader(), found = [];
      for (let at = 0; at < stream.length; at += size)
        found.push(...reader.add(stream.subarray(at, at + size)).map(({ type, payload }) => [type, hex(payload)]));

      assert.deepEqual(found.map(([type]) => type), [86, 83, 85, 118]);
      assert.equal(found[2][1], hex(PAYLOAD));
      assert.equal(reader.waiting, 0);
    }
  });

  for (const [what, bytes] of [
    ['Zeros', Buffer.alloc(64)], ['SshBanner', Buffer.from('SSH-2.0-OpenSSH_9.2\r\n')], ['Http', Buffer.from('HTTP/1.1 400 Bad Request\r\n')],
    ['SizeBelowItsHeader', Buffer.from([0, 2, 85])], ['UnknownType', Buffer.from([0, 9, 66])],
  ])
    it(`Reader_${what}_RejectsTheBytesAsNotRtde`, () => assert.throws(() => new PackageReader().add(bytes), NotRtdeError));

  it('Reader_RandomBytes_ReturnsPackagesOrThrowsWithLimitedMemory', () => {
    let rejected = 0;
    for (let seed = 1; seed <= 2000; seed++) {
      const random = seeded(seed), reader = new PackageReader();
      const stream = Buffer.concat(Array.from({ length: 20 }, () => packageOf('U', PAYLOAD)));
      for (let i = 0; i < 3; i++) stream[Math.floor(random() * stream.length)] = Math.floor(random() * 256);
      try {
        for (let at = 0; at < stream.length;) {
          const size = 1 + Math.floor(random() * 300);
          for (const { payload } of reader.add(stream.subarray(at, at + size))) recipe().decode(payload);
          at += size;
          assert.ok(reader.waiting <= 65535, `seed ${seed}`);
        }
      } catch (error) {
        assert.ok(error instanceof NotRtdeError, `seed ${seed}: ${error.stack}`);
        rejected++;
      }
    }
    assert.ok(rejected > 50 && rejected < 2000, `${rejected} of 2000 rejected`);
  });

  it('Recipe_DataPackage_DecodesEachFieldAtItsOffset', () => {
    const cycle = recipe().decode(PAYLOAD);

    assert.deepEqual(cycle, {
      timestamp: 1234.568, positions: [0.1, -1.5, 2.25, 0, 3, -3], velocities: [1, 2, 3, 4, 5, 6], deviations: [0, 0.5, 0, 0.5, 0, 0],
      runtimeState: 2, robotMode: -1, safetyMode: 3, safetyBits: 0x404,
    });
    assert.equal(fieldsOf('actual').map(field => field.name).join(','), NAMES);
  });

  for (const [what, payload, text] of [
    ['TooShort', PAYLOAD.subarray(0, 40), fieldMessages.packageSize(40, PAYLOAD.length)],
    ['TooLong', Buffer.concat([PAYLOAD, byte(0)]), fieldMessages.packageSize(PAYLOAD.length + 1, PAYLOAD.length)],
    ['OfAnotherRecipe', Buffer.concat([byte(2), PAYLOAD.subarray(1)]), fieldMessages.packageRecipe(2, 1)],
    ['WithoutATime', Buffer.concat([byte(1), doubles(NaN), PAYLOAD.subarray(9)]), fieldMessages.packageTime(NaN)],
  ])
    it(`Recipe_Package${what}_IsRefusedWithAReason`, () => assert.equal(recipe().decode(payload), text));

  it('Recipe_OptionalFieldsMissing_ListsTheirNames', () =>
    assert.throws(() => new Recipe(fieldsOf('actual'), answer(TYPES.replace('UINT32,INT32', 'NOT_FOUND,INT32').replace(/UINT32$/, 'NOT_FOUND'))),
      error => error instanceof MissingFieldsError && error.names.join() === 'runtime_state,safety_status_bits'));

  for (const [what, types, text] of [
    ['Missing', TYPES.replace('VECTOR6D', 'NOT_FOUND'), fieldMessages.needed('actual_q')],
    ['OfAnotherType', TYPES.replace('VECTOR6D', 'VECTOR6INT32'), fieldMessages.otherType('actual_q', 'VECTOR6INT32', 'VECTOR6D')],
    ['CountDiffers', 'DOUBLE', fieldMessages.recipe(9, 1)],
  ])
    it(`Recipe_RequiredField${what}_ThrowsAnError`, () =>
      assert.throws(() => new Recipe(fieldsOf('actual'), answer(types)), error => error instanceof RecipeError && error.message === text));

  it('Recipe_ConfiguredFieldsOfEachType_AreRead', () => {
    const fields = [{ name: 'timestamp', type: 'DOUBLE' }, { name: 'actual_q', type: 'VECTOR6D' },
      ...['flag', 'byte', 'bits', 'voltage', 'load', 'force', 'modes', 'counts', 'elbow', 'wide'].map(name => ({ name, isOptional: true }))];
    const types = 'DOUBLE,VECTOR6D,BOOL,UINT8,UINT32,INT32,DOUBLE,VECTOR6D,VECTOR6INT32,VECTOR6UINT32,VECTOR3D,UINT64';
    const payload = Buffer.concat([
      byte(1), doubles(1, 0, 0, 0, 0, 0, 0), byte(1), byte(0xa5), int(-0x7ffffffe), int(-24), doubles(1.5), doubles(1, 2, 3, 4, 5, 6),
      ...[-1, -2, -3, -4, -5, -6].map(int), ...[1, 2, 3, 4, 5, -1].map(int), doubles(7, 8, 9), int(-0x80000000), int(0x20001),
    ]);
    const mixed = new Recipe(fields, answer(types));
    const read = address => mixed.objectionTo(address) ?? mixed.read(payload, address);

    assert.equal(typeof mixed.decode(payload), 'object');
    assert.deepEqual(
      [{ field: 'flag' }, { field: 'byte' }, { field: 'byte', bit: 5 }, { field: 'bits', bit: 31 }, { field: 'voltage' },
        { field: 'load' }, { field: 'force', index: 5 }, { field: 'modes', index: 1 }, { field: 'counts', index: 5 }, { field: 'elbow', index: 2 },
        { field: 'wide', bit: 63 }].map(read),
      [1, 0xa5, 0xa5, 0x80000002, -24, 1.5, 6, -2, 0xffffffff, 9, 0x8000000000020001n]);
    for (const [address, text] of [
      [{ field: 'none' }, fieldMessages.unknown('none')], [{ field: 'force' }, fieldMessages.index('force', 6)],
      [{ field: 'elbow', index: 3 }, fieldMessages.index('elbow', 3)],
      [{ field: 'load', index: 0 }, fieldMessages.oneNumber('load')], [{ field: 'load', bit: 0 }, fieldMessages.noBits('load')],
      [{ field: 'byte', bit: 8 }, fieldMessages.bit('byte', 8)],
    ])
      assert.equal(read(address), text);
  });

  it('Recipe_ConfiguredFieldOfUnknownType_ThrowsAnError', () =>
    assert.throws(() => new Recipe(fieldsOf('actual', [{ field: 'payload' }]), answer(`${TYPES},VECTOR7D`)), {
      message: fieldMessages.otherType('payload', 'VECTOR7D', fieldMessages.notType),
    }));

  it('Fields_UsedBySeveralSignals_AreRequestedOnce', () => {
    const bits = [0, 1].map(bit => ({ field: 'actual_digital_output_bits', bit }));

    const names = fieldsOf('target', [...bits, { field: 'robot_mode' }]).map(({ name }) => name);

    assert.equal(names.join(','), `${NAMES},actual_digital_output_bits`);
  });

  it('Recipe_WithoutOptionalFields_DecodesThemAsNull', () => {
    const fields = fieldsOf('target').filter(field => !field.isOptional);

    const cycle = new Recipe(fields, answer('DOUBLE,VECTOR6D', 4), 'target').decode(Buffer.concat([byte(4), doubles(2, 1, 2, 3, 4, 5, 6)]));

    assert.deepEqual([cycle.timestamp, cycle.positions, cycle.velocities, cycle.robotMode], [2, [1, 2, 3, 4, 5, 6], null, null]);
  });

  it('TextMessage_OfEitherProtocolVersion_IsRead', () => {
    assert.equal(packages.textOf(Buffer.concat([byte(5), Buffer.from('hello'), byte(3), Buffer.from('ur5'), byte(3)])), 'ur5: hello');
    assert.equal(packages.textOf(Buffer.concat([byte(2), Buffer.from('robot is tired')])), 'robot is tired');
    assert.equal(packages.textOf(Buffer.from([200, 1, 2])), null);
    assert.equal(packages.textOf(Buffer.alloc(0)), null);
  });
});

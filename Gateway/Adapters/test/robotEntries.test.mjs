// The entries of joints compared with each other and with the robot description.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { wrongIn } from './checking.mjs';
import { messages } from './messages.mjs';
import { parts } from './parts.mjs';
import { temporaryFile } from './temporary.mjs';

const { kinds, readConfiguration } = await parts('configuration/configuration', 'kinds');
const { configurationMessages, robotMessages } = messages;

const ARM = `<robot name="arm">
  <joint type="revolute" name="elbow"/><joint name="turntable" type='continuous'/><joint name="axis > 1" type="prismatic"/>
  <transmission><joint name="axis > 1"><mechanicalReduction>1</mechanicalReduction></joint></transmission>
</robot>`;

/** Writes a plant file and the description of its robot. */
function plant(joints, urdf = ARM) {
  const path = temporaryFile('plant.yaml', `plant: { kind: opcua, endpoint: opc.tcp://plc }\nrobot: arm.urdf\njoints:\n${joints}`);
  writeFileSync(join(dirname(path), 'arm.urdf'), urdf);
  return path;
}

describe('file of the robot description', () => {
  for (const [name, encoded] of [['Utf8WithMark', Buffer.from(`\ufeff${ARM}`)], ['Utf16', Buffer.from(`\ufeff${ARM}`, 'utf16le')]])
    it(`Check_${name}_IsReadWithoutTheMark`, () => {
      const path = plant('  - { joint: elbow, node: i=1, unit: deg }\n', encoded);

      assert.deepEqual(wrongIn(path), []);
      assert.equal(readConfiguration(path, {}, kinds).robot, ARM);
    });
});

describe('units of joints', () => {
  for (const [joint, unit, type, allowed] of [
    ['elbow', 'mm', 'revolute', ['rad', 'deg']], ['turntable', 'm', 'continuous', ['rad', 'deg']], ['axis > 1', 'deg', 'prismatic', ['m', 'mm']],
  ])
    it(`Check_${unit}Of${type}Joint_NamesTypeAndAllowedUnits`, () => {
      const path = plant(`  - { joint: ${joint}, node: i=1, unit: ${unit} }\n`);

      assert.deepEqual(wrongIn(path), [`${path}, line 4: joints[0].unit: ${robotMessages.wrongUnit(unit, joint, type, allowed)}`]);
    });

  it('Check_UnitsThatFitOrAreAbsent_FindsNoError', () => {
    const path = plant('  - { joint: elbow, node: i=1, unit: deg }\n  - { joint: turntable, node: i=2 }\n  - { joint: axis > 1, node: i=3, scale: 0.01 }\n');

    assert.deepEqual(wrongIn(path), []);
    assert.deepEqual(readConfiguration(path, {}, kinds).joints.map(({ isLinear }) => isLinear), [false, false, true]);
  });
});

describe('conversion of joints', () => {
  for (const [entries, expected] of [
    ['unit: deg, scale: -1', [-Math.PI / 180, false]], ['unit: mm, scale: -0.5', [-0.0005, true]], ['scale: 0.001', [0.001, false]], ['unit: deg', [Math.PI / 180, false]],
  ])
    it(`Joint_${entries}_HasTheProductOfBoth`, () => {
      const path = temporaryFile('plant.yaml', `plant: { kind: opcua, endpoint: opc.tcp://plc }\njoints:\n  - { joint: a, node: i=1, ${entries} }\n`);

      const { joints: [{ scale, isLinear }] } = readConfiguration(path, {}, kinds);

      assert.deepEqual([scale, isLinear], expected);
    });

  for (const [entries, degrees, radians] of [
    ['joint: elbow, node: i=1, unit: deg, offset: 180', 180, 3.14159], ['joint: turntable, node: i=1, offset: -90', -90, -1.5708],
  ])
    it(`Check_OffsetOf${degrees}OfARotaryJoint_WarnsWithTheOffsetInRadians`, () => {
      const { file, warnings } = readConfiguration(plant(`  - { ${entries} }\n`), {}, kinds);

      assert.deepEqual(warnings, [`${file}, line 4: joints[0].offset: ${configurationMessages.offsetBeyondATurn(degrees, radians)}`]);
    });

  it('Check_OffsetsOfUpToATurnOrOfALinearJoint_WarnsOfNone', () => {
    const path = plant('  - { joint: elbow, node: i=1, unit: deg, offset: -6.2832 }\n  - { joint: axis > 1, node: i=3, scale: 0.01, offset: 12 }\n');

    assert.deepEqual(readConfiguration(path, {}, kinds).warnings, []);
  });
});

describe('addresses of joints', () => {
  const linesIn = (joints, others = '') => readConfiguration(temporaryFile('plant.yaml', `plant: { kind: opcua, endpoint: opc.tcp://plc }
joints:
${joints}${others}`), {}, kinds).warnings.map(line => line.replace(/^.*?, line/, 'line'));

  it('Check_TwoJointsWithTheSameAddress_WarnsOfTheSecond', () => {
    const lines = linesIn('  - { joint: elbow, node: i=1, index: 2 }\n  - { joint: wrist, node: i=1, index: 2 }\n  - { joint: tool, node: i=1, index: 3 }\n');

    assert.deepEqual(lines, [`line 4: joints[1]: ${configurationMessages.addressTwice('node i=1, index 2', 'elbow', 3)}`]);
  });

  it('Check_TwoJointsWithTheSameAddressAndAnotherScaleOrOffset_WarnsOfNone', () => {
    const joints = ['scale: 1', 'scale: -1', 'scale: 1, offset: 0.5'].map((more, i) => `  - { joint: finger${i}, node: i=1, ${more} }\n`);

    assert.deepEqual(linesIn(joints.join('')), []);
  });

  it('Check_TwoNumbersOfAFrameWithTheSameAddress_WarnsOfTheSecond', () => {
    const position = (x, y) => `position: { unit: m, x: { node: ${x} }, y: { node: ${y} }, z: 0 }`;
    const lines = linesIn('  - { joint: elbow, node: i=1 }\n', `frames:
  - { frame: part, ${position('i=1', 'i=1')} }
  - { frame: other, ${position('i=1', 'i=2')} }
signals:
  - { signal: a, node: i=1 }
  - { signal: b, node: i=1 }
`);

    assert.deepEqual(lines, [`line 5: frames[0].position.y: ${configurationMessages.addressTwice('node i=1', 'part x', 5)}`]);
  });
});

describe('length of a robot description', () => {
  const withComment = text => ARM.replace('</robot>', `<!-- ${text} --></robot>`);

  it('Check_DescriptionThatFitsOnlyWithoutEscapes_IsRefused', () => {
    // Each quotation mark is two bytes in a JSON string.
    const urdf = withComment('"'.repeat(600_000));
    const path = plant('  - { joint: elbow, node: i=1 }\n', urdf);
    const [bytes, most] = [JSON.stringify(urdf).length, 1024 * 1024 - 256];

    assert.deepEqual(wrongIn(path), [`${path}, line 2: robot: ${robotMessages.tooLarge('arm.urdf', bytes, most)}`]);
    writeFileSync(join(dirname(path), 'arm.urdf'), withComment('"'.repeat(500_000)));
    assert.deepEqual(wrongIn(path), []);
  });
});

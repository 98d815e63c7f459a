// The entries of joints compared with each other and with the robot description.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { wrongIn } from './checking.mjs';
import { messages } from './messages.mjs';
import { temporaryFile } from './temporary.mjs';

const { robotMessages } = messages;

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

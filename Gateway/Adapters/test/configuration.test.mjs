import assert from 'node:assert/strict';
import { chmodSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { wrongIn } from './checking.mjs';
import { parts } from './parts.mjs';
import { check } from './program.mjs';
import { temporaryFile } from './temporary.mjs';

const { readConfiguration } = await parts('configuration/configuration');

const GOOD = `gateway:
  url: ws://127.0.0.1:47011
plant:
  kind: opcua
  endpoint: opc.tcp://plc.example:4840
joints:
  - joint: arm_joint_1
    node: ns=4;s=MAIN.axis[1].position
    unit: deg
  - joint: arm_joint_2
    node: ns=4;i=1002
    scale: 0.5
    offset: -1.5
`;

/** Returns the errors after one change of the valid file. */
function linesOf(from, to) {
  const text = GOOD.replace(from, to);
  assert.notEqual(text, GOOD);
  const path = temporaryFile('plant.yaml', text);
  return wrongIn(path).map(line => line.replace(`${path}, `, ''));
}

describe('configuration', () => {
  it('Check_ValidFile_NamesEndpointAndJoints', async t => {
    const path = temporaryFile('plant.yaml', GOOD);

    const { status, out } = await check(t, path);

    assert.equal(status, 0);
    assert.match(out, /plant\.yaml is valid: .*opc\.tcp:\/\/plc\.example:4840.*arm_joint_1, arm_joint_2\n$/);
  });

  it('Check_StartedByTheGateway_AddsTheContentAsJson', async t => {
    const path = temporaryFile('plant.yaml', GOOD);

    const { status, out } = await check(t, path, { ...process.env, NOWPOSE_SUPERVISED: '1' });

    const [, content] = out.split('\n');
    assert.deepEqual([status, JSON.parse(content)], [0, { name: 'opcua', joints: ['arm_joint_1', 'arm_joint_2'], passes_unlisted: false, has_objects: false, robot: null, robots: {} }]);
  });

  for (const [name, from, to, expected] of [
    ['UnknownKind', 'kind: opcua', 'kind: opcau', /^line 4: plant\.kind: value "opcau"; did you mean opcua\? allowed: .*opcua/],
    ['KeyWithALineSeparator', 'plant:', '\u2028lant:', /^line 3: \\u2028lant: not known here; did you mean plant\?$/],
    ['NoKind', '  kind: opcua\n', '', /^line 3: plant\.kind: missing; .*opcua/],
    ['NoPlant', /plant:\n.*\n.*\n/, '', /^line 1: plant: missing/],
    ['KindMisspelt', 'kind: opcua', 'kindx: opcua', /^line 4: plant\.kindx: not known here; did you mean kind\?$/],
    ['PlantMisspelt', 'plant:', 'plantx:', /^line 3: plantx: not known here; did you mean plant\?$/],
    ['PlantEmpty', /plant:\n.*\n.*\n/, 'plant:\n', /^line 3: plant: missing; add the section plant with its kind/],
    ['PortTooLarge', 'plc.example:4840', 'plc.example:99999', /^line 5: plant\.endpoint: value "opc.*:99999"; allowed: .* from 1 to 65535$/],
    ['PortOfZero', 'plc.example:4840', 'plc.example:0', /^line 5: plant\.endpoint: .* from 1 to 65535$/],
    ['PortInWords', 'plc.example:4840', 'plc.example:abc', /^line 5: plant\.endpoint: .* from 1 to 65535$/],
    ['NoHost', 'plc.example:4840', ':4840', /^line 5: plant\.endpoint: .* a host and/],
    ['GatewayPort', 'ws://127.0.0.1:47011', 'ws://127.0.0.1:470111', /^line 2: gateway\.url: .* from 1 to 65535$/],
    ['NamespaceTooLarge', 'ns=4;i=1002', 'ns=65536;i=1002', /^line 11: joints\[1\]\.node: .*; a namespace \(ns\) must be a number from 0 to 65535$/],
    ['NodeNumberTooLarge', 'ns=4;i=1002', 'ns=4;i=4294967296', /^line 11: joints\[1\]\.node: .* from 0 to 4294967295$/],
    ['TimeNodeTooLarge', 'joints:', '  time: {node: ns=65536;s=t}\njoints:', /^line 6: plant\.time\.node: .* from 0 to 65535$/],
    ['UnknownKey', 'endpoint: opc', 'endpont: opc', /^line 5: plant\.endpont: not known here; did you mean endpoint\?/],
    ['UnknownSection', 'joints:', 'axes:', /^line 6: axes: not known here; allowed: gateway, plant, joints, frames, signals, robot, robots$/],
    ['WrongEndpoint', 'opc.tcp://plc.example:4840', 'http://plc', /^line 5: plant\.endpoint: value "http:\/\/plc"; allowed: .*opc\.tcp:\/\/HOST/],
    ['PasswordInEndpoint', 'opc.tcp://plc', 'opc.tcp://me:word@plc', /^line 5: plant\.endpoint: .*without user name or password$/],
    ['PasswordWithSlash', 'opc.tcp://plc', 'opc.tcp:/me:wo/rd@x@plc', /^line 5: plant\.endpoint: value "opc\.tcp:\/\*\*\*@plc/],
    ['UnknownUnit', 'unit: deg', 'unit: degrees', /^line 9: joints\[0\]\.unit: value "degrees"; did you mean deg\? allowed: rad, deg, m, mm$/],
    ['UnitAndScale', 'scale: 0.5', 'scale: 0.5\n    unit: mm', /^line 12: joints\[1\]\.scale: the unit already determines the scale/],
    ['ScaleOfZero', 'scale: 0.5', 'scale: 0', /^line 12: joints\[1\]\.scale: value 0; allowed: .*not 0/],
    ['ScaleInWords', 'scale: 0.5', 'scale: half', /^line 12: joints\[1\]\.scale: value "half"; allowed: a number/],
    ['OffsetNaN', 'offset: -1.5', 'offset: .nan', /^line 13: joints\[1\]\.offset: value \.nan; /],
    ['OffsetInfinite', 'offset: -1.5', 'offset: -.inf', /^line 13: joints\[1\]\.offset: value -\.inf; /],
    ['NoNode', '    node: ns=4;i=1002\n', '', /^line 10: joints\[1\]\.node: missing; add the node's id as ns=/],
    ['WrongNode', 'ns=4;i=1002', 'MAIN.x', /^line 11: joints\[1\]\.node: value "MAIN\.x"; allowed: .*ns=NUMBER;s=NAME/],
    ['JointTwice', 'arm_joint_2', 'arm_joint_1', /^line 10: joints\[1\]\.joint: value "arm_joint_1"; line 7 already has this joint/],
    ['KeyTwice', 'unit: deg', 'unit: deg\n    unit: rad', /^line 10: this key occurs twice/],
    ['Tab', '  endpoint', '\tendpoint', /^line 5: a tab precedes the entry/],
    ['AliasWithoutEnd', 'gateway:', '&all\ngateway: *all\nown:', /^line 1: an alias \(\*\) refers to an entry that contains it; write the entry out$/],
    ['NoYaml', 'unit: deg', 'unit: "deg', /^line \d+: not valid YAML: /],
    ['JointsNoList', /joints:[^]*/, 'joints: {}\n', /^line 6: joints: value \{\}; allowed: a list of joints/],
    ['GatewayNoWebSocket', 'ws://127.0.0.1:47011', '127.0.0.1', /^line 2: gateway\.url: value "127\.0\.0\.1"; allowed: .*ws:\/\/HOST:PORT/],
    ['PinWithoutTls', 'plant:', `  pin: sha256/${'A'.repeat(43)}=\nplant:`, /^line 3: gateway\.pin: not used with ws:\/\/; write wss:\/\//],
    ['OpenAndGuarded', 'joints:', '  security: { i_know_this_is_open: true }\njoints:', /^line 6: plant\.security\.i_know_this_is_open: security\.mode is sign_and_encrypt/],
    ['WrongPin', 'plant:', '  pin: sha256/abc\nplant:', /^line 3: gateway\.pin: value "sha256\/abc"; allowed: the pin/],
    ['TokenInFile', 'plant:', '  token: hush-hush\nplant:', /^line 3: gateway\.token: not known here; did you mean token_file\?/],
    ['NoTokenFile', 'plant:', '  token_file: none\nplant:', /^line 3: gateway\.token_file: value "none"; the file cannot be read \(ENOENT\)/],
    ['SilenceMisspelt', 'joints:', '  silence: rset\njoints:', /^line 6: plant\.silence: value "rset"; allowed: .*rest .*fault_after_s: SECONDS/],
    ['SilenceWithoutTime', 'joints:', '  silence: {}\njoints:', /^line 6: plant\.silence\.fault_after_s: missing; add a time from 0\.5 to 3600 s$/],
    ['SilenceTooShort', 'unit: deg', 'unit: deg\n    silence: {fault_after_s: 0.1}', /^line 10: joints\[0\]\.silence\.fault_after_s: value 0\.1; allowed: a time from 0\.5 to 3600 s$/],
    ['DecelerationOfZero', 'unit: deg', 'unit: deg\n    max_deceleration: 0', /^line 10: joints\[0\]\.max_deceleration: value 0; allowed: a number above 0/],
    ['NoRobotFile', 'plant:', 'robot: none.urdf\nplant:', /^line 3: robot: value "none\.urdf"; the file cannot be read/],
  ]) {
    it(`Check_${name}_NamesLineAndRemedy`, () => {
      const lines = linesOf(from, to);

      assert.equal(lines.filter(line => expected.test(line)).length, 1, lines.join('\n'));
      assert.doesNotMatch(lines.join('\n'), /hush-hush|word@|wo\/rd/);
    });
  }

  it('Joint_Silence_OverridesThatOfThePlant', () => {
    const joints = `joints:
  - { joint: a, node: i=1, unit: mm, silence: rest, max_deceleration: 2 }
  - { joint: b, node: i=2 }
`;
    const path = temporaryFile('plant.yaml', GOOD.replace(/joints:[^]*/, `  silence: {fault_after_s: 3}\n  max_deceleration: 15\n${joints}`));

    const read = readConfiguration(path, {}, {}).joints.map(({ faultAfterMs, maxDeceleration, isLinear }) => [faultAfterMs, maxDeceleration, isLinear]);

    assert.deepEqual(read, [[null, 2, true], [3000, 15, false]]);
  });

  it('Silence_NotConfigured_MeansRestForChangesAndFaultForPeriodicSources', () => {
    const silenceOf = text => readConfiguration(temporaryFile('plant.yaml', text), {}, {}).plant.silence;

    assert.equal(silenceOf(GOOD), 'rest');
    assert.deepEqual(silenceOf('plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\n'), { fault_after_s: 1 });
  });

  it('Check_Tab_IsTheOnlyReportedError', () => {
    const lines = linesOf('  endpoint', '\tendpoint');

    assert.deepEqual(lines, ['line 5: a tab precedes the entry; YAML allows spaces only, so replace the tab']);
  });

  it('Check_NoPlant_ReportsOtherUnknownEntries', () => {
    const lines = linesOf(/plant:\n.*\n.*\n/, 'endpont: plc\n');

    assert.equal(lines.length, 2, lines.join('\n'));
    assert.match(lines[0], /^line 1: plant: missing/);
    assert.match(lines[1], /^line 3: endpont: not known here; allowed: gateway, plant, joints, frames, signals, robot, robots/);
  });

  it('Check_AddressesOfAllForms_AreValid', () => {
    for (const address of ['plc', 'plc:1/path', '[fe80::1]', '[fe80::1%eth0]:4840', '[::1]:65535', '10.0.0.1:4840/a/b'])
      assert.deepEqual(wrongIn(temporaryFile('plant.yaml', GOOD.replace('plc.example:4840', address))), [], address);
  });

  it('Check_JointUnknownToTheRobot_NamesLineAndNearestName', () => {
    const path = temporaryFile('plant.yaml', `${GOOD.replace('joint: arm_joint_2', 'joint: arm_jiont_2')}robot: arm.urdf\n`);
    const joints = ['<joint type="revolute" name="arm_joint_1">', "<joint\n name = 'arm_joint_2'>", '<!-- <joint name="arm_jiont_2"/> -->'];
    writeFileSync(join(dirname(path), 'arm.urdf'), `<robot name="arm">${joints.join('</joint>')}</robot>`);

    const lines = wrongIn(path);

    assert.equal(lines.length, 1, lines.join('\n'));
    assert.match(lines[0], /line 10: joints\[1\]\.joint: value "arm_jiont_2"; the robot has no such joint, did you mean arm_joint_2\?$/);
    writeFileSync(path, GOOD);
    assert.deepEqual(wrongIn(path), []);
  });

  it('Check_SeveralInvalidEntries_AreReportedTogetherInOrder', () => {
    const lines = linesOf(/unit: deg[^]*/, 'unit: feet\n  - joint: ""\n    node: 3\n    offset: much\n  - {}\n');

    assert.deepEqual(lines.map(line => Number(/line (\d+)/.exec(line)[1])), [9, 10, 11, 12, 13, 13]);
  });

  it('Check_InvalidFile_EndsWithStatusTwo', async t => {
    const path = temporaryFile('plant.yaml', GOOD.replace('unit: deg', 'unit: feet'));

    const { status, lines } = await check(t, path);

    assert.equal(status, 2);
    assert.deepEqual(lines, wrongIn(path));
  });

  it('Check_MissingFile_IsReported', async t => {
    const { status, lines } = await check(t, 'nowhere.yaml');

    assert.equal(status, 2);
    assert.match(lines[0], /^nowhere\.yaml, line 1: cannot be read \(ENOENT\)/);
  });

  it('Check_TokenFileReadableByAll_IsRefusedWithoutShowingTheToken', { skip: process.platform === 'win32' }, () => {
    const path = temporaryFile('plant.yaml', GOOD.replace('plant:', '  token_file: token\nplant:'));
    writeFileSync(join(dirname(path), 'token'), 'hush-hush\n');
    chmodSync(join(dirname(path), 'token'), 0o644);

    const lines = wrongIn(path);

    assert.match(lines[0], /line 3: gateway\.token_file: .*every user of this machine may read the file/);
    assert.doesNotMatch(lines.join('\n'), /hush-hush/);
  });

  it('Check_TokenOverPlainNetwork_IsRefused', () => {
    const path = temporaryFile('plant.yaml', GOOD.replace('ws://127.0.0.1:47011', 'ws://gateway.example:47011'));

    const lines = wrongIn(path, { NOWPOSE_TOKEN: 'hush-hush' });

    assert.match(lines[0], /line 2: gateway\.url: .*wss:\/\//);
    assert.doesNotMatch(lines.join('\n'), /hush-hush/);
  });

  it('Check_ByteOrderMark_IsValid', () => {
    assert.deepEqual(wrongIn(temporaryFile('plant.yaml', `\uFEFF${GOOD}`)), []);
  });
});

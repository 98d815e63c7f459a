import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { chmodSync, writeFileSync } from 'node:fs';
import { open } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { wrongIn } from './checking.mjs';
import { messages } from './messages.mjs';
import { parts } from './parts.mjs';
import { check, startProcess } from './program.mjs';
import { temporaryFile, temporaryFolder } from './temporary.mjs';

const { KINDS, kinds, readConfiguration } = await parts('configuration/configuration', 'configuration/schemaCheck', 'kinds');
const { configurationMessages, fileMessages, opcuaSettingMessages, robotMessages } = messages;

const INCLUDED = ['ur3e', 'ur5', 'ur5e', 'ur10e', 'ur16e', 'youbot'];
const SECTIONS = ['gateway', 'plant', 'joints', 'frames', 'signals', 'robot', 'robots'];

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

/** Returns the errors in the valid file after one replacement. */
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

    const { status, out } = await check(t, path, { NOWPOSE_SUPERVISED: '1' }, startProcess);

    const [, content] = out.split('\n');
    assert.deepEqual([status, JSON.parse(content)], [0, { name: 'opcua', joints: ['arm_joint_1', 'arm_joint_2'], passes_unlisted: false, offers_clock: true, sole_connection_to: null, password_variable: null, has_objects: false, frames: {}, signals: [], robot: null, robots: {}, described_by: {}, warnings: [] }]);
  });

  it('Check_ParentInAnotherNode_PrintsAWarningAndSucceeds', async t => {
    const path = temporaryFile('plant.yaml', `${GOOD}frames:
  - frame: part
    parent: { of: [world, tool0], node: i=1 }
    position: { unit: m, x: { node: i=2 }, y: 0, z: 0 }
`);

    const alone = await check(t, path), supervised = await check(t, path, { NOWPOSE_SUPERVISED: '1' });

    const { warnings } = JSON.parse(supervised.out.split('\n')[1]);
    assert.deepEqual([alone.status, supervised.status, warnings.length], [0, 0, 1]);
    assert.deepEqual(alone.lines, [`warning: ${warnings[0]}`]);
  });

  for (const [name, from, to, expected] of [
    ['UnknownKind', 'kind: opcua', 'kind: opcau', `line 4: plant.kind: ${configurationMessages.notAllowed('opcau', 'opcua', KINDS)}`],
    ['KeyWithALineSeparator', 'plant:', '\u2028lant:', `line 3: \\u2028lant: ${configurationMessages.misspelt('plant')}`],
    ['NoKind', '  kind: opcua\n', '', `line 3: plant.kind: ${configurationMessages.noKind(KINDS)}`],
    ['NoPlant', /plant:\n.*\n.*\n/, '', `line 1: plant: ${configurationMessages.noKind(KINDS)}`],
    ['KindMisspelt', 'kind: opcua', 'kindx: opcua', `line 4: plant.kindx: ${configurationMessages.misspelt('kind')}`],
    ['PlantMisspelt', 'plant:', 'plantx:', `line 3: plantx: ${configurationMessages.misspelt('plant')}`],
    ['PlantEmpty', /plant:\n.*\n.*\n/, 'plant:\n', `line 3: plant: ${configurationMessages.noKind(KINDS)}`],
    ['PortTooLarge', 'plc.example:4840', 'plc.example:99999', `line 5: plant.endpoint: ${configurationMessages.address('opc.tcp://plc.example:99999')}`],
    ['PortOfZero', 'plc.example:4840', 'plc.example:0', `line 5: plant.endpoint: ${configurationMessages.address('opc.tcp://plc.example:0')}`],
    ['PortInWords', 'plc.example:4840', 'plc.example:abc', `line 5: plant.endpoint: ${configurationMessages.address('opc.tcp://plc.example:abc')}`],
    ['NoHost', 'plc.example:4840', ':4840', `line 5: plant.endpoint: ${configurationMessages.address('opc.tcp://:4840')}`],
    ['GatewayPortTooLarge', 'ws://127.0.0.1:47011', 'ws://127.0.0.1:470111', `line 2: gateway.url: ${configurationMessages.address('ws://127.0.0.1:470111')}`],
    ['NamespaceTooLarge', 'ns=4;i=1002', 'ns=65536;i=1002', `line 11: joints[1].node: ${opcuaSettingMessages.namespace('ns=65536;i=1002')}`],
    ['NodeNumberTooLarge', 'ns=4;i=1002', 'ns=4;i=4294967296', `line 11: joints[1].node: ${opcuaSettingMessages.numericId('ns=4;i=4294967296')}`],
    ['TimeNodeTooLarge', 'joints:', '  time: {node: ns=65536;s=t}\njoints:', `line 6: plant.time.node: ${opcuaSettingMessages.namespace('ns=65536;s=t')}`],
    ['UnknownKey', 'endpoint: opc', 'endpont: opc', `line 5: plant.endpont: ${configurationMessages.unknownEntry('endpoint', [])}`],
    ['UnknownSection', 'joints:', 'axes:', `line 6: axes: ${configurationMessages.unknownEntry(undefined, SECTIONS)}`],
    ['WrongEndpoint', 'opc.tcp://plc.example:4840', 'http://plc', 'line 5: plant.endpoint: value "http://plc"; '],
    ['PasswordInEndpoint', 'opc.tcp://plc', 'opc.tcp://me:word@plc', 'line 5: plant.endpoint: value "opc.tcp://***@plc.example:4840"; '],
    ['PasswordWithSlash', 'opc.tcp://plc', 'opc.tcp:/me:wo/rd@x@plc', 'line 5: plant.endpoint: value "opc.tcp:/***@plc'],
    ['UnknownUnit', 'unit: deg', 'unit: degrees', `line 9: joints[0].unit: ${configurationMessages.notAllowed('degrees', 'deg', ['rad', 'deg', 'm', 'mm'])}`],
    ['ScaleOfZero', 'scale: 0.5', 'scale: 0', 'line 12: joints[1].scale: value 0; '],
    ['ScaleInWords', 'scale: 0.5', 'scale: half', 'line 12: joints[1].scale: value "half"; '],
    ['OffsetNaN', 'offset: -1.5', 'offset: .nan', 'line 13: joints[1].offset: value .nan; '],
    ['OffsetInfinite', 'offset: -1.5', 'offset: -.inf', 'line 13: joints[1].offset: value -.inf; '],
    ['NoNode', '    node: ns=4;i=1002\n', '', 'line 10: joints[1].node: missing; '],
    ['WrongNode', 'ns=4;i=1002', 'MAIN.x', 'line 11: joints[1].node: value "MAIN.x"; '],
    ['JointTwice', 'arm_joint_2', 'arm_joint_1', `line 10: joints[1].joint: ${configurationMessages.nameTwice('arm_joint_1', 7, 'joint')}`],
    ['KeyTwice', 'unit: deg', 'unit: deg\n    unit: rad', `line 10: ${fileMessages.keyTwice}`],
    ['Tab', '  endpoint', '\tendpoint', `line 5: ${fileMessages.tab}`],
    ['CircularAlias', 'gateway:', '&all\ngateway: *all\nown:', `line 1: ${fileMessages.circular}`],
    ['NotYaml', 'unit: deg', 'unit: "deg', `line 14: ${fileMessages.notYaml('')}`],
    ['JointsNotAList', /joints:[^]*/, 'joints: {}\n', 'line 6: joints: value {}; '],
    ['GatewayUrlNotWebSocket', 'ws://127.0.0.1:47011', '127.0.0.1', 'line 2: gateway.url: value "127.0.0.1"; '],
    ['PinWithoutTls', 'plant:', `  pin: sha256/${'A'.repeat(43)}=\nplant:`, `line 3: gateway.pin: ${configurationMessages.pinWithoutTls}`],
    ['OpenFlagWithSecureMode', 'joints:', '  security: { i_know_this_is_open: true }\njoints:', `line 6: plant.security.i_know_this_is_open: ${opcuaSettingMessages.notOpen('sign_and_encrypt')}`],
    ['WrongPin', 'plant:', '  pin: sha256/abc\nplant:', 'line 3: gateway.pin: value "sha256/abc"; '],
    ['TokenInFile', 'plant:', '  token: hush-hush\nplant:', `line 3: gateway.token: ${configurationMessages.unknownEntry('token_file', [])}`],
    ['NoTokenFile', 'plant:', '  token_file: none\nplant:', `line 3: gateway.token_file: ${fileMessages.notReadable('none', 'ENOENT')}`],
    ['SilenceMisspelt', 'joints:', '  silence: rset\njoints:', 'line 6: plant.silence: value "rset"; '],
    ['SilenceWithoutTime', 'joints:', '  silence: {}\njoints:', 'line 6: plant.silence.fault_after_s: missing; '],
    ['SilenceTooShort', 'unit: deg', 'unit: deg\n    silence: {fault_after_s: 0.1}', 'line 10: joints[0].silence.fault_after_s: value 0.1; '],
    ['DecelerationOfZero', 'unit: deg', 'unit: deg\n    max_deceleration: 0', 'line 10: joints[0].max_deceleration: value 0; '],
    ['NoRobotFile', 'plant:', 'robot: none.urdf\nplant:', `line 3: robot: ${robotMessages.notReadable('none.urdf', 'ENOENT', INCLUDED)}`],
  ]) {
    it(`Check_${name}_NamesLineAndRemedy`, () => {
      const lines = linesOf(from, to);

      assert.equal(lines.filter(line => line.startsWith(expected)).length, 1, lines.join('\n'));
      assert.doesNotMatch(lines.join('\n'), /hush-hush|word@|wo\/rd/);
    });
  }

  it('Silence_OfAJoint_OverridesTheSilenceOfThePlant', () => {
    const joints = `joints:
  - { joint: a, node: i=1, unit: mm, silence: rest, max_deceleration: 2 }
  - { joint: b, node: i=2 }
`;
    const path = temporaryFile('plant.yaml', GOOD.replace(/joints:[^]*/, `  silence: {fault_after_s: 3}\n  max_deceleration: 15\n${joints}`));

    const read = readConfiguration(path, {}, kinds).joints.map(({ faultAfterMs, maxDeceleration, isLinear }) => [faultAfterMs, maxDeceleration, isLinear]);

    assert.deepEqual(read, [[null, 2, true], [3000, 15, false]]);
  });

  it('Silence_NotConfigured_MeansRestForSourcesOfChangesAndFaultForPeriodicSources', () => {
    const silenceOf = text => readConfiguration(temporaryFile('plant.yaml', text), {}, kinds).plant.silence;

    assert.equal(silenceOf(GOOD), 'rest');
    assert.deepEqual(silenceOf('plant:\n  kind: ros\n  endpoint: ws://127.0.0.1:9090\n'), { fault_after_s: 1 });
  });

  it('Check_TabInTheFile_ReportsOnlyTheTab', () => {
    const lines = linesOf('  endpoint', '\tendpoint');

    assert.deepEqual(lines, [`line 5: ${fileMessages.tab}`]);
  });

  it('Check_NoPlant_ReportsOtherUnknownEntries', () => {
    const lines = linesOf(/plant:\n.*\n.*\n/, 'endpont: plc\n');

    assert.deepEqual(lines, [
      `line 1: plant: ${configurationMessages.noKind(KINDS)}`, `line 3: endpont: ${configurationMessages.unknownEntry(undefined, SECTIONS)}`,
    ]);
  });

  it('Check_AllFormsOfAddresses_FindsNoError', () => {
    for (const address of ['plc', 'plc:1/path', '[fe80::1]', '[fe80::1%eth0]:4840', '[::1]:65535', '10.0.0.1:4840/a/b'])
      assert.deepEqual(wrongIn(temporaryFile('plant.yaml', GOOD.replace('plc.example:4840', address))), [], address);
  });

  it('Check_JointUnknownToTheRobot_NamesLineAndNearestName', () => {
    const path = temporaryFile('plant.yaml', `${GOOD.replace('joint: arm_joint_2', 'joint: arm_jiont_2')}robot: arm.urdf\n`);
    const joints = ['<joint type="revolute" name="arm_joint_1">', "<joint\n name = 'arm_joint_2'>", '<!-- <joint name="arm_jiont_2"/> -->'];
    writeFileSync(join(dirname(path), 'arm.urdf'), `<robot name="arm">${joints.join('</joint>')}</robot>`);

    const lines = wrongIn(path);

    assert.deepEqual(lines, [`${path}, line 10: joints[1].joint: ${robotMessages.noJoint('arm_jiont_2', 'arm_joint_2')}`]);
    writeFileSync(path, GOOD);
    assert.deepEqual(wrongIn(path), []);
  });

  it('Check_SeveralInvalidEntries_ReportsAllInOrder', () => {
    const lines = linesOf(/unit: deg[^]*/, 'unit: feet\n  - joint: ""\n    node: 3\n    offset: much\n  - {}\n');

    assert.deepEqual(lines.map(line => Number(/line (\d+)/.exec(line)[1])), [9, 10, 11, 12, 13, 13]);
  });

  it('Check_InvalidFile_ExitsWithStatus2', async t => {
    const path = temporaryFile('plant.yaml', GOOD.replace('unit: deg', 'unit: feet'));

    const { status, lines } = await check(t, path);

    assert.equal(status, 2);
    assert.deepEqual(lines, wrongIn(path));
  });

  it('Check_FileMissing_ReportsIt', async t => {
    const { status, lines } = await check(t, 'nowhere.yaml');

    assert.equal(status, 2);
    assert.equal(lines[0], `nowhere.yaml, line 1: ${fileMessages.configurationNotReadable('ENOENT')}`);
  });

  for (const [name, options] of [['Check', ['--check']], ['Run', []]])
    it(`${name}_SignalWhileTheFileIsRead_EndsTheProgram`, { skip: process.platform === 'win32' }, async t => {
      const path = join(temporaryFolder(), 'plant.yaml');
      execFileSync('mkfifo', [path]);
      const run = startProcess(t, [path, ...options]);
      // Opens when the program has opened the file for reading.
      const writer = await open(path, 'w');

      const status = await run.stop();

      await writer.close();
      assert.equal(status, 'SIGTERM');
    });

  it('Check_TokenFileReadableByAll_RefusesItWithoutShowingTheToken', { skip: process.platform === 'win32' }, () => {
    const path = temporaryFile('plant.yaml', GOOD.replace('plant:', '  token_file: token\nplant:'));
    writeFileSync(join(dirname(path), 'token'), 'hush-hush\n');
    chmodSync(join(dirname(path), 'token'), 0o644);

    const lines = wrongIn(path);

    assert.equal(lines[0], `${path}, line 3: gateway.token_file: ${fileMessages.readableByAll('token', join(dirname(path), 'token'))}`);
    assert.doesNotMatch(lines.join('\n'), /hush-hush/);
  });

  it('Check_TokenOverUnencryptedConnection_RefusesIt', () => {
    const path = temporaryFile('plant.yaml', GOOD.replace('ws://127.0.0.1:47011', 'ws://gateway.example:47011'));

    const lines = wrongIn(path, { NOWPOSE_TOKEN: 'hush-hush' });

    assert.equal(lines[0], `${path}, line 2: gateway.url: ${configurationMessages.tokenInClear('ws://gateway.example:47011')}`);
    assert.doesNotMatch(lines.join('\n'), /hush-hush/);
  });

  it('Check_FileWithByteOrderMark_FindsNoError', () => {
    assert.deepEqual(wrongIn(temporaryFile('plant.yaml', `\uFEFF${GOOD}`)), []);
  });

  it('Check_FileInUtf16_FindsNoErrorAndReadsItsSecrets', () => {
    const utf16 = text => Buffer.from(`\uFEFF${text}\r\n`, 'utf16le');
    const password = temporaryFile('password', utf16('Größe-4711'));
    const path = temporaryFile('plant.yaml', utf16(GOOD.replace('joints:', `  user: { name: cell, password_file: '${password}' }\njoints:`)));

    assert.deepEqual(readConfiguration(path, {}, kinds).secrets, ['Größe-4711']);
  });

  const withUser = (user, name = 'press-3') => temporaryFile('plant.yaml', GOOD.replace('plant:', `plant:\n  name: ${name}`)
    .replace('joints:', `  user: { name: cell${user} }\njoints:`));
  const FROM_FILE = `, password_file: '${temporaryFile('password', 'of-the-file')}'`;

  for (const [name, user, environment, password, variable] of [
    ['PasswordFile', FROM_FILE, { NOWPOSE_PLANT_PASSWORD_PRESS_3: 'of-the-plant' }, 'of-the-file', null],
    ['PasswordOfThePlant', '', { NOWPOSE_PLANT_PASSWORD_PRESS_3: 'of-the-plant', NOWPOSE_PLANT_PASSWORD: 'of-all-plants' }, 'of-the-plant', 'NOWPOSE_PLANT_PASSWORD_PRESS_3'],
    ['SharedPassword', ', shared_password: true', { NOWPOSE_PLANT_PASSWORD_PRESS_3: 'of-the-plant', NOWPOSE_PLANT_PASSWORD: 'of-all-plants' }, 'of-all-plants', null],
  ])
    it(`ReadConfiguration_${name}_IsUsed`, () => {
      const { secrets, passwordVariable } = readConfiguration(withUser(user), environment, kinds);

      assert.deepEqual([secrets, passwordVariable], [[password], variable]);
    });

  it('Check_PasswordOfAnotherPlant_IsNotUsedAndTheVariableIsNamed', () => {
    const others = { NOWPOSE_PLANT_PASSWORD: 'of-all-plants', NOWPOSE_PLANT_PASSWORD_PRESS_2: 'of-another-plant' };

    assert.throws(() => readConfiguration(withUser(''), others, kinds),
      ({ message }) => message.includes(configurationMessages.noPassword('NOWPOSE_PLANT_PASSWORD_PRESS_3', 'NOWPOSE_PLANT_PASSWORD')));
  });

  it('Check_PasswordFileAndSharedPassword_AreRefused', () =>
    assert.throws(() => readConfiguration(withUser(`${FROM_FILE}, shared_password: true`), {}, kinds), ({ message }) => message.includes(configurationMessages.twoPasswords)));
});

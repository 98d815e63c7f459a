import assert from 'node:assert/strict';
import { createPrivateKey } from 'node:crypto';
import { existsSync, readdirSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check, startProcess } from '../program.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { identity } from './identity.mjs';
import { adapterFor, configuration, OPEN } from './plant.mjs';
import { YoubotServer } from './server.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { certificateFileMessages, certificateMessages, configurationMessages, fileMessages, opcuaRefusalMessages, opcuaSettingMessages } = messages;

const JOINTS = [{ joint: 'a', node: 'ns=1;s=arm_joint_1' }];
const PASSWORD = 'correct-horse-battery', WITH_PASSWORD = { env: { NOWPOSE_PLANT_PASSWORD_CELL: PASSWORD } };

describe('security of OPC UA', () => {
  let server;
  before(async () => { server = await new YoubotServer({ security: ['sign_and_encrypt'], users: { nowpose: PASSWORD } }).start(); });
  after(() => server.stop());
  const trusted = () => `security: {thumbprint: ${server.own.thumbprint}}`;

  it('Server_UnknownCertificate_IsRefusedUntilTrusted', async t => {
    const { run, bridge, path, state } = await adapterFor(t, server, ['user: {name: nowpose}'], JOINTS, WITH_PASSWORD);
    const folder = join(dirname(path), 'opcua-certificates'), rejected = join(folder, 'rejected', `${server.own.thumbprint}.der`);

    const { reason } = await state(s => s.state === 'refused');

    assert.ok(reason.includes(server.own.thumbprint) && reason.includes(`move ${rejected} to ${join(folder, 'trusted')}`), reason);
    assert.equal(bridge.jointStates.length, 0);
    assert.equal(server.asked.get('CreateSessionRequest'), undefined);
    assert.deepEqual(readFileSync(rejected), Buffer.from(server.own.der));

    renameSync(rejected, join(folder, 'trusted', 'youbot.der'));
    const { security } = await state(s => s.state === 'connected');

    assert.equal(security, 'SignAndEncrypt Basic256Sha256');
    assert.doesNotMatch(run.err, new RegExp(PASSWORD));
  });

  it('AdapterKey_CreatedAtTheFirstStart_IsReadableOnlyByItsOwner', { skip: process.platform === 'win32' }, async t => {
    const { path, state, run } = await adapterFor(t, server, [trusted(), 'user: {name: nowpose}'], JOINTS, { ...WITH_PASSWORD, launch: startProcess });
    await state(s => s.state === 'connected');

    const own = join(dirname(path), 'opcua-certificates', 'own');

    assert.equal(statSync(join(own, 'nowpose-key.pem')).mode & 0o777, 0o600);
    assert.deepEqual(readdirSync(own).sort(), ['nowpose-key.pem', 'nowpose.der']);
    assert.equal(await run.stop(), 0);
  });

  for (const policy of ['Aes128_Sha256_RsaOaep', 'Aes256_Sha256_RsaPss']) {
    it(`Adapter_Policy${policy}_ConnectsWithIt`, async t => {
      const plant = [`security: {thumbprint: ${server.own.thumbprint}, policy: ${policy}}`, 'user: {name: nowpose}'];
      const { state } = await adapterFor(t, server, plant, JOINTS, WITH_PASSWORD);

      assert.equal((await state(s => s.state === 'connected')).security, `SignAndEncrypt ${policy}`);
    });
  }

  it('User_WithCertificate_LogsIn', async t => {
    const me = await identity('urn:me'), files = `{certificate: "${me.certificateFile}", key: "${me.privateKeyFile}"}`;
    const { state } = await adapterFor(t, server, [trusted(), `user: ${files}`], JOINTS);

    await state(s => s.state === 'connected' && Number(s.samples) > 0);
  });

  it('Password_Wrong_IsReportedWithoutThePassword', async t => {
    const wrong = { env: { NOWPOSE_PLANT_PASSWORD_CELL: 'wrong-horse' } };
    const { run, bridge, state } = await adapterFor(t, server, [trusted(), 'user: {name: nowpose}'], JOINTS, wrong);

    const { reason } = await state(s => s.state === 'refused');

    assert.equal(reason, opcuaRefusalMessages.user('nowpose'));
    assert.doesNotMatch(run.err + JSON.stringify(bridge.heard), /wrong-horse/);
  });

  it('User_RefusedAfterTheLogin_IsReportedAndConnectedSoonAfterTheRightIsGiven', async t => {
    const time = VirtualTime.ofProcess(t);
    server.denied = 'CreateSubscriptionResponse';
    t.after(() => { server.denied = null; });
    const { state } = await adapterFor(t, server, [trusted(), 'user: {name: nowpose}'], JOINTS, WITH_PASSWORD);

    const { reason } = await state(s => s.state === 'refused');

    assert.equal(reason, opcuaRefusalMessages.noRight('BadUserAccessDenied'));
    server.denied = null;
    const since = time.now;
    await state(s => s.state === 'connected');
    // After a refused password, it waits for 30 s.
    assert.ok(time.now - since < 10_000_000_000n, `${time.now - since} ns`);
  });

  it('Anonymous_NotAllowed_IsReported', async t => {
    const { state } = await adapterFor(t, server, [trusted()], JOINTS);

    const { reason } = await state(s => s.state === 'refused');

    assert.match(reason, /plant\.user/);
  });

  it('SecurityNone_ServerOffersOnlySecureEndpoints_IsRefused', async t => {
    const { state, bridge } = await adapterFor(t, server, OPEN, JOINTS);

    const { reason } = await state(s => s.state === 'refused');

    assert.equal(reason, opcuaRefusalMessages.noOpenEndpoint);
    assert.equal(bridge.jointStates.length, 0);
  });
});

describe('other servers', () => {
  it('Adapter_ServerWithoutSecurity_DoesNotConnect', async t => {
    const server = await new YoubotServer({ security: ['none'] }).start();
    t.after(() => server.stop());
    const { state } = await adapterFor(t, server, [], JOINTS);

    const { reason } = await state(s => s.state === 'refused');

    assert.equal(reason, opcuaRefusalMessages.noPolicy('Basic256Sha256'));
    assert.equal(server.asked.get('CreateSessionRequest'), undefined);
  });

  it('CertificateFolder_CannotBeCreated_IsReportedAndRetried', async t => {
    const server = await new YoubotServer({ security: ['none'] }).start();
    t.after(() => server.stop());
    const blocked = temporaryFile('blocked', ''), security = `security: {mode: none, i_know_this_is_open: true, folder: "${blocked}/certificates"}`;
    const { state, run } = await adapterFor(t, server, [security], JOINTS);

    const { reason } = await state(s => s.state === 'refused');
    rmSync(blocked);
    await state(s => s.state === 'connected');

    const expected = `certificates cannot be stored in ${blocked}/certificates (ENOTDIR); give this user write access, or set plant.security.folder`;
    assert.ok(reason.startsWith(expected), reason);
    assert.equal(run.status, undefined);
  });

  it('Adapter_NotTrustedByTheServer_ReportsItsThumbprint', async t => {
    const server = await new YoubotServer({ security: ['sign_and_encrypt'], trusted: [] }).start();
    t.after(() => server.stop());
    const { state, path } = await adapterFor(t, server, [`security: {thumbprint: ${server.own.thumbprint}}`], JOINTS);

    const { reason } = await state(s => s.state === 'refused');

    assert.match(reason, like(opcuaRefusalMessages.adapterNotTrusted(ANY, ANY, ANY)));
    assert.match(reason, /nowpose\.der, .*\b[0-9a-f]{40}\b/);
    assert.ok(existsSync(join(dirname(path), 'opcua-certificates', 'own', 'nowpose.der')));
  });

  it('ServerCertificate_TrustedButExpired_IsRefused', async t => {
    const own = await identity('urn:nowpose:youbot', { notBefore: new Date(Date.now() - 10 * 86_400_000), validity: 5 });
    const server = await new YoubotServer({ security: ['sign_and_encrypt'], own }).start();
    t.after(() => server.stop());
    const { state } = await adapterFor(t, server, [`security: {thumbprint: ${own.thumbprint}}`], JOINTS);

    const { reason } = await state(s => s.state === 'refused');

    assert.match(reason, like(certificateMessages.outOfDate(ANY, ANY, ANY)));
  });
});

describe('security in the configuration', () => {
  const file = (...plant) => temporaryFile('plant.yaml', configuration('ws://127.0.0.1:1', 'opc.tcp://plc:4840', plant, JOINTS));

  for (const [name, plant, expected] of [
    ['ModeNoneWithoutFlag', ['security:', '  mode: none'], `line 8: plant.security.mode: ${opcuaSettingMessages.open}`],
    ['FlagSetToFalse', ['security:', '  mode: none', '  i_know_this_is_open: false'], 'line 9: plant.security.i_know_this_is_open: '],
    ['WeakPolicy', ['security:', '  policy: Basic128Rsa15'], 'line 8: plant.security.policy: value "Basic128Rsa15"; '],
    ['WrongThumbprint', ['security:', '  thumbprint: 12 34'], 'line 8: plant.security.thumbprint: value "12 34"; '],
    ['PasswordInFile', ['user: {name: me, password: hush-hush}'], `line 7: plant.user.password: ${configurationMessages.unknownEntry('password_file', [])}`],
    ['PasswordOverOpenConnection', ['security: {mode: none, i_know_this_is_open: true}', 'user: {name: me}'], `line 8: plant.user: ${configurationMessages.passwordInClear('sign_and_encrypt')}`],
    ['NoPassword', ['user:', '  name: me'], `line 7: plant.user.password_file: ${configurationMessages.noPassword('NOWPOSE_PLANT_PASSWORD_CELL', 'NOWPOSE_PLANT_PASSWORD')}`],
    ['PasswordWithoutName', ['user:', '  password_file: none'], 'line 7: plant.user.name: missing, but password_file needs it; '],
    ['NoEntryOfTheUser', ['user: {}'], 'line 7: plant.user: value {}; '],
    ['CertificateWithoutKey', ['user: {certificate: plant.yaml}'], `line 7: plant.user.key: ${certificateFileMessages.noPart('key')}`],
    ['FlagWithoutModeNone', ['security:', '  i_know_this_is_open: true'], `line 8: plant.security.i_know_this_is_open: ${opcuaSettingMessages.notOpen('sign_and_encrypt')}`],
    ['NoServerCertificate', ['security:', '  server_certificate: none.der'], `line 8: plant.security.server_certificate: ${fileMessages.notReadable('none.der', 'ENOENT')}`],
    ['ServerCertificateNotACertificate', ['security:', '  server_certificate: plant.yaml'], `line 8: plant.security.server_certificate: ${certificateFileMessages.noCertificate('DER or PEM')}`],
    ['TimeWithoutNode', ['timestamp: variable'], `line 7: plant.timestamp: ${configurationMessages.noTimeVariable('node')}`],
    ['TimeNotUsed', ['timestamp: source', 'time: {node: i=2258}'], `line 8: plant.time: ${configurationMessages.unusedTime('source')}`],
    ['PublishingFasterThanSampling', ['sampling_ms: 20', 'publishing_ms: 10'], `line 8: plant.publishing_ms: ${configurationMessages.publishingTooShort(10, 20)}`],
  ]) {
    it(`Check_${name}_NamesLineAndRemedy`, () => {
      const lines = wrongIn(file(...plant));

      assert.ok(lines.join('\n').includes(`, ${expected}`), lines.join('\n'));
      assert.doesNotMatch(lines.join('\n'), /hush-hush/);
    });
  }

  it('Check_CertificateAndKeyOfAUser_AreReadAndCompared', async () => {
    const [me, other] = await Promise.all([identity('urn:me'), identity('urn:other')]);
    const none = temporaryFile('none', 'garbage'), closed = temporaryFile('closed.pem', createPrivateKey(me.pem).export({
      type: 'pkcs8', format: 'pem', cipher: 'aes-256-cbc', passphrase: 'hush-hush',
    }));
    const wrong = (certificate, key) => wrongIn(file('user:', `  certificate: "${certificate}"`, `  key: "${key}"`)).join('\n');

    assert.equal(wrong(me.certificateFile, me.privateKeyFile), '');
    for (const [certificate, key, expected] of [
      [none, me.privateKeyFile, `line 8: plant.user.certificate: ${certificateFileMessages.noCertificate('PEM')}`],
      [me.certificateFile, none, `line 9: plant.user.key: ${certificateFileMessages.noKey}`],
      [me.certificateFile, closed, `line 9: plant.user.key: ${certificateFileMessages.encryptedKey}`],
      [me.certificateFile, other.privateKeyFile, `line 9: plant.user.key: ${certificateFileMessages.otherKey}`],
    ])
      assert.ok(wrong(certificate, key).includes(expected), wrong(certificate, key));
  });

  it('Check_CertificateFolderCannotBeCreated_ReportsItsLineAndCreatesNothing', async t => {
    const blocked = file('security:', '  folder: plant.yaml'), good = file('security:', '  folder: a/b');

    const { status, lines } = await check(t, blocked);

    assert.equal(status, 2);
    assert.equal(lines[0], `${blocked}, line 8: plant.security.folder: ${certificateMessages.notStored(join(dirname(blocked), 'plant.yaml'), 'ENOTDIR')}`);
    assert.equal((await check(t, good)).status, 0);
    assert.deepEqual(readdirSync(dirname(good)), ['plant.yaml']);
  });

  // The system's folder for processes has the permissions for root, but accepts no files, like a folder with an access list on Windows.
  it('Check_CertificateFolderWithoutRoomDespiteItsPermissions_ReportsItsLine', { skip: process.platform !== 'linux' }, async t => {
    const { status, lines } = await check(t, file('security:', '  folder: /proc'));

    assert.equal(status, 2);
    assert.match(lines[0], /, line 8: plant\.security\.folder: /);
  });

  it('Check_PasswordFileReadableByAll_RefusesIt', { skip: process.platform === 'win32' }, () => {
    const path = file('user: {name: me, password_file: word}');
    writeFileSync(join(dirname(path), 'word'), 'hush-hush', { mode: 0o644 });

    const lines = wrongIn(path);

    assert.ok(lines[0].endsWith(`plant.user.password_file: ${fileMessages.readableByAll('word', join(dirname(path), 'word'))}`), lines[0]);
    assert.doesNotMatch(lines[0], /hush-hush/);
  });
});

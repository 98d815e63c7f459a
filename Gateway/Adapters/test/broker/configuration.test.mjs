import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check } from '../program.mjs';
import { temporaryFile } from '../temporary.mjs';
import { messages } from '../messages.mjs';

const { brokerSettingMessages, certificateFileMessages, configurationMessages } = messages;

describe('broker configuration', () => {
  const plant = more => `plant:\n  kind: broker\n  direction: subscribe\n  endpoint: mqtt://127.0.0.1\n  topic: nowpose/cell\n${more}`;
  for (const [name, text, expected] of [
    ['WithoutClock', plant(''), `line 1: plant.clock: ${brokerSettingMessages.noClock}`],
    ['ClockOfAPublisher', plant('  clock: { host: a }\n').replace('subscribe', 'publish'), `line 6: plant.clock: ${brokerSettingMessages.unusedClock}`],
    ['UnencryptedToAnotherMachine', plant('  clock: { host: a }\n').replace('127.0.0.1', '10.0.0.5'),
      `line 1: plant.plain: ${configurationMessages.notPlain('mqtt')}`],
    ['InvalidPort', plant('  clock: { host: a }\n').replace('127.0.0.1', '127.0.0.1:x'), `line 4: plant.endpoint: ${configurationMessages.address('mqtt://127.0.0.1:x')}`],
    ['InvalidTopic', plant('  clock: { host: a }\n').replace('nowpose/cell', 'nowpose/#'),
      'line 5: plant.topic: value "nowpose/#"; '],
    ['InvalidDirection', plant('').replace('subscribe', 'subscrib'), `line 3: plant.direction: ${configurationMessages.notAllowed('subscrib', 'subscribe', [])}`],
    ['PasswordInEndpoint', plant('').replace('mqtt://', 'mqtt://me:word@'), 'line 4: plant.endpoint: value "mqtt://***@127.0.0.1"; '],
    ['PasswordOverOpenConnection', plant('  clock: { host: a }\n  plain: true\n  user: { name: me, password_file: none }\n').replace('127.0.0.1', '10.0.0.5'),
      `line 8: plant.user: ${configurationMessages.passwordInClear('mqtts://')}`],
    ['CertificateOverOpenConnection', plant('  clock: { host: a }\n  user: { certificate: a.pem, key: b.pem }\n'), `line 7: plant.user.certificate: ${certificateFileMessages.withoutTls}`],
    ['KeyWithoutCertificate', plant('  clock: { host: a }\n  user: { key: b.pem }\n').replace('mqtt:', 'mqtts:'), `line 7: plant.user.certificate: ${certificateFileMessages.noPart('certificate')}`],
  ])
    it(`Check_${name}_NamesItsLine`, () => {
      const lines = wrongIn(temporaryFile('broker.yaml', text));

      assert.ok(lines.some(line => line.includes(`, ${expected}`)), lines.join('\n'));
      assert.doesNotMatch(lines.join('\n'), /me:word/);
    });

  it('Check_StartedByAGateway_DoesNotShowTheAddressInTheFile', async t => {
    const path = temporaryFile('broker.yaml', plant('  clock: { host: a }\n'));

    const { subscribing } = brokerSettingMessages;
    const alone = await check(t, path), supervised = await check(t, path, { NOWPOSE_SUPERVISED: '1' });

    assert.ok(alone.out.includes(subscribing('mqtt://127.0.0.1', 'nowpose/cell', 'gateway ws://127.0.0.1:47011', 'a:47010')), alone.out);
    assert.ok(supervised.out.includes(subscribing('mqtt://127.0.0.1', 'nowpose/cell', 'this gateway', 'a:47010')), supervised.out);
  });

  it('Check_TokenOverPlainConnection_IsRefused', async t => {
    const path = temporaryFile('broker.yaml', plant('  clock: { host: 10.0.0.5, token_file: token }\n'));
    writeFileSync(join(dirname(path), 'token'), 'word\n', { mode: 0o600 });

    const { status, lines } = await check(t, path);

    assert.equal(status, 2);
    assert.equal(lines[0], `${path}, line 6: plant.clock.token_file: ${brokerSettingMessages.tokenInClear}`);
  });
});

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check } from '../program.mjs';
import { temporaryFile } from '../temporary.mjs';

describe('broker configuration', () => {
  const plant = more => `plant:\n  kind: broker\n  direction: subscribe\n  endpoint: mqtt://127.0.0.1\n  topic: nowpose/cell\n${more}`;
  for (const [name, text, expected] of [
    ['NoClock', plant(''), /line 1: plant\.clock: missing; add host and sync port of the gateway/],
    ['ClockOfAPublisher', plant('  clock: { host: a }\n').replace('subscribe', 'publish'), /line 6: plant\.clock: not used with direction: publish/],
    ['PlainToAnother', plant('  clock: { host: a }\n').replace('127.0.0.1', '10.0.0.5'),
      /line 1: plant\.plain: missing; mqtt:\/\/ to another machine/],
    ['Port', plant('  clock: { host: a }\n').replace('127.0.0.1', '127.0.0.1:x'), /line 4: plant\.endpoint: .* a port from 1 to 65535/],
    ['Topic', plant('  clock: { host: a }\n').replace('nowpose/cell', 'nowpose/#'),
      /line 5: plant\.topic: value "nowpose\/#"; allowed: what the plant's topics begin with/],
    ['Direction', plant('').replace('subscribe', 'subscrib'), /line 3: plant\.direction: .*did you mean subscribe\?/],
    ['PasswordInEndpoint', plant('').replace('mqtt://', 'mqtt://me:word@'), /line 4: plant\.endpoint: .*without user name or password/],
    ['PasswordInTheOpen', plant('  clock: { host: a }\n  plain: true\n  user: { name: me, password_file: none }\n').replace('127.0.0.1', '10.0.0.5'),
      /line 8: plant\.user: the password would be sent unencrypted/],
  ])
    it(`Check_Invalid${name}_NamesItsLine`, () => {
      const lines = wrongIn(temporaryFile('broker.yaml', text));

      assert.ok(lines.some(line => expected.test(line)), lines.join('\n'));
      assert.doesNotMatch(lines.join('\n'), /me:word/);
    });

  it('Check_StartedByAGateway_DoesNotShowTheFilesAddress', async t => {
    const path = temporaryFile('broker.yaml', plant('  clock: { host: a }\n'));

    const alone = await check(t, path), supervised = await check(t, path, { NOWPOSE_SUPERVISED: '1' });

    assert.match(alone.out, /to gateway ws:\/\/127\.0\.0\.1:47011, time of a:47010/);
    assert.match(supervised.out, /to this gateway, time of a:47010/);
  });

  it('Check_TokenOverPlainConnection_IsRefused', async t => {
    const path = temporaryFile('broker.yaml', plant('  clock: { host: 10.0.0.5, token_file: token }\n'));
    writeFileSync(join(dirname(path), 'token'), 'word\n', { mode: 0o600 });

    const { status, lines } = await check(t, path);

    assert.equal(status, 2);
    assert.match(lines[0], /line 6: plant\.clock\.token_file: a token is sent only over TLS or within this machine/);
  });
});

// Configurations of an adapter for ADS.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check } from '../program.mjs';
import { temporaryFile } from '../temporary.mjs';
import { configuration } from './cell.mjs';

describe('ads configuration', () => {
  const good = configuration({ port: 48898, url: 'ws://127.0.0.1:47011' });

  it('Check_ValidFile_NamesEndpointAndJoints', async t => {
    const { status, out } = await check(t, temporaryFile('ads.yaml', good));

    assert.equal(status, 0);
    assert.match(out, /is valid: ADS ads:\/\/127\.0\.0\.1:48898\/5\.24\.12\.7\.1\.1:851, NO SECURITY; t_k is the stamp of ADS, sampled every 10 ms, published every 10 ms; joints arm_joint_1, /);
  });

  for (const [name, from, to, expected] of [
    ['NotPlain', '  plain: true\n', '', /^line 3: plant\.plain: missing; ADS is neither encrypted nor authenticated/],
    ['Endpoint', /ads:.*/, '192.168.0.20', /^line 6: plant\.endpoint: value "192\.168\.0\.20"; allowed: .*ads:\/\/HOST\/AMS NET ID:AMS PORT/],
    ['NetId', '5.24.12.7.1.1', '5.24.12.700.1.1', /^line 6: plant\.endpoint: .* parts of an AMS Net Id are 0 to 255/],
    ['LocalNetId', '192.168.0.10.1.1', '192.168.0.10', /^line 7: plant\.local_net_id: value "192\.168\.0\.10"; allowed: this machine's own AMS Net Id/],
    ['Timestamp', 'plain: true', 'plain: true\n  timestamp: notifications', /^line 9: plant\.timestamp: .*did you mean notification\?/],
    ['NoTime', 'plain: true', 'plain: true\n  timestamp: variable', /^line 9: plant\.timestamp: value "variable"; add time/],
    ['TimeUnused', 'plain: true', 'plain: true\n  timestamp: notification\n  time: { symbol: GVL.nTime }', /^line 10: plant\.time: timestamp is notification; remove time/],
    ['Publishing', 'plain: true', 'plain: true\n  sampling_ms: 20\n  publishing_ms: 10', /^line 10: plant\.publishing_ms: value 10; allowed: a time from sampling_ms, 20, to 10000 ms/],
    ['Symbol', 'symbol: GVL.aJoints[0]', 'symbol: GVL aJoints', /^line 11: joints\[0\]\.symbol: .*; allowed: the name of a variable/],
  ])
    it(`Check_Invalid${name}_NamesItsLine`, () => {
      const text = good.replace(from, to);
      assert.notEqual(text, good);
      const path = temporaryFile('ads.yaml', text), lines = wrongIn(path);

      assert.match(lines[0].replace(`${path}, `, ''), expected);
    });
});

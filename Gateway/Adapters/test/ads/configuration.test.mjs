// Tests how the adapter checks configurations for ADS.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { check } from '../program.mjs';
import { temporaryFile } from '../temporary.mjs';
import { configuration } from './cell.mjs';
import { parts } from '../parts.mjs';
import { like, messages } from '../messages.mjs';

const { ads, kinds, parseEndpoint, readConfiguration } = await parts('ads/endpoint', 'ads/kind', 'configuration/configuration', 'kinds');
const { adsSettingMessages, configurationMessages, summaryMessages } = messages;

describe('ads configuration', () => {
  const good = configuration({ port: 48898, url: 'ws://127.0.0.1:47011' });

  it('Check_ValidFile_NamesEndpointAndJoints', async t => {
    const { status, out } = await check(t, temporaryFile('ads.yaml', good));

    assert.equal(status, 0);
    const stamps = summaryMessages.stamps(summaryMessages.adsStamp, 10, 10);
    assert.match(out, like(`: ADS ads://127.0.0.1:48898/5.24.12.7.1.1:851, NO SECURITY; ${stamps}; joints arm_joint_1, `));
  });

  for (const [name, from, to, expected] of [
    ['WithoutPlain', '  plain: true\n', '', `line 3: plant.plain: ${adsSettingMessages.notPlain}`],
    ['InvalidEndpoint', /ads:.*/, '192.168.0.20', 'line 6: plant.endpoint: value "192.168.0.20"; '],
    ['InvalidNetId', '5.24.12.7.1.1', '5.24.12.700.1.1', `line 6: plant.endpoint: ${adsSettingMessages.endpoint('ads://127.0.0.1:48898/5.24.12.700.1.1:851')}`],
    ['InvalidLocalNetId', '192.168.0.10.1.1', '192.168.0.10', 'line 7: plant.local_net_id: value "192.168.0.10"; '],
    ['InvalidTimestamp', 'plain: true', 'plain: true\n  timestamp: notifications', `line 9: plant.timestamp: ${configurationMessages.notAllowed('notifications', 'notification', [])}`],
    ['TimestampVariableWithoutTime', 'plain: true', 'plain: true\n  timestamp: variable', `line 9: plant.timestamp: ${configurationMessages.noTimeVariable('symbol')}`],
    ['TimeNotUsed', 'plain: true', 'plain: true\n  timestamp: notification\n  time: { symbol: GVL.nTime }', `line 10: plant.time: ${configurationMessages.unusedTime('notification')}`],
    ['PublishingFasterThanSampling', 'plain: true', 'plain: true\n  sampling_ms: 20\n  publishing_ms: 10', `line 10: plant.publishing_ms: ${configurationMessages.publishingTooShort(10, 20)}`],
    ['InvalidSymbol', 'symbol: GVL.aJoints[0]', 'symbol: GVL aJoints', 'line 11: joints[0].symbol: value '],
  ])
    it(`Check_${name}_NamesItsLine`, () => {
      const text = good.replace(from, to);
      assert.notEqual(text, good);
      const path = temporaryFile('ads.yaml', text), lines = wrongIn(path);

      assert.ok(lines[0].startsWith(`${path}, ${expected}`), lines[0]);
    });

  for (const [count, expected] of [[500, []], [501, [adsSettingMessages.manyValues(501)]]])
    it(`Check_${count}Values_CausesAWarningAboveTheRecommendation`, () => {
      const joints = Array.from({ length: 256 }, (_, i) => `  - { joint: j${i}, symbol: "GVL.a[${i}]" }\n`).join('');
      const signals = Array.from({ length: count - 256 }, (_, i) => `  - { signal: s${i}, symbol: "GVL.b[${i}]" }\n`).join('');
      const text = `${configuration({ port: 48898, url: 'ws://127.0.0.1:47011', joints })}signals:\n${signals}`;

      const { warnings } = readConfiguration(temporaryFile('ads.yaml', text), {}, kinds);

      assert.deepEqual(warnings.map(line => line.replace(/^.*plant: /, '')), expected);
    });

  for (const [name, endpoint, local, expected] of [
    ['DefaultPort', 'ads://PLC-1/5.24.12.7.1.1:851', {}, 'plc-1'],
    ['ExplicitDefaultPort', 'ads://plc-1:48898/5.24.12.7.1.1:852', {}, 'plc-1'],
    ['OtherPortOfAForwardedAddress', 'ads://10.0.0.1:48899/5.24.12.7.1.1:851', {}, '10.0.0.1:48899'],
    ['LocalRouter', 'ads://127.0.0.1/5.24.12.7.1.1:851', null, null],
  ])
    it(`SoleConnection_${name}_IsThatOfTheRouter`, () =>
      assert.equal(ads.soleConnectionTo({ endpoint: parseEndpoint(endpoint), local }), expected));
});

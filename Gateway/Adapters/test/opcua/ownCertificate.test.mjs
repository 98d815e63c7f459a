// Tests the certificate with which an adapter identifies itself.
import assert from 'node:assert/strict';
import { createPrivateKey, generateKeyPairSync, X509Certificate } from 'node:crypto';
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { temporaryFolder } from '../temporary.mjs';

const { ownCertificate } = await parts('opcua/security/ownCertificate');

const files = folder => ({ certificate: join(folder, 'own', 'nowpose.der'), key: join(folder, 'own', 'nowpose-key.pem') });

function assertPair(folder) {
  const { certificate, key } = files(folder);
  assert.ok(new X509Certificate(readFileSync(certificate)).checkPrivateKey(createPrivateKey(readFileSync(key))));
  assert.deepEqual(readdirSync(join(folder, 'own')).sort(), ['nowpose-key.pem', 'nowpose.der']);
}

describe('own certificate', () => {
  it('Adapters_StartedTogetherInOneFolder_ShareOneCertificate', async () => {
    const folder = temporaryFolder();

    const all = await Promise.all(Array.from({ length: 6 }, () => ownCertificate(folder)));

    assertPair(folder);
    const stored = readFileSync(files(folder).certificate);
    for (const own of all) assert.deepEqual(own.getCertificate(), stored);
  });

  it('Adapter_StartedAgainWithTheSameFolder_KeepsItsCertificate', async () => {
    const folder = temporaryFolder(), first = await ownCertificate(folder);

    assert.deepEqual((await ownCertificate(folder)).getCertificate(), first.getCertificate());
  });

  it('Certificate_Missing_IsCreatedForTheKey', async () => {
    const folder = temporaryFolder();
    await ownCertificate(folder);
    rmSync(files(folder).certificate);

    await ownCertificate(folder);

    assertPair(folder);
  });

  it('Certificate_Created_IsValidForAServerWhoseClockIsDaysBehind', async () => {
    const own = await ownCertificate(temporaryFolder()), { validFrom, validTo } = new X509Certificate(own.getCertificate());

    const days = [validFrom, validTo].map(date => (new Date(date) - Date.now()) / 86_400_000);

    assert.ok(days[0] < -364 && days[1] > 3649, `${validFrom} to ${validTo}`);
  });

  for (const [name, harm] of [
    ['Key_Deleted', ({ key }) => rmSync(key)],
    ['Key_OfAnotherCertificate', ({ key }) => writeFileSync(key, generateKeyPairSync('rsa', { modulusLength: 2048 }).privateKey.export({ type: 'pkcs8', format: 'pem' }))],
    ['Certificate_Damaged', ({ certificate }) => writeFileSync(certificate, 'rubbish')],
  ])
    it(`${name}_IsReportedAndNothingIsDeleted`, async () => {
      const folder = temporaryFolder(), { certificate, key } = files(folder);
      await ownCertificate(folder);
      harm(files(folder));
      const stored = readFileSync(certificate);

      const named = error => [certificate, key, 'delete both'].every(part => error.message.includes(part));
      await assert.rejects(ownCertificate(folder), named);
      assert.deepEqual(readFileSync(certificate), stored);
    });
});

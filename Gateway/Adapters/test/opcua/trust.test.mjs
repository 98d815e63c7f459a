import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, it } from 'node:test';
import { OPCUAClient, StatusCodes } from './library.mjs';
import { parts } from '../parts.mjs';
import { temporaryFolder } from '../temporary.mjs';
import { identity } from './identity.mjs';
import { YoubotServer } from './server.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { certificateMessages, opcuaMessages } = messages;

const { TrustList, readsOnly } = await parts('opcua/security/trustList', 'opcua/readOnlySession');
const sha256 = der => createHash('sha256').update(der).digest('hex');

describe('trust list', () => {
  let server, other;
  before(async () => { [server, other] = [await identity('urn:server'), await identity('urn:other')]; });

  async function list(settings = {}, now) {
    const folder = temporaryFolder(), trust = new TrustList({ folder, thumbprint: null, serverCertificate: null, ...settings }, now);
    await trust.initialize();
    return { folder, trust };
  }

  it('Certificate_Unknown_IsRefusedAndStored', async () => {
    const { trust, folder } = await list();

    for (let i = 0; i < 2; i++) assert.equal(await trust.checkCertificate(server.der), StatusCodes.BadCertificateUntrusted);

    assert.ok(trust.refusal.includes(server.thumbprint) && trust.refusal.includes(sha256(server.der)), trust.refusal);
    assert.deepEqual(readdirSync(join(folder, 'rejected')), [`${server.thumbprint}.der`]);
    assert.deepEqual(readdirSync(join(folder, 'trusted')), []);
  });

  it('Certificates_TooManyRejected_DeletesTheOldest', async () => {
    const { trust, folder } = await list(), rejected = join(folder, 'rejected');
    for (let i = 0; i < 20; i++) {
      writeFileSync(join(rejected, `${i}.der`), '');
      utimesSync(join(rejected, `${i}.der`), 1000 + i, 1000 + i);
    }

    await trust.checkCertificate(server.der);

    const newest = [...Array(20).keys()].slice(-15).map(i => `${i}.der`);
    assert.deepEqual(readdirSync(rejected).sort(), [...newest, `${server.thumbprint}.der`].sort());
  });

  for (const [name, content] of [['Der', s => s.der], ['Pem', s => s.cert]]) {
    it(`Certificate_StoredInTheFolderAs${name}_IsTrusted`, async () => {
      const { trust, folder } = await list();
      writeFileSync(join(folder, 'trusted', 'broken.der'), 'no certificate');
      writeFileSync(join(folder, 'trusted', 'server'), content(server));

      assert.equal(await trust.checkCertificate(server.der), StatusCodes.Good);
      assert.equal(await trust.checkCertificate([server.der, other.der]), StatusCodes.Good);
      assert.equal(await trust.checkCertificate(other.der), StatusCodes.BadCertificateUntrusted);
      // A trusted issuer in the chain is not sufficient to trust a certificate.
      assert.equal(await trust.checkCertificate([other.der, server.der]), StatusCodes.BadCertificateUntrusted);
    });
  }

  it('Certificate_ThumbprintConfigured_IsTrusted', async () => {
    for (const settings of [{ thumbprint: server.thumbprint }, { thumbprint: sha256(server.der) }, { serverCertificate: server.certificateFile }]) {
      const { trust } = await list(settings);

      assert.equal(await trust.checkCertificate(server.der), StatusCodes.Good);
      assert.equal(await trust.checkCertificate(other.der), StatusCodes.BadCertificateUntrusted);
    }
  });

  it('Certificate_TrustedButExpired_IsRefused', async () => {
    for (const days of [-1, 366]) {
      const { trust } = await list({ thumbprint: server.thumbprint }, () => new Date(Date.now() + days * 86_400_000));

      assert.equal(await trust.checkCertificate(server.der), StatusCodes.BadCertificateTimeInvalid);
    }
  });

  it('Trust_RequestedByTheLibrary_HasNoEffect', async () => {
    const { trust } = await list();

    await trust.trustCertificate(server.der);

    assert.equal(await trust.checkCertificate(server.der), StatusCodes.BadCertificateUntrusted);
  });

  it('Refusal_FolderNotWritable_StillContainsTheThumbprint', async () => {
    const { trust, folder } = await list();
    mkdirSync(join(folder, 'rejected', `${server.thumbprint}.der`));

    await trust.checkCertificate(server.der);

    assert.match(trust.refusal, like(certificateMessages.addThumbprint(ANY)));
    assert.ok(existsSync(folder));
  });
});

describe('read only', () => {
  it('Request_Write_NeverReachesTheServer', async t => {
    const server = await new YoubotServer().start();
    t.after(() => server.stop());
    const own = await identity('urn:writer');
    const client = OPCUAClient.create({
      endpointMustExist: false, connectionStrategy: { maxRetry: 0 },
      certificateFile: own.certificateFile, privateKeyFile: own.privateKeyFile, clientCertificateManager: server.store,
    });
    await client.connect(server.endpoint);
    t.after(() => client.disconnect());
    const session = await client.createSession();
    client.on('send_request', readsOnly);

    assert.ok((await session.read({ nodeId: 'i=2258' })).statusCode.isGood());
    for (const name of ['WriteRequest', 'CallRequest', 'AddNodesRequest', 'DeleteNodesRequest', 'HistoryUpdateRequest'])
      assert.throws(() => readsOnly({ schema: { name } }), { message: opcuaMessages.notAllowed(name) });
    const reads = server.asked.get('ReadRequest');
    const value = { nodeId: 'ns=1;s=arm_joint_1', attributeId: 13, value: { value: { dataType: 'Double', value: 1 } } };
    assert.throws(() => session.write(value, () => {}), { message: opcuaMessages.notAllowed('WriteRequest') });

    // The server receives the requests of a session in their order, so it would have received the write request before this one.
    assert.ok((await session.read({ nodeId: 'i=2258' })).statusCode.isGood());
    assert.equal(server.asked.get('ReadRequest'), reads + 1);
    assert.equal(server.asked.get('WriteRequest'), undefined);
  });
});

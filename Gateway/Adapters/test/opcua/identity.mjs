import { createHash } from 'node:crypto';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { crypto_utils as pki } from './library.mjs';
import { temporaryFolder } from '../temporary.mjs';

/** Creates files with a key and its certificate in a temporary folder. */
export async function identity(uri, { notBefore = new Date(), validity = 365 } = {}) {
  const key = await pki.generatePrivateKey(2048);
  const { cert } = await pki.createSelfSignedCertificate({
    privateKey: key, subject: '/CN=youBot', applicationUri: uri, dns: ['localhost'], notBefore, validity,
    purpose: pki.CertificatePurpose.ForApplication,
  });
  const der = pki.convertPEMtoDER(cert), pem = (await pki.privateKeyToPEM(key)).privPem;
  const folder = temporaryFolder();
  const certificateFile = join(folder, 'certificate.pem'), privateKeyFile = join(folder, 'key.pem');
  writeFileSync(certificateFile, cert);
  writeFileSync(privateKeyFile, pem, { mode: 0o600 });
  return { der, cert, pem, folder, certificateFile, privateKeyFile, thumbprint: createHash('sha1').update(der).digest('hex') };
}

import { chmodSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import { crypto_utils as pki } from 'node-opcua-client';

const APPLICATION = 'Nowpose', DAYS = 10 * 365, KEY_BITS = 2048;

/** Name of this application in its certificate and in connections: servers compare the two. */
export const applicationUri = (): string => `urn:${hostname().toLowerCase()}:nowpose:gateway`;

export interface OwnCertificate {
  file: string;
  getCertificate(): Buffer;
  getCertificateChain(): Buffer[];
  getPrivateKey(): ReturnType<typeof pki.makePrivateKeyFromPem>;
}

/** Gets the certificate of this application; created the first time, with a key that only its owner can read. */
export async function ownCertificate(folder: string): Promise<OwnCertificate> {
  const own = join(folder, 'own');
  const file = join(own, 'nowpose.der'), keyFile = join(own, 'nowpose-key.pem');
  mkdirSync(own, { recursive: true, mode: 0o700 });
  if (!existsSync(file) || !existsSync(keyFile)) await make(file, keyFile);
  chmodSync(keyFile, 0o600);
  const certificate = readFileSync(file), key = pki.makePrivateKeyFromPem(readFileSync(keyFile, 'utf8'));
  return { file, getCertificate: () => certificate, getCertificateChain: () => [certificate], getPrivateKey: () => key };
}

async function make(file: string, keyFile: string): Promise<void> {
  const key = await pki.generatePrivateKey(KEY_BITS);
  const { cert } = await pki.createSelfSignedCertificate({
    privateKey: key,
    subject: `/CN=${APPLICATION}@${hostname()}/O=${APPLICATION}`,
    applicationUri: applicationUri(),
    dns: [hostname()],
    notBefore: new Date(),
    validity: DAYS,
    purpose: pki.CertificatePurpose.ForApplication,
  });
  const { privPem } = await pki.privateKeyToPEM(key);
  // Created with its mode, so that the key is never readable by others.
  writeFileSync(keyFile, privPem, { mode: 0o600 });
  writeFileSync(file, pki.convertPEMtoDER(cert));
}

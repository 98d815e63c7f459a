import { createPrivateKey, randomUUID, X509Certificate } from 'node:crypto';
import { chmodSync, existsSync, linkSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import { crypto_utils as pki } from 'node-opcua-client';
import { certificateMessages } from '../../messages/opcua';

const APPLICATION = 'Nowpose';
/** The certificate is valid from a year ago, because the clock of a PLC may be behind. */
const DAYS_BEFORE = 365;
const DAYS_AFTER = 10 * 365;
const DAY_MS = 86_400_000;
const KEY_BITS = 2048;

/** Gets the URI of this application. The certificate and each connection contain it, and servers compare the two. */
export const applicationUri = (): string => `urn:${hostname().toLowerCase()}:nowpose:gateway`;

export interface OwnCertificate {
  file: string;
  getCertificate(): Buffer;
  getCertificateChain(): Buffer[];
  getPrivateKey(): ReturnType<typeof pki.makePrivateKeyFromPem>;
}

/**
 * Gets the certificate of this application. If there is none, creates a certificate and a key that only its owner can read. If several adapters with
 * the same folder start at the same time, all of them use the key and certificate that are written first.
 * @throws Error The folder cannot be used, or its key and certificate do not belong together.
 */
export async function ownCertificate(folder: string): Promise<OwnCertificate> {
  const own = join(folder, 'own');
  const file = join(own, 'nowpose.der');
  const keyFile = join(own, 'nowpose-key.pem');
  mkdirSync(own, { recursive: true, mode: 0o700 });
  if (!existsSync(keyFile)) writeFirst(keyFile, (await pki.privateKeyToPEM(await pki.generatePrivateKey(KEY_BITS))).privPem);
  chmodSync(keyFile, 0o600);
  if (!existsSync(file)) writeFirst(file, await certify(keyFile));
  const { certificate, pem } = requirePair(file, keyFile);
  const key = pki.makePrivateKeyFromPem(pem);
  return { file, getCertificate: () => certificate, getCertificateChain: () => [certificate], getPrivateKey: () => key };
}

async function certify(keyFile: string): Promise<Buffer> {
  const { cert } = await pki.createSelfSignedCertificate({
    privateKey: await pki.pemToPrivateKey(readFileSync(keyFile, 'utf8')),
    subject: `/CN=${APPLICATION}@${hostname()}/O=${APPLICATION}`,
    applicationUri: applicationUri(),
    dns: [hostname()],
    notBefore: new Date(Date.now() - DAYS_BEFORE * DAY_MS),
    validity: DAYS_BEFORE + DAYS_AFTER,
    purpose: pki.CertificatePurpose.ForApplication,
  });
  return pki.convertPEMtoDER(cert);
}

function requirePair(file: string, keyFile: string): { certificate: Buffer; pem: string } {
  const certificate = readFileSync(file);
  const pem = readFileSync(keyFile, 'utf8');
  if (!fits(certificate, pem)) throw new Error(certificateMessages.otherKey(file, keyFile));
  return { certificate, pem };
}

function fits(certificate: Buffer, pem: string): boolean {
  try {
    return new X509Certificate(certificate).checkPrivateKey(createPrivateKey(pem));
  } catch {
    return false;
  }
}

/** Creates a file that only its owner can read, unless it exists. The file is complete as soon as it exists. */
function writeFirst(file: string, content: string | Buffer): void {
  const draft = `${file}.${randomUUID()}`;
  try {
    writeFileSync(draft, content, { mode: 0o600 });
    linkSync(draft, file);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'EEXIST') throw error;
  } finally {
    rmSync(draft, { force: true });
  }
}

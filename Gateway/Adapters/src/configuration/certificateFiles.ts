import { createPrivateKey, type KeyObject, X509Certificate } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { besides } from './besides';
import { secretText } from './secret';
import type { Path, YamlFile } from './yamlFile';
import { certificateFileMessages, fileMessages } from '../messages/configuration';

/** A certificate and its private key, both PEM. */
export interface CertificateAndKey {
  certificate: string;
  key: string;
}

/** Reports a file that is missing or contains no certificate, because no server could match it. */
export function requireCertificate(file: YamlFile, entry: Path, value: string): void {
  try {
    certificateIn(file, entry, readFileSync(besides(file.path, value)), 'DER or PEM');
  } catch (error) {
    file.report(entry, fileMessages.notReadable(value, (error as NodeJS.ErrnoException).code));
  }
}

/**
 * Gets the certificate and the key in the section plant.user; null if it has none. Reports a missing or invalid certificate or key, and a key that
 * does not belong to the certificate.
 */
export function userCertificateIn(file: YamlFile, user: { certificate?: string; key?: string } | undefined): CertificateAndKey | null {
  if (user?.certificate === undefined && user?.key === undefined) return null;
  const at = ['plant', 'user'] as const;
  for (const part of ['certificate', 'key'] as const) if (user[part] === undefined) file.report([...at, part], certificateFileMessages.noPart(part));
  const certificate = user.certificate && secretText(file, [...at, 'certificate'], user.certificate, false);
  const key = user.key && secretText(file, [...at, 'key'], user.key, true);
  if (!certificate || !key) return null;
  const found = certificateIn(file, [...at, 'certificate'], certificate, 'PEM');
  const secret = keyIn(file, [...at, 'key'], key);
  if (found !== null && secret !== null && !found.checkPrivateKey(secret)) file.report([...at, 'key'], certificateFileMessages.otherKey);
  return { certificate, key };
}

function certificateIn(file: YamlFile, entry: Path, content: string | Buffer, formats: string): X509Certificate | null {
  try {
    return new X509Certificate(content);
  } catch {
    file.report(entry, certificateFileMessages.noCertificate(formats));
    return null;
  }
}

function keyIn(file: YamlFile, entry: Path, text: string): KeyObject | null {
  try {
    return createPrivateKey(text);
  } catch {
    file.report(entry, /ENCRYPTED/.test(text) ? certificateFileMessages.encryptedKey : certificateFileMessages.noKey);
    return null;
  }
}

import { createPrivateKey, type KeyObject, X509Certificate } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { besides } from '../../configuration/besides';
import { shown } from '../../configuration/problem';
import type { Path, YamlFile } from '../../configuration/yamlFile';

/** Reports a file that is missing or has no certificate, because no server would match it. */
export function requireCertificate(file: YamlFile, entry: Path, value: string): void {
  try {
    certificateIn(file, entry, readFileSync(besides(file.path, value)));
  } catch (error) {
    file.report(entry, `value ${shown(value)}; the file cannot be read (${(error as NodeJS.ErrnoException).code}); name an existing file`);
  }
}

/** Reports an invalid certificate or key of a user, and a pair that does not match. */
export function requirePair(file: YamlFile, user: Path, { certificate, key }: { certificate: string; key: string }): void {
  const found = certificateIn(file, [...user, 'certificate'], certificate);
  const secret = keyIn(file, [...user, 'key'], key);
  if (found !== null && secret !== null && !found.checkPrivateKey(secret))
    file.report([...user, 'key'], 'it is not the key of plant.user.certificate; name a certificate and its key');
}

function certificateIn(file: YamlFile, entry: Path, content: string | Buffer): X509Certificate | null {
  try {
    return new X509Certificate(content);
  } catch {
    file.report(entry, 'the file contains no certificate; name one in DER or PEM (-----BEGIN CERTIFICATE-----)');
    return null;
  }
}

function keyIn(file: YamlFile, entry: Path, text: string): KeyObject | null {
  try {
    return createPrivateKey(text);
  } catch {
    file.report(
      entry,
      /ENCRYPTED/.test(text)
        ? 'the key is encrypted with a password, which cannot be entered at startup; name an unencrypted key'
        : 'the file contains no private key; name one in PEM (-----BEGIN PRIVATE KEY-----)',
    );
    return null;
  }
}

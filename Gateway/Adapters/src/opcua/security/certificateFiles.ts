import { createPrivateKey, type KeyObject, X509Certificate } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { besides } from '../../configuration/besides';
import type { Path, YamlFile } from '../../configuration/yamlFile';
import { fileMessages } from '../../messages/configuration';
import { opcuaSettingMessages } from '../../messages/opcua';

/** Reports a file that is missing or contains no certificate, because no server could match it. */
export function requireCertificate(file: YamlFile, entry: Path, value: string): void {
  try {
    certificateIn(file, entry, readFileSync(besides(file.path, value)));
  } catch (error) {
    file.report(entry, fileMessages.notReadable(value, (error as NodeJS.ErrnoException).code));
  }
}

/** Reports an invalid certificate or key of a user, and a key that does not belong to the certificate. */
export function requirePair(file: YamlFile, user: Path, { certificate, key }: { certificate: string; key: string }): void {
  const found = certificateIn(file, [...user, 'certificate'], certificate);
  const secret = keyIn(file, [...user, 'key'], key);
  if (found !== null && secret !== null && !found.checkPrivateKey(secret)) file.report([...user, 'key'], opcuaSettingMessages.otherKey);
}

function certificateIn(file: YamlFile, entry: Path, content: string | Buffer): X509Certificate | null {
  try {
    return new X509Certificate(content);
  } catch {
    file.report(entry, opcuaSettingMessages.noCertificate);
    return null;
  }
}

function keyIn(file: YamlFile, entry: Path, text: string): KeyObject | null {
  try {
    return createPrivateKey(text);
  } catch {
    file.report(entry, /ENCRYPTED/.test(text) ? opcuaSettingMessages.encryptedKey : opcuaSettingMessages.noKey);
    return null;
  }
}

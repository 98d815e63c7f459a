import { statSync } from 'node:fs';
import { besides } from './besides';
import { readText } from './textFile';
import type { Path, YamlFile } from './yamlFile';
import { fileMessages } from '../messages/configuration';

const MAX_LENGTH = 512;

/**
 * Gets the secret in a file, which must be a single line. Reports a file that cannot be read, that every user may access, or that does not contain a
 * single line, and returns null.
 */
export function secretIn(file: YamlFile, entry: Path, value: string): string | null {
  const text = secretText(file, entry, value, true)?.trim();
  if (text === undefined) return null;
  if (text.length > 0 && text.length <= MAX_LENGTH && !/[\r\n]/.test(text)) return text;
  file.report(entry, fileMessages.notOneLine(value, MAX_LENGTH));
  return null;
}

/** Gets the text of a configured file. Reports a file that cannot be read, or a secret that every user may access, and returns null. */
export function secretText(file: YamlFile, entry: Path, value: string, isSecret: boolean): string | null {
  const path = besides(file.path, value);
  try {
    const isOpen = isSecret && process.platform !== 'win32' && (statSync(path).mode & 0o007) !== 0;
    if (!isOpen) return readText(path);
    file.report(entry, fileMessages.readableByAll(value, path));
  } catch (error) {
    file.report(entry, fileMessages.notReadable(value, (error as NodeJS.ErrnoException).code));
  }
  return null;
}

import { readFileSync, statSync } from 'node:fs';
import { besides } from './besides';
import { shown } from './problem';
import type { Path, YamlFile } from './yamlFile';

const MAX_LENGTH = 512;

/** Gets the single line of a file; null, with a report, if it cannot be read or every user may read it. */
export function secretIn(file: YamlFile, entry: Path, value: string): string | null {
  const text = secretText(file, entry, value, true)?.trim();
  if (text === undefined) return null;
  if (text.length > 0 && text.length <= MAX_LENGTH && !/[\r\n]/.test(text)) return text;
  file.report(entry, `value ${shown(value)}; the file must contain exactly one line of 1 to ${MAX_LENGTH} characters`);
  return null;
}

/** Gets the text of a configured file; null, with a report, if it cannot be read or is a secret that every user may read. */
export function secretText(file: YamlFile, entry: Path, value: string, isSecret: boolean): string | null {
  const path = besides(file.path, value);
  try {
    const isOpen = isSecret && process.platform !== 'win32' && (statSync(path).mode & 0o007) !== 0;
    if (!isOpen) return readFileSync(path, 'utf8');
    file.report(entry, `value ${shown(value)}; every user of this machine may read the file; remove this right: chmod o= ${path}`);
  } catch (error) {
    file.report(entry, `value ${shown(value)}; the file cannot be read (${(error as NodeJS.ErrnoException).code}); name an existing file`);
  }
  return null;
}

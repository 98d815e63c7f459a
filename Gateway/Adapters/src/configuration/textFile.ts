import { readFileSync } from 'node:fs';

/**
 * Reads a text file in UTF-8, or in UTF-16 with a byte order mark, which Windows PowerShell writes with `>`. The text does not contain the mark.
 * @throws Error The file cannot be read.
 */
export function readText(path: string): string {
  const bytes = readFileSync(path);
  const isUtf16 = bytes[0] === 0xff && bytes[1] === 0xfe;
  return new TextDecoder(isUtf16 ? 'utf-16le' : 'utf-8').decode(bytes);
}

/** An error in a configuration, with its line. */
export interface Problem {
  line: number;
  text: string;
}

/** The error for an invalid configuration. It contains all invalid entries that one check of the file has found. */
export class ConfigurationError extends Error {
  constructor(
    readonly file: string,
    problems: Problem[],
  ) {
    const sorted = [...problems].sort((a, b) => a.line - b.line);
    super(sorted.map(p => `${file}, line ${p.line}: ${p.text}`).join('\n'));
  }
}

const MAX_VALUE = 80;

/** Matches the text before the host of an address, which may be a password even in an invalid address. */
const LOGIN = /(:\/+|\/\/).*@/s;

/** Formats a value as written in the file, but replaces a password with ***. */
export function shown(value: unknown): string {
  if (typeof value === 'number' && !Number.isFinite(value)) return Number.isNaN(value) ? '.nan' : value > 0 ? '.inf' : '-.inf';
  const text = (JSON.stringify(value, (_, v) => (typeof v === 'bigint' ? `${v}` : v)) ?? String(value)).replace(LOGIN, '$1***@');
  return text.length > MAX_VALUE ? `${text.slice(0, MAX_VALUE - 1)}…` : text;
}

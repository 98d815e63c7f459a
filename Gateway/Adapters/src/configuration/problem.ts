/** An error in a configuration, with its line. */
export interface Problem {
  line: number;
  text: string;
}

/** Contains every invalid entry of a file; nothing was started. */
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

/** The text before the host of an address may be a password, even if the rest is invalid. */
const LOGIN = /(:\/+|\/\/).*@/s;

/** Formats a value as in the file, without a password. */
export function shown(value: unknown): string {
  if (typeof value === 'number' && !Number.isFinite(value)) return Number.isNaN(value) ? '.nan' : value > 0 ? '.inf' : '-.inf';
  const text = (JSON.stringify(value, (_, v) => (typeof v === 'bigint' ? `${v}` : v)) ?? String(value)).replace(LOGIN, '$1***@');
  return text.length > MAX_VALUE ? `${text.slice(0, MAX_VALUE - 1)}…` : text;
}

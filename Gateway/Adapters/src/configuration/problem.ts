/** What is wrong with a configuration, and where. */
export interface Problem {
  line: number;
  text: string;
}

/** Every wrong entry of a file; nothing was started. */
export class ConfigurationError extends Error {
  constructor(readonly file: string, problems: Problem[]) {
    const sorted = [...problems].sort((a, b) => a.line - b.line);
    super(sorted.map(p => `${file}, line ${p.line}: ${p.text}`).join('\n'));
  }
}

const LONGEST_VALUE = 80;

/** What stands before the host of an address may be a password, whatever is wrong with the rest. */
const LOGIN = /(:\/+|\/\/).*@/s;

/** A value as a person would find it in the file, without a password. */
export function shown(value: unknown): string {
  if (typeof value === 'number' && !Number.isFinite(value)) return Number.isNaN(value) ? '.nan' : value > 0 ? '.inf' : '-.inf';
  const text = (JSON.stringify(value, (_, v) => typeof v === 'bigint' ? `${v}` : v) ?? String(value)).replace(LOGIN, '$1***@');
  return text.length > LONGEST_VALUE ? `${text.slice(0, LONGEST_VALUE - 1)}…` : text;
}

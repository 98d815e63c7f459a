/** An error in a configuration or a warning about it, with its line. */
export interface Problem {
  line: number;
  text: string;
}

/** The error for an invalid configuration. It contains the errors that one check finds. */
export class ConfigurationError extends Error {
  constructor(
    readonly file: string,
    problems: Problem[],
  ) {
    super(linesOf(file, problems).join('\n'));
  }
}

/** Formats errors or warnings as one line each, in the order of their lines in the file. */
export const linesOf = (file: string, problems: Problem[]): string[] =>
  [...problems].sort((a, b) => a.line - b.line).map(({ line, text }) => `${file}, line ${line}: ${text}`);

const MAX_VALUE = 80;

/** Matches the text before the host of an address, which may be a password even in an invalid address. */
const LOGIN = /(:\/+|\/\/).*@/s;

/** Formats a value as written in the file, but replaces a password with ***. */
export function shown(value: unknown): string {
  if (typeof value === 'number' && !Number.isFinite(value)) return Number.isNaN(value) ? '.nan' : value > 0 ? '.inf' : '-.inf';
  const text = (JSON.stringify(value, (_, v) => (typeof v === 'bigint' ? `${v}` : v)) ?? String(value)).replace(LOGIN, '$1***@');
  return text.length > MAX_VALUE ? `${text.slice(0, MAX_VALUE - 1)}…` : text;
}

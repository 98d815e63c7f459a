import { isMap, isNode, isScalar, isSeq, LineCounter, parseDocument, type Document, type Node, type Pair } from 'yaml';
import { ConfigurationError, type Problem } from './problem';
import { readText } from './textFile';
import { fileMessages } from '../messages/configuration';

export type Path = readonly (string | number)[];

/** Replaces invisible characters and line breaks with their codes. */
const visible = (key: string): string =>
  key.replace(/[\p{C}\p{Zl}\p{Zp}]/gu, character => `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`);

/** Formats a path as joints[2].node. */
export const pathText = (path: Path): string =>
  path.map((step, i) => (typeof step === 'number' ? `[${step}]` : (i > 0 ? '.' : '') + visible(step))).join('');

/** A parsed YAML file that stores the line of each entry, and collects the errors in its entries and the warnings about them. */
export class YamlFile {
  readonly value: unknown;
  readonly problems: Problem[] = [];
  readonly warnings: Problem[] = [];
  readonly #document: Document;
  readonly #lines: LineCounter;
  readonly #invalid = new Set<string>();

  /**
   * @param document A document without errors.
   * @throws ConfigurationError The aliases of the document are circular or too many.
   */
  constructor(
    readonly path: string,
    document: Document,
    lines: LineCounter,
  ) {
    this.#document = document;
    this.#lines = lines;
    try {
      this.value = document.toJS({ maxAliasCount: 100 });
      // JSON.stringify throws for a circular structure, which aliases can create.
      JSON.stringify(this.value);
    } catch (error) {
      const text = error instanceof TypeError ? fileMessages.circular : (error as Error).message;
      throw new ConfigurationError(path, [{ line: 1, text }]);
    }
  }

  /**
   * Reads and parses a file.
   * @throws ConfigurationError The file cannot be read, or is not valid YAML.
   */
  static read(path: string): YamlFile {
    const text = read(path);
    const lines = new LineCounter();
    const document = parseDocument(text, {
      lineCounter: lines,
      prettyErrors: false,
      uniqueKeys: true,
      logLevel: 'error',
      // No entry needs a tag such as !!binary, whose value would be an object. Every tag is then a warning.
      resolveKnownTags: false,
    });
    // Reports only the first error, because later errors are often its consequences and have wrong lines.
    const [error] = [...document.errors].sort((a, b) => a.pos[0] - b.pos[0]);
    if (error !== undefined)
      throw new ConfigurationError(path, [{ line: lines.linePos(error.pos[0]).line, text: inWords(error.code, error.message) }]);
    const tags = document.warnings.filter(warning => warning.code === 'TAG_RESOLVE_FAILED');
    if (tags.length > 0)
      throw new ConfigurationError(
        path,
        tags.map(({ pos }) => ({ line: lines.linePos(pos[0]).line, text: fileMessages.tag(text.slice(...pos)) })),
      );
    return new YamlFile(path, document, lines);
  }

  /** Adds an error in an entry, unless the entry is marked as invalid. The error of a missing entry has the line of its parent. */
  report(path: Path, text: string): void {
    if (!this.isInvalid(path)) this.problems.push(this.#at(path, text));
  }

  /** Marks an entry whose value is not known, because it has a reported error. Further errors in it would be consequences. */
  markInvalid(path: Path): void {
    this.#invalid.add(JSON.stringify(path));
  }

  /** Whether the value of an entry is not known. Checks of other entries that depend on this value are not possible. */
  isInvalid(path: Path): boolean {
    return this.#invalid.has(JSON.stringify(path));
  }

  /** Whether the file contains an entry, so that its value is not a default. */
  has(path: Path): boolean {
    return this.#document.hasIn(path);
  }

  /** Adds a warning about an entry that is valid. */
  warn(path: Path, text: string): void {
    this.warnings.push(this.#at(path, text));
  }

  /** @throws ConfigurationError At least one error was reported. */
  throwIfWrong(): void {
    if (this.problems.length > 0) throw new ConfigurationError(this.path, this.problems);
  }

  #at(path: Path, text: string): Problem {
    return { line: this.lineOf(path), text: path.length > 0 ? `${pathText(path)}: ${text}` : text };
  }

  /** Gets the line of an entry's key, counted from 1; for a missing entry, the line of its nearest existing parent. */
  lineOf(path: Path): number {
    let node: unknown = this.#document.contents;
    let offset = isNode(node) ? (node.range?.[0] ?? 0) : 0;
    for (const step of path) {
      const next = child(node, step);
      if (next === undefined) break;
      offset = next.offset;
      node = next.node;
    }
    return this.#lines.linePos(offset).line;
  }
}

function read(path: string): string {
  try {
    return readText(path);
  } catch (error) {
    throw new ConfigurationError(path, [{ line: 1, text: fileMessages.configurationNotReadable((error as NodeJS.ErrnoException).code) }]);
  }
}

function child(node: unknown, step: string | number): { node: unknown; offset: number } | undefined {
  if (isSeq(node)) {
    const item = node.items[Number(step)] as Node | undefined;
    return item && { node: item, offset: item.range?.[0] ?? 0 };
  }
  const pair = isMap(node) ? node.items.find((p: Pair) => (isScalar(p.key) ? String(p.key.value) : '') === String(step)) : undefined;
  return pair && { node: pair.value, offset: (pair.key as Node).range?.[0] ?? 0 };
}

function inWords(code: string, message: string): string {
  switch (code) {
    case 'TAB_AS_INDENT':
      return fileMessages.tab;
    case 'DUPLICATE_KEY':
      return fileMessages.keyTwice;
    case 'BAD_INDENT':
      return fileMessages.indent(message);
    default:
      return fileMessages.notYaml(message);
  }
}

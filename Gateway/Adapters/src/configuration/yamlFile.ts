import { readFileSync } from 'node:fs';
import { isMap, isNode, isScalar, isSeq, LineCounter, parseDocument, type Document, type Node, type Pair } from 'yaml';
import { ConfigurationError, type Problem } from './problem';

export type Path = readonly (string | number)[];

/** joints[2].node */
export const pathText = (path: Path): string =>
  path.map((step, i) => typeof step === 'number' ? `[${step}]` : (i > 0 ? '.' : '') + step).join('');

/** A YAML file that knows the line of each of its entries. */
export class YamlFile {
  readonly value: unknown;
  readonly problems: Problem[] = [];
  readonly #lines = new LineCounter();
  readonly #document: Document;

  /** @throws ConfigurationError It cannot be read, or is no YAML: then nothing else can be said about it. */
  constructor(readonly path: string) {
    this.#document = parseDocument(read(path), { lineCounter: this.#lines, prettyErrors: false, uniqueKeys: true, logLevel: 'error' });
    // What follows the first is often its consequence, and blames lines that are right.
    const [error] = [...this.#document.errors].sort((a, b) => a.pos[0] - b.pos[0]);
    if (error !== undefined)
      throw new ConfigurationError(path, [{ line: this.#lines.linePos(error.pos[0]).line, text: inWords(error.code, error.message) }]);
    try {
      this.value = this.#document.toJS({ maxAliasCount: 100 });
      // Throws where there is no end to it.
      JSON.stringify(this.value);
    } catch (error) {
      const text = error instanceof TypeError ? 'an alias (*) stands inside of what it names; write the entry out' : (error as Error).message;
      throw new ConfigurationError(path, [{ line: 1, text }]);
    }
  }

  /** Notes what is wrong with an entry; one that is not there is told at the entry that should have it. */
  report(path: Path, text: string): void {
    this.problems.push({ line: this.lineOf(path), text: path.length > 0 ? `${pathText(path)}: ${text}` : text });
  }

  /** @throws ConfigurationError Something was reported. */
  throwIfWrong(): void {
    if (this.problems.length > 0) throw new ConfigurationError(this.path, this.problems);
  }

  /** Where an entry starts, counted from 1: its key, or the nearest one above it. */
  lineOf(path: Path): number {
    let node: unknown = this.#document.contents, offset = isNode(node) ? node.range?.[0] ?? 0 : 0;
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
    return readFileSync(path, 'utf8').replace(/^\uFEFF/, '');
  } catch (error) {
    throw new ConfigurationError(path, [{ line: 1, text: `cannot be read (${(error as NodeJS.ErrnoException).code}); name an existing file` }]);
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
    case 'TAB_AS_INDENT': return 'a tab stands before the entry; YAML allows blanks only, replace it';
    case 'DUPLICATE_KEY': return 'this key stands here for the second time; keep one of the two';
    case 'BAD_INDENT': return `${message}; entries of one level start in the same column`;
    default: return `no YAML: ${message}`;
  }
}

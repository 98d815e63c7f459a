// Finds exports that no other file uses. Such an export is either dead or does not need the keyword.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const EXPORT = /^export (?:abstract |async )?(?:class|const|enum|function|interface|let|type) (\w+)/gm;
const WORD = /[A-Za-z_$][\w$]*/g;
const OWN = ['Web', 'Vision', 'Gateway/Adapters'];
const NOT_OWN = ['node_modules', 'dist', 'bin', 'obj'];

/**
 * Gets the exports of TypeScript files that do not occur in any other file.
 * @param files The contents of all files that may use an export, by their paths.
 * @returns Strings "PATH: NAME".
 */
export function unusedExports(files) {
  const users = new Map();
  for (const [path, text] of Object.entries(files))
    for (const word of new Set(text.match(WORD))) users.set(word, [...(users.get(word) ?? []), path]);
  return Object.entries(files).flatMap(([path, text]) =>
    path.endsWith('.ts') ? [...text.matchAll(EXPORT)].filter(([, name]) => users.get(name).length === 1).map(([, name]) => `${path}: ${name}`) : []);
}

/** Reads the sources, tests and scripts of a product. */
export function filesOf(folder) {
  const files = {};
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory() && !NOT_OWN.includes(entry.name)) Object.assign(files, filesOf(path));
    else if (/\.(ts|mjs)$/.test(entry.name)) files[path] = readFileSync(path, 'utf8');
  }
  return files;
}

/** The exports of all products that no other file of the same product uses. */
export const unused = () => OWN.flatMap(product => unusedExports(filesOf(fileURLToPath(new URL(`../../${product}`, import.meta.url)))));

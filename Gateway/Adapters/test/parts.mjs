// Single parts of the program, for tests that need no process.
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { loading } from '../loading.mjs';
import { adapters } from './program.mjs';

// What is imported by one path once is what that path stands for.
let made = 0;

/** What the named modules below src export. */
export async function parts(...modules) {
  const contents = modules.map(module => `export * from './src/${module}';`).join('\n');
  const { outputFiles } = await build({
    ...loading, stdin: { contents, resolveDir: adapters }, bundle: true, write: false, packages: 'external', platform: 'node', format: 'esm',
    target: 'node20',
  });
  // Below the project, where packages are found.
  const folder = join(adapters, 'dist'), path = join(folder, `parts-${process.pid}-${++made}.mjs`);
  mkdirSync(folder, { recursive: true });
  try {
    writeFileSync(path, outputFiles[0].text);
    return await import(pathToFileURL(path).href);
  } finally {
    rmSync(path);
  }
}

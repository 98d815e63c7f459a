// Loads individual modules of the program for tests that need no process.
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { loading } from '../loading.mjs';
import { libraryFile } from './opcua/libraryFile.mjs';
import { adapters } from './program.mjs';

// Node caches modules by path, so each bundle needs a new path.
let made = 0;

const withLibraryFile = {
  name: 'with-library-file',
  setup: ({ onResolve }) => onResolve({ filter: /^node-opcua-client$/ }, async () => ({ path: await libraryFile(), external: true })),
};

/** Returns the exports of the given modules in the folder src. */
export async function parts(...modules) {
  const contents = modules.map(module => `export * from './src/${module}';`).join('\n');
  const { outputFiles } = await build({
    ...loading, plugins: [...loading.plugins, withLibraryFile], stdin: { contents, resolveDir: adapters }, bundle: true, write: false, packages: 'external', platform: 'node', format: 'esm',
    target: 'node20',
  });
  // The file is inside the project, so that its imports find the installed packages.
  const folder = join(adapters, 'dist'), path = join(folder, `parts-${process.pid}-${++made}.mjs`);
  mkdirSync(folder, { recursive: true });
  try {
    writeFileSync(path, outputFiles[0].text);
    return await import(pathToFileURL(path).href);
  } finally {
    rmSync(path);
  }
}

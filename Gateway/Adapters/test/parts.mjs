// Loads individual modules of the program for tests that need no process.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { libraryFile } from './opcua/libraryFile.mjs';

const adapters = join(dirname(fileURLToPath(import.meta.url)), '..'), dist = join(adapters, 'dist');

/** Files from which the modules are built, besides those in `src`. */
const INPUTS = ['package-lock.json', 'loading.mjs', 'plant.schema.json', 'test/parts.mjs', 'test/opcua/libraryFile.mjs'];

const withLibraryFile = {
  name: 'with-library-file',
  setup: ({ onResolve }) => onResolve({ filter: /^node-opcua-(client|debug)$/ }, async () => ({ path: await libraryFile(), external: true })),
};

/**
 * Builds one file per module, and shared files with the code that several modules use. The files of the kinds of plant are beside them, where the
 * program looks for them.
 */
async function build(modules) {
  const [esbuild, { kinds, loading, requireForBundle }] = await Promise.all([import('esbuild'), import('../loading.mjs')]);
  const entryPoints = [...modules.map(path => [path.slice(0, -3), `src/${path}`]), ...kinds.map(kind => [kind, `src/${kind}/adapter.ts`])];
  const { outputFiles } = await esbuild.build({
    ...loading, plugins: [...loading.plugins, withLibraryFile], absWorkingDir: adapters, entryPoints: Object.fromEntries(entryPoints), outdir: 'dist',
    outExtension: { '.js': '.mjs' }, bundle: true, splitting: true, write: false, platform: 'node', format: 'esm', target: 'node20',
    external: ['bufferutil', 'utf-8-validate'], banner: { js: requireForBundle },
  });
  return outputFiles.map(({ path, text }) => ({ path: path.slice(dist.length + 1), text }));
}

/** Returns the folder with the built modules. It is created once for each state of the sources; folders of other states are deleted. */
async function built() {
  const sources = readdirSync(join(adapters, 'src'), { recursive: true }).filter(path => /\.(ts|json)$/.test(path)).sort();
  const hash = createHash('sha256');
  for (const file of [...sources.map(path => join('src', path)), ...INPUTS]) hash.update(file).update(readFileSync(join(adapters, file)));
  const name = `parts-${hash.digest('hex').slice(0, 16)}`, folder = join(dist, name);
  if (existsSync(folder)) return folder;
  const modules = sources.filter(path => path !== 'main.ts' && /(?<!\.d)\.ts$/.test(path));
  const draft = `${folder}.${process.pid}.tmp`;
  for (const { path, text } of await build(modules)) {
    mkdirSync(dirname(join(draft, path)), { recursive: true });
    writeFileSync(join(draft, path), text);
  }
  const outdated = readdirSync(dist).filter(other => /^parts-[0-9a-f]+$/.test(other) && other !== name);
  for (const other of outdated) rmSync(join(dist, other), { recursive: true, force: true });
  try {
    renameSync(draft, folder);
  } catch {
    // Another test file that runs at the same time has built the same folder.
    rmSync(draft, { recursive: true });
  }
  return folder;
}

const folder = await built();

/** Returns the exports of the given modules in the folder src. */
export async function parts(...modules) {
  return Object.assign({}, ...await Promise.all(modules.map(module => import(pathToFileURL(join(folder, `${module}.mjs`)).href))));
}

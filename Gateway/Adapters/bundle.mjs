// Builds the adapters in dist: plant.mjs, one file per kind of plant, the schema of the configuration, and the licences of the bundled packages. Also
// generates plantFiles.d.ts, the types of the configuration for the sources.
// `npm run build` and prepare.mjs run this file.
import { mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { compile } from 'json-schema-to-typescript';
import { kinds, loading, requireForBundle, schema, withoutTrial } from './loading.mjs';

const adapters = dirname(fileURLToPath(import.meta.url));
const entries = { plant: 'src/main.ts', ...Object.fromEntries(kinds.map(kind => [kind, `src/${kind}/adapter.ts`])) };

// Writes a temporary file and renames it, so that a concurrent build does not read an incomplete file.
function write(name, text) {
  const unfinished = join(adapters, 'dist', `${name}.${process.pid}.tmp`);
  writeFileSync(unfinished, text);
  renameSync(unfinished, join(adapters, 'dist', name));
}

/** Gets the package folders below node_modules that the bundle uses. */
function packagesIn(inputs) {
  const folders = Object.keys(inputs).map(path => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1]);
  return [...new Set(folders)].filter(folder => folder !== undefined).sort();
}

/** Licences of packages that state their licence in the README and the sources, but not in package.json. */
const STATED = { precond: 'MIT' };

/** Gets the licence text of a package. For a package without a licence file, the folder licences contains the text. */
function licenceOf(folder) {
  const { name, version, license = STATED[name] } = JSON.parse(readFileSync(join(adapters, folder, 'package.json'), 'utf8'));
  if (license === undefined) throw new Error(`${name} ${version} states no licence in package.json; find out its licence and add it to STATED in bundle.mjs`);
  const file = readdirSync(join(adapters, folder)).find(entry => /^(licen[cs]e|copying)/i.test(entry));
  const text = readFileSync(file ? join(adapters, folder, file) : join(adapters, 'licences', `${name}.txt`), 'utf8');
  return `${name} ${version}, ${license}\n\n${text.trim()}\n`;
}

/** Gets the schema of the file of each kind, by kind. An entry with a default is required, because the check of a file sets the default. */
function filesSchema() {
  const { $defs } = JSON.parse(JSON.stringify(schema), (_, part) => {
    if (part.properties === undefined) return part;
    const withDefault = Object.keys(part.properties).filter(name => part.properties[name].default !== undefined);
    return { ...part, required: [...(part.required ?? []), ...withDefault] };
  });
  return { type: 'object', required: kinds, properties: Object.fromEntries(kinds.map(kind => [kind, $defs[kind]])), $defs };
}

const { outputFiles, metafile } = await build({
  absWorkingDir: adapters,
  entryPoints: entries,
  outdir: 'dist',
  outExtension: { '.js': '.mjs' },
  write: false,
  metafile: true,
  bundle: true,
  minifyWhitespace: true,
  legalComments: 'none',
  plugins: [withoutTrial, ...loading.plugins],
  loader: loading.loader,
  define: loading.define,
  platform: 'node',
  format: 'esm',
  target: 'node20',
  charset: 'utf8',
  // Optional packages that the bundled packages load only in configurations that the adapters do not use.
  external: ['proper-lockfile', 'bufferutil', 'utf-8-validate'],
  banner: { js: `// Contains packages by others; see adapter-licences.txt.\n${requireForBundle}` },
});

mkdirSync(join(adapters, 'dist'), { recursive: true });
write('adapter-licences.txt', packagesIn(metafile.inputs).map(licenceOf).join('\n\n'));
write('plant.schema.json', `${JSON.stringify(schema, null, 2)}\n`);
write('plantFiles.d.ts', await compile(filesSchema(), 'PlantFiles', { additionalProperties: false, format: false, ignoreMinAndMaxItems: true }));
for (const file of outputFiles) write(file.path.slice(join(adapters, 'dist').length + 1), file.text);

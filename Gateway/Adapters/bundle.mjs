// Builds dist/plant.mjs, a file for each kind of plant beside it, the schema of their configuration and the licences of the bundled packages.
// `npm run build` and prepare.mjs run it.
import { mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { kinds, loading } from './loading.mjs';

const adapters = dirname(fileURLToPath(import.meta.url));
const entries = { plant: 'src/main.ts', ...Object.fromEntries(kinds.map(kind => [kind, `src/${kind}/adapter.ts`])) };

// At each start, node-opcua generates a 4096-bit key, which takes a second, to test a padding that none of our security policies uses.
const withoutTrial = {
  name: 'without-trial',
  setup: ({ onLoad }) => onLoad({ filter: /node-opcua-secure-channel.*verify_pcks1\.js$/ }, () => ({
    contents: 'export async function testRSAPKCS1V15_EncryptDecrypt() {}',
  })),
};

// Renamed into place, so that a concurrent build never reads an incomplete file.
function write(name, text) {
  const unfinished = join(adapters, 'dist', `${name}.${process.pid}.tmp`);
  writeFileSync(unfinished, text);
  renameSync(unfinished, join(adapters, 'dist', name));
}

/** Gets the folders below node_modules from which something was bundled. */
function packagesIn(inputs) {
  const folders = Object.keys(inputs).map(path => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1]);
  return [...new Set(folders)].filter(folder => folder !== undefined).sort();
}

/** Licences that a package states in its README and in each of its files, but not where npm looks for it. */
const STATED = { precond: 'MIT' };

/** Gets a package's licence. For a package without a licence file, the folder licences has the text of its README or sources. */
function licenceOf(folder) {
  const { name, version, license = STATED[name] } = JSON.parse(readFileSync(join(adapters, folder, 'package.json'), 'utf8'));
  if (license === undefined) throw new Error(`${name} ${version} states no licence; find out which it has, and say so in bundle.mjs`);
  const file = readdirSync(join(adapters, folder)).find(entry => /^(licen[cs]e|copying)/i.test(entry));
  const text = readFileSync(file ? join(adapters, folder, file) : join(adapters, 'licences', `${name}.txt`), 'utf8');
  return `${name} ${version}, ${license}\n\n${text.trim()}\n`;
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
  // Loaded only by a package that is configured to use it for locks, which ours is not.
  external: ['proper-lockfile', 'bufferutil', 'utf-8-validate'],
  // CommonJS packages load Node's modules with require.
  banner: {
    js: `// Contains packages by others; see adapter-licences.txt.
import { createRequire } from 'node:module';
import { dirname as nowposeDirname } from 'node:path';
import { fileURLToPath as nowposePath } from 'node:url';
const require = createRequire(import.meta.url), __filename = nowposePath(import.meta.url), __dirname = nowposeDirname(__filename);`,
  },
});

mkdirSync(join(adapters, 'dist'), { recursive: true });
write('adapter-licences.txt', packagesIn(metafile.inputs).map(licenceOf).join('\n\n'));
write('plant.schema.json', readFileSync(join(adapters, 'plant.schema.json'), 'utf8'));
for (const file of outputFiles) write(file.path.slice(join(adapters, 'dist').length + 1), file.text);

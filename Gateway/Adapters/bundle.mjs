// Makes dist/plant.mjs, a file for each kind of plant beside it, the schema of their configuration and the licences of what is in them.
// `npm run build` and prepare.mjs call it.
import { mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { kinds, loading } from './loading.mjs';

const adapters = dirname(fileURLToPath(import.meta.url));
const entries = { plant: 'src/main.ts', ...Object.fromEntries(kinds.map(kind => [kind, `src/${kind}/adapter.ts`])) };

// At each start node-opcua makes a key of 4096 bits, a second's work, to try a padding that none of our security policies uses.
const withoutTrial = {
  name: 'without-trial',
  setup: ({ onLoad }) => onLoad({ filter: /node-opcua-secure-channel.*verify_pcks1\.js$/ }, () => ({
    contents: 'export async function testRSAPKCS1V15_EncryptDecrypt() {}',
  })),
};

// Renamed into place: a build that reads the file meanwhile sees the old one or the new one, never half of one.
function write(name, text) {
  const unfinished = join(adapters, 'dist', `${name}.${process.pid}.tmp`);
  writeFileSync(unfinished, text);
  renameSync(unfinished, join(adapters, 'dist', name));
}

/** The folders below node_modules out of which something was bundled. */
function packagesIn(inputs) {
  const folders = Object.keys(inputs).map(path => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1]);
  return [...new Set(folders)].filter(folder => folder !== undefined).sort();
}

/** Stated in its README and in each of its files, but not where npm looks for it. */
const STATED = { precond: 'MIT' };

/** What a package without a licence file says in its README or in its sources lies in the folder licences. */
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
  platform: 'node',
  format: 'esm',
  target: 'node20',
  charset: 'utf8',
  // Loaded only where a package that keeps locks is told to keep them by it, which it is not.
  external: ['proper-lockfile', 'bufferutil', 'utf-8-validate'],
  // CommonJS packages ask for Node's modules as CommonJS does.
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

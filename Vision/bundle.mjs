// Builds dist/worker.mjs, a single file with OpenCV and the codecs, and the licences of the bundled packages.
// Run by `npm run build` and by prepare.mjs.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const vision = dirname(fileURLToPath(import.meta.url));
const licences = {
  'OpenCV, @techstark/opencv-js': '@techstark/opencv-js/LICENSE',
  'jSquash JPEG': '@jsquash/jpeg/LICENSE',
  'MozJPEG, as jSquash has it': '@jsquash/jpeg/codec/LICENSE.codec.md',
  pngjs: 'pngjs/LICENSE',
};

// Renames the complete file, so that a concurrent build never reads an incomplete one.
function write(name, text) {
  const unfinished = join(vision, 'dist', `${name}.${process.pid}.tmp`);
  writeFileSync(unfinished, text);
  renameSync(unfinished, join(vision, 'dist', name));
}

const { outputFiles } = await build({
  absWorkingDir: vision,
  entryPoints: ['src/main.ts'],
  write: false,
  bundle: true,
  platform: 'node',
  format: 'esm',
  target: 'node18',
  charset: 'utf8',
  loader: { '.wasm': 'binary' },
  // OpenCV's script loads Node's modules with require, as in CommonJS.
  banner: {
    js: `// Contains OpenCV, MozJPEG and pngjs; see worker-licences.txt.
import { createRequire } from 'node:module';
import { dirname as nowposeDirname } from 'node:path';
import { fileURLToPath as nowposePath } from 'node:url';
const require = createRequire(import.meta.url), __filename = nowposePath(import.meta.url), __dirname = nowposeDirname(__filename);`,
  },
});

mkdirSync(join(vision, 'dist'), { recursive: true });
write('worker-licences.txt', Object.entries(licences)
  .map(([name, path]) => `${name}\n\n${readFileSync(join(vision, 'node_modules', path), 'utf8')}`).join('\n\n'));
write('worker.mjs', outputFiles[0].text);

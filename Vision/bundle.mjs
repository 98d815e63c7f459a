// Builds dist/worker.mjs with OpenCV and the codecs, dist/opencv.wasm, and the licences of the bundled packages.
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
function write(name, content) {
  const unfinished = join(vision, 'dist', `${name}.${process.pid}.tmp`);
  writeFileSync(unfinished, content);
  renameSync(unfinished, join(vision, 'dist', name));
}

let openCvBinary;

/**
 * Moves the WebAssembly binary out of OpenCV's script, which contains it as 10 MB of text, to a file. A worker then starts with a fifth less
 * processor time. The script reads the file with Node's fs module, because fetch cannot read files.
 */
const separateBinary = {
  name: 'separate-binary',
  setup: ({ onLoad }) => onLoad({ filter: /opencv-js[\\/]dist[\\/]opencv\.js$/ }, ({ path }) => {
    const script = readFileSync(path, 'utf8');
    const [text, base64] = /"data:application\/octet-stream;base64,([A-Za-z0-9+/=]+)"/.exec(script);
    openCvBinary = Buffer.from(base64, 'base64');
    return { contents: script.replace(text, '"opencv.wasm"; wasmBinary = require("node:fs").readFileSync(__dirname + "/opencv.wasm")'), loader: 'js' };
  }),
};

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
  plugins: [separateBinary],
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
write('opencv.wasm', openCvBinary);
write('worker.mjs', outputFiles[0].text);

// Makes dist/report.html: one page with its script and style inside. `npm run build` and prepare.mjs call it.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const web = dirname(fileURLToPath(import.meta.url));
const read = path => readFileSync(join(web, path), 'utf8');

const { outputFiles } = await build({
  absWorkingDir: web,
  entryPoints: ['src/main.ts'],
  outdir: 'dist',
  write: false,
  bundle: true,
  minify: true,
  target: 'es2020',
  format: 'iife',
  charset: 'utf8',
});
const output = suffix => outputFiles.find(f => f.path.endsWith(suffix)).text;

// The licence of what is copied into the page goes with it.
const parts = {
  '<!--LICENCE-->': `<!-- Contains uPlot.\n${read('node_modules/uplot/LICENSE').replaceAll('--', '- -')}-->`,
  '/*STYLE*/': output('.css').replaceAll('</style', '<\\/style'),
  '/*SCRIPT*/': output('.js').replaceAll('</script', '<\\/script'),
};
let page = read('src/report.html');
for (const [mark, text] of Object.entries(parts)) {
  if (!page.includes(mark)) throw new Error(`src/report.html has no ${mark}`);
  page = page.replace(mark, () => text);
}

// Renamed into place: a build that reads the page meanwhile sees the old one or the new one, never half of one.
mkdirSync(join(web, 'dist'), { recursive: true });
const unfinished = join(web, 'dist', `report.${process.pid}.tmp`);
writeFileSync(unfinished, page);
renameSync(unfinished, join(web, 'dist', 'report.html'));

// Makes dist/report.html, figures.html, calibration.html, vlc.html and pairing.html: each one page with its script and style inside. `npm run build` and prepare.mjs call it.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const web = dirname(fileURLToPath(import.meta.url));
const read = path => readFileSync(join(web, path), 'utf8');

const pages = { report: 'src/main.ts', figures: 'src/paper/main.ts', calibration: 'src/calibration/main.ts', vlc: 'src/vlc/main.ts', pairing: 'src/pairing/main.ts' };
const withPlots = 'src/page.html';
const templates = { report: withPlots, figures: withPlots, calibration: withPlots, vlc: 'src/vlc/vlc.html', pairing: 'src/pairing/pairing.html' };

// qrcode-generator says who made it in its source and that it is MIT; the words of that licence are those of our own.
const mit = read('../LICENSE').replace(/^[^]*?(?=Permission is hereby granted)/, '');
const maker = /Copyright \(c\) [^\r\n]*/.exec(read('node_modules/qrcode-generator/dist/qrcode.mjs'))[0];

const { outputFiles } = await build({
  absWorkingDir: web,
  entryPoints: Object.entries(pages).map(([out, entry]) => ({ in: entry, out })),
  outdir: 'dist',
  write: false,
  bundle: true,
  minify: true,
  target: 'es2020',
  format: 'iife',
  charset: 'utf8',
});
const output = name => outputFiles.find(f => f.path.endsWith(name)).text;

mkdirSync(join(web, 'dist'), { recursive: true });
for (const [name, template] of Object.entries(templates)) {
  const parts = {
    ...(template === withPlots ? {
      // The licence of what is copied into the page goes with it.
      '<!--LICENCE-->': `<!-- Contains uPlot.\n${read('node_modules/uplot/LICENSE').replaceAll('--', '- -')}-->`,
      '<!--NAME-->': name,
    } : {}),
    ...(name === 'pairing' ? { '<!--LICENCE-->': `<!-- Contains qrcode-generator.\n${maker}\n\n${mit}-->` } : {}),
    '/*STYLE*/': output(`${name}.css`).replaceAll('</style', '<\\/style'),
    '/*SCRIPT*/': output(`${name}.js`).replaceAll('</script', '<\\/script'),
  };
  let page = read(template);
  for (const [mark, text] of Object.entries(parts)) {
    if (!page.includes(mark)) throw new Error(`${template} has no ${mark}`);
    page = page.replace(mark, () => text);
  }

  // Renamed into place: a build that reads the page meanwhile sees the old one or the new one, never half of one.
  const unfinished = join(web, 'dist', `${name}.${process.pid}.tmp`);
  writeFileSync(unfinished, page);
  renameSync(unfinished, join(web, 'dist', `${name}.html`));
}

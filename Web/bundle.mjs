// Builds report.html, figures.html, calibration.html, vlc.html, pairing.html and operations.html in dist. Each contains its script and style.
// Run by `npm run build` and by prepare.mjs.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createHash } from 'node:crypto';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const web = dirname(fileURLToPath(import.meta.url));
const read = path => readFileSync(join(web, path), 'utf8');

const pages = { report: 'src/main.ts', figures: 'src/figures/main.ts', calibration: 'src/calibration/main.ts', vlc: 'src/vlc/main.ts', pairing: 'src/pairing/main.ts', operations: 'src/operations/main.ts' };
const withPlots = 'src/page.html';
const templates = { report: withPlots, figures: withPlots, calibration: withPlots, vlc: 'src/vlc/vlc.html', pairing: 'src/pairing/pairing.html', operations: 'src/operations/operations.html' };

// Each page contains the licences of the code that it includes.
// qrcode-generator names its author and the MIT licence only in its source. The text of the MIT licence is taken from Nowpose's own licence.
const mit = read('../LICENSE').replace(/^[^]*?(?=Permission is hereby granted)/, '');
const maker = /Copyright \(c\) [^\r\n]*/.exec(read('node_modules/qrcode-generator/dist/qrcode.mjs'))[0];

const readme = read('node_modules/urdf-loader/README.md');
const licences = {
  uPlot: read('node_modules/uplot/LICENSE'),
  'qrcode-generator': `${maker}\n\n${mit}`,
  'three.js': read('node_modules/three/LICENSE'),
  // urdf-loader contains only a notice. playwright-core has the same licence, so the text of the licence is taken from there.
  'urdf-loader': `${readme.slice(readme.indexOf('Copyright ©')).trim()}\n\n${read('node_modules/playwright-core/LICENSE').replace(/(?<=END OF TERMS AND CONDITIONS)[^]*/, '')}`,
};
const plots = ['uPlot'], robots = ['three.js', 'urdf-loader'];
const contents = {
  report: [...plots, ...robots], figures: plots, calibration: plots, vlc: [], pairing: ['qrcode-generator'],
  operations: [...plots, ...robots, 'qrcode-generator'],
};

// Excludes the mesh loaders, because a page cannot load meshes.
const noMeshes = {
  name: 'no-meshes',
  setup(build) {
    build.onResolve({ filter: /^three\/examples\/jsm\/loaders\// }, ({ path }) => ({ path, namespace: 'no-meshes' }));
    build.onLoad({ filter: /.*/, namespace: 'no-meshes' }, () => ({ contents: 'export class STLLoader {}\nexport class ColladaLoader {}' }));
  },
};

// uPlot 1.6.32 creates a number format for navigator.language, which throws an exception if the browser reports an invalid language, such as "C".
const anyLanguage = {
  name: 'any-language',
  setup(build) {
    build.onLoad({ filter: /uPlot\.esm\.js$/ }, ({ path }) => {
      const script = readFileSync(path, 'utf8'), contents = script.replace(/(?<=new Intl\.NumberFormat\()[^)]*nav\.language[^)]*/, '');
      if (contents === script) throw new Error('uPlot no longer uses navigator.language; remove the plugin any-language');
      return { contents };
    });
  },
};

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
  legalComments: 'none',
  plugins: [noMeshes, anyLanguage],
});
const licenceText = names => names.map(name => `<!-- Contains ${name}.\n${licences[name].replaceAll('--', '- -')}\n-->`).join('\n');
// The content security policy of a page allows only the script and the style that were bundled with it.
const hash = text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const output = name => outputFiles.find(f => f.path.endsWith(name)).text;

mkdirSync(join(web, 'dist'), { recursive: true });
for (const [name, template] of Object.entries(templates)) {
  const style = output(`${name}.css`).replaceAll('</style', '<\\/style'), script = output(`${name}.js`).replaceAll('</script', '<\\/script');
  const parts = {
    ...(template === withPlots ? { '<!--NAME-->': name } : {}),
    ...(contents[name].length > 0 ? { '<!--LICENCE-->': licenceText(contents[name]) } : {}),
    STYLE_HASH: hash(style),
    SCRIPT_HASH: hash(script),
    '/*STYLE*/': style,
    '/*SCRIPT*/': script,
  };
  let page = read(template);
  for (const [mark, text] of Object.entries(parts)) {
    if (!page.includes(mark)) throw new Error(`${template} has no ${mark}`);
    page = page.replace(mark, () => text);
  }

  // Renames the complete file, so that a concurrent build never reads an incomplete one.
  const unfinished = join(web, 'dist', `${name}.${process.pid}.tmp`);
  writeFileSync(unfinished, page);
  renameSync(unfinished, join(web, 'dist', `${name}.html`));
}

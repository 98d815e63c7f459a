// Opens pages in Chromium from files and records all errors.
import { accessSync, constants, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { pathToFileURL } from 'node:url';

// An import would take 0.2 s longer in each file, because Node.js analyses a CommonJS package that is imported.
const { chromium } = createRequire(import.meta.url)('playwright-core');

// Flags with which the processor renders WebGL, for machines without a graphics card. With these flags, plots are drawn more slowly and with lower
// quality.
export const WEBGL = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-accelerated-2d-canvas'];
export const NO_WEBGL = ['--disable-gpu', '--disable-3d-apis'];

const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync'];
// Prefers the headless shell, because the full browser starts window processes for each page although no window is visible.
const NAMES = ['chromium-headless-shell', 'chromium', 'chromium-browser', 'google-chrome', 'chrome'];
const read = name => readFileSync(new URL(`../dist/${name}.html`, import.meta.url), 'utf8');

function executable() {
  const candidates = [process.env.CHROMIUM, ...(process.env.PATH ?? '').split(delimiter)
    .flatMap(folder => NAMES.map(name => join(folder, name)))].filter(Boolean);
  const found = candidates.find(path => {
    try {
      accessSync(path, constants.X_OK);
      return existsSync(path);
    } catch {
      return false;
    }
  });
  if (!found) throw new Error('no Chromium on PATH; install it or name it in the environment variable CHROMIUM');
  return found;
}

/** Inserts the data into a page, as ReportPage.Render and FiguresPage.Render do. */
export function render(data, name = 'report') {
  return read(name).replace('__REPORT_DATA__', () => JSON.stringify(data).replaceAll('<', '\\u003c'));
}

export class Browser {
  /**
   * @param name Name of the page: report or figures.
   * @param graphics WEBGL, NO_WEBGL, or the default for a page that draws only plots.
   */
  static async start(name = 'report', graphics = ['--disable-gpu']) {
    const self = new Browser();
    self.name = name;
    self.folder = mkdtempSync(join(tmpdir(), 'nowpose-web-'));
    self.browser = await chromium.launch({ executablePath: executable(), args: [...FLAGS, ...graphics] });
    return self;
  }

  async stop() {
    await this.browser.close();
    rmSync(this.folder, { recursive: true, force: true });
  }

  /**
   * Opens a page. Its `complaints` are exceptions, dialogs, console messages other than logs, and requests other than those for the page itself and
   * for data URLs.
   */
  async open(data, { fragment = '', name = this.name, ...options } = {}) {
    const file = join(this.folder, `${Math.random().toString(36).slice(2)}.html`);
    writeFileSync(file, render(data, name));
    const address = pathToFileURL(file).href + fragment;
    const context = await this.browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
    const page = await context.newPage();
    page.complaints = [];
    page.on('console', m => m.type() !== 'log' && page.complaints.push(`console ${m.type()}: ${m.text()}`));
    page.on('pageerror', e => page.complaints.push(`exception: ${e.message}`));
    page.on('request', r => r.url() !== address.replace(/#.*/, '') && !r.url().startsWith('data:') && page.complaints.push(`request: ${r.url()}`));
    page.on('dialog', d => { page.complaints.push(`dialog: ${d.message()}`); return d.dismiss(); });
    await page.goto(address);
    await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    return page;
  }
}

// Opens pages in Chromium from files and records all errors.
import { accessSync, constants, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { fakeWebGl } from './fakeWebGl.mjs';

// An import would take 0.2 s longer in each file, because Node.js analyses a CommonJS package that is imported.
const { chromium } = createRequire(import.meta.url)('playwright-core');

// Flags with which the processor renders WebGL, for machines without a graphics card. The page around a canvas is drawn without it, which is faster.
export const WEBGL = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-accelerated-2d-canvas',
  '--disable-gpu-compositing'];
export const NO_WEBGL = ['--disable-gpu', '--disable-3d-apis'];

// With a single renderer process per context, a page uses the scripts that the process has compiled for earlier pages.
const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--renderer-process-limit=1'];
const POLLING_MS = 50;
// Chromium warns of the time in which it copies a picture of WebGL into the page.
const COPY_WARNING = /GL Driver Message .*ReadPixels/;
const VIEWPORT = { width: 1280, height: 800 };
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

/** Inserts the data into a page, as Pages.Report.Render and Pages.Figures.Render do. */
export function render(data, name = 'report') {
  return read(name).replace('__REPORT_DATA__', () => JSON.stringify(data).replaceAll('<', '\\u003c'));
}

/** Records exceptions and console messages other than logs in `page.complaints`. */
export function recordErrors(page) {
  page.complaints = [];
  page.on('console', m => m.type() !== 'log' && !COPY_WARNING.test(m.text()) && page.complaints.push(`console ${m.type()}: ${m.text()}`));
  page.on('pageerror', e => page.complaints.push(`exception: ${e.message}`));
}

export class Browser {
  /** @param graphics WEBGL or NO_WEBGL. */
  static async start(graphics = NO_WEBGL) {
    const self = new Browser();
    self.folder = mkdtempSync(join(tmpdir(), 'nowpose-web-'));
    self.browser = await chromium.launch({ executablePath: executable(), args: [...FLAGS, ...graphics] });
    self.contexts = new Map();
    return self;
  }

  async stop() {
    await this.browser.close();
    rmSync(this.folder, { recursive: true, force: true });
  }

  /**
   * Writes a page to a file and returns its address. Pages of one name have the same address, because Chromium compiles a script once per address.
   */
  write(html, name) {
    const file = join(this.folder, `${name}.html`);
    writeFileSync(file, html);
    return pathToFileURL(file).href;
  }

  /**
   * Creates an empty page in a context that all pages of a site share. The renderer process of the context runs until the browser is stopped.
   * @param site Address of a document of the site that needs no script.
   * @param options Size of the window, colour scheme and reduced motion. With `hasVirtualTime`, the page has its own context, and `page.clock` can skip
   *   time. With `hasFakeWebGl`, the page has a WebGL that draws nothing.
   */
  async newPage(site, { viewport = VIEWPORT, hasVirtualTime = false, hasFakeWebGl = false, ...media } = {}) {
    const page = hasVirtualTime ? await this.browser.newPage() : await (await this.contextOf(site)).newPage();
    await page.setViewportSize(viewport);
    await page.emulateMedia(media);
    if (hasVirtualTime) await page.clock.install();
    if (hasFakeWebGl) await page.addInitScript(fakeWebGl);
    // By default, Playwright looks at a page in each frame, which makes the page draw each frame.
    const { waitForFunction } = page;
    page.waitForFunction = (condition, argument, options) => waitForFunction.call(page, condition, argument, { polling: POLLING_MS, ...options });
    return page;
  }

  async contextOf(site) {
    const { protocol, hostname } = new URL(site), key = protocol + hostname;
    if (!this.contexts.has(key)) {
      const context = await this.browser.newContext();
      this.contexts.set(key, context);
      // Without a page, the renderer process would end.
      await (await context.newPage()).goto(site);
    }
    return this.contexts.get(key);
  }

  /**
   * Opens a page from a file. Its `complaints` are exceptions, dialogs, console messages other than logs, and requests other than those for the page
   * itself and for data URLs.
   * @param options Size of the window, colour scheme, and fragment of the address.
   */
  async open(name, data, { fragment = '', ...options } = {}) {
    const address = this.write(render(data, name), name) + fragment;
    const page = await this.newPage(this.blank ??= this.write('', 'blank'), options);
    recordErrors(page);
    page.on('request', r => r.url() !== address.replace(/#.*/, '') && !r.url().startsWith('data:') && page.complaints.push(`request: ${r.url()}`));
    page.on('dialog', d => { page.complaints.push(`dialog: ${d.message()}`); return d.dismiss(); });
    await page.goto(address);
    await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    return page;
  }
}

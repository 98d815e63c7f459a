// Shared by the tests of pages. Starts each browser once per process, and closes the pages of a test when it ends.
import { after, afterEach, beforeEach } from 'node:test';
import { Browser, NO_WEBGL } from './browser.mjs';

const browsers = new Map();
let opened = [];

// A page that was opened before the first test of a block is shared by the tests of this block.
beforeEach(() => { opened = []; });
afterEach(() => Promise.all(opened.splice(0).map(page => page.close())));
after(async () => Promise.all([...browsers.values()].map(async browser => (await browser).stop())));

/** Returns the browser of the process with these flags. */
export function browserWith(graphics = NO_WEBGL) {
  if (!browsers.has(graphics)) browsers.set(graphics, Browser.start(graphics));
  return browsers.get(graphics);
}

/** Closes the page at the end of the test. */
export function closeLater(page) {
  opened.push(page);
  return page;
}

/** @returns A function that opens pages with this name, see `Browser.open`. */
export const opener = (name, graphics = NO_WEBGL) => async (...options) => closeLater(await (await browserWith(graphics)).open(name, ...options));

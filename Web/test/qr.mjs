// Reads codes with a library other than those that draw them.
import jsQR from 'jsqr';
import { drawn } from './drawn.mjs';

/** Reads the code in a picture of 8-bit grey values, row by row; null if there is none. */
function readGreys(greys, width, height) {
  const pixels = new Uint8ClampedArray(width * height * 4);
  greys.forEach((grey, i) => pixels.fill(grey, 4 * i, 4 * i + 3).fill(255, 4 * i + 3, 4 * i + 4));
  return jsQR(pixels, width, height, { inversionAttempts: 'dontInvert' })?.data ?? null;
}

/** Reads the code in the output of a terminal. Each line contains two rows of squares, and printed characters are light. */
export function readBlocks(text) {
  const lines = text.split('\n').filter(line => /^[ █▀▄]+$/.test(line));
  const isLight = (line, x, isUpper) => '█'.includes(line[x]) || line[x] === (isUpper ? '▀' : '▄');
  const rows = lines.flatMap(line => [true, false].map(isUpper => [...line].map((_, x) => isLight(line, x, isUpper))));
  const scale = 6;
  const width = rows[0].length * scale;
  const greys = rows.flatMap(row => Array.from({ length: scale }, () => row.flatMap(light => Array(scale).fill(light ? 255 : 0))).flat());
  return readGreys(greys, width, rows.length * scale);
}

/** Reads the code in an element of a page from a screenshot, as soon as the code is drawn. */
export const readElement = locator => drawn(() => readScreenshot(locator), text => text !== null);

async function readScreenshot(locator) {
  const png = (await locator.screenshot()).toString('base64');
  // Returns the grey values as Base64, too, because an array of a million numbers takes seconds to serialise.
  const { greys, width, height } = await locator.page().evaluate(async base64 => {
    const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    let greys = '';
    for (let i = 0; i < data.length; i += 4) greys += String.fromCharCode(data[i]);
    return { greys: btoa(greys), width: bitmap.width, height: bitmap.height };
  }, png);
  return readGreys(Buffer.from(greys, 'base64'), width, height);
}

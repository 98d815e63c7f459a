// Reads the canvases of a page's plots.

/** Returns whether the canvas of a plot has a pixel with approximately the colour of a style sheet variable. */
export const hasInk = (page, index, ink) => page.evaluate(([index, ink]) => {
  const probe = document.createElement('span');
  probe.style.color = `var(${ink})`;
  document.body.append(probe);
  const want = getComputedStyle(probe).color.match(/\d+/g).map(Number);
  probe.remove();
  const canvas = document.querySelectorAll('.plot canvas')[index];
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 200 && want.every((w, c) => Math.abs(data[i + c] - w) < 12)) return true;
  }
  return false;
}, [index, ink]);

/** Returns the background colours of elements without a contrast theme of the system, and with one. */
export async function coloursInThemes(page, selector) {
  const colours = [];
  for (const forcedColors of ['none', 'active']) {
    await page.emulateMedia({ forcedColors });
    colours.push(await page.locator(selector).evaluateAll(all => all.map(e => getComputedStyle(e).backgroundColor)));
  }
  await page.emulateMedia({ forcedColors: null });
  return colours;
}

export const settled = page => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Computes the relative luminance of style sheet colours, and the contrast of two colours. */
export const luminance = (page, inks) => page.evaluate(inks => inks.map(ink => {
  const [r, g, b] = getComputedStyle(document.documentElement).getPropertyValue(ink).trim().match(/\w\w/g)
    .map(h => parseInt(h, 16) / 255).map(c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}), inks);
export const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);

/** Returns the number of painted pixels and the number of colours in the canvas of each plot. */
export const painted = page => page.evaluate(() => [...document.querySelectorAll('.plot canvas')].map(canvas => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const colours = new Set();
  let pixels = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 128) continue;
    pixels++;
    colours.add(`${data[i] >> 5},${data[i + 1] >> 5},${data[i + 2] >> 5}`);
  }
  return { pixels, colours: colours.size };
}));

/** Returns the median height of a signal, from 0 at the bottom of the plot area to 1 at its top. */
export const heightOf = (page, index, ink) => page.evaluate(([index, ink]) => {
  const plot = document.querySelectorAll('.plot')[index], canvas = plot.querySelector('canvas');
  const over = plot.querySelector('.u-over').getBoundingClientRect(), top = over.top - canvas.getBoundingClientRect().top;
  const want = getComputedStyle(document.documentElement).getPropertyValue(ink).trim().match(/\w\w/g).map(h => parseInt(h, 16));
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const rows = [];
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 200 || !want.every((w, c) => Math.abs(data[i + c] - w) < 12)) continue;
    rows.push(Math.floor(i / 4 / canvas.width) + 0.5 - top);
  }
  return 1 - rows[rows.length >> 1] / over.height;
}, [index, ink]);

/** Returns the share of a column of the render time plot that has the shade of an alarm. The column is at a time within the 10 s shown. */
export const shadedShare = (page, time) => page.evaluate(time => {
  const plot = document.querySelector('#range .plot'), canvas = plot.querySelector('canvas');
  const over = plot.querySelector('.u-over').getBoundingClientRect(), left = over.left - canvas.getBoundingClientRect().left;
  const { data } = canvas.getContext('2d').getImageData(Math.round((left + (over.width * time) / 10) * devicePixelRatio), 0, 1, canvas.height);
  let shaded = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 20 && data[i] > data[i + 2] + 80) shaded++;
  return shaded / canvas.height;
}, time);

export const shot = (page, index) => page.evaluate(i => document.querySelectorAll('.plot canvas')[i].toDataURL(), index);

// Reads the canvases of a page's plots.

/** Whether the plot's canvas has a pixel near the colour of a style sheet variable. */
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

export const settled = page => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Relative luminance of style sheet colours, and the contrast of two colours. */
export const luminance = (page, inks) => page.evaluate(inks => inks.map(ink => {
  const [r, g, b] = getComputedStyle(document.documentElement).getPropertyValue(ink).trim().match(/\w\w/g)
    .map(h => parseInt(h, 16) / 255).map(c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}), inks);
export const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);

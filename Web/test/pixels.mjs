// Reads a 3D view from a screenshot, because a WebGL canvas does not keep its picture.
import { drawn } from './drawn.mjs';

/**
 * Counts the pixels of an element that have the colours of the robots (blue, orange and grey), and the coloured pixels at its edge.
 * @param holds Condition that the counts of one of the next screenshots must meet.
 */
export const picture = (page, locator, holds = () => true) => drawn(() => counted(page, locator), holds);

async function counted(page, locator) {
  const png = (await locator.screenshot()).toString('base64');
  return page.evaluate(async png => {
    const bytes = Uint8Array.from(atob(png), c => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const counts = { blue: 0, orange: 0, grey: 0, edge: 0, pixels: image.width * image.height };
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
      const pixel = i / 4, x = pixel % image.width, y = (pixel - x) / image.width;
      if (Math.abs(r - b) > 40 && (x < 4 || y < 4 || x >= image.width - 4 || y >= image.height - 4)) counts.edge++;
      if (b > r + 40) counts.blue++;
      else if (r > b + 40) counts.orange++;
      else if (Math.abs(r - b) < 40 && r > 60 && r < 215) counts.grey++;
    }
    return counts;
  }, png);
}

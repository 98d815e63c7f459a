import { homography, type Quad } from './geometry';

/** A grey picture, one byte per pixel, row by row. */
export interface Grey {
  width: number;
  height: number;
  data: Uint8Array;
}

/** What a byte of a picture means as light, 0 to 1: cameras write sRGB. */
export const lightOfByte = Float32Array.from({ length: 256 }, (_, v) => {
  const s = v / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
});

/**
 * The picture's bytes at the middle of each cell, for a picture that is already smooth at the size of a cell.
 * False when a part lies outside of the picture.
 */
export function sampleCentres({ width, height, data }: Grey, quad: Quad, side: number, margin: number, levels: Float64Array): boolean {
  const [a, b, c, d, e, f, g, h] = homography(quad);
  const cells = side + 2 * margin;
  for (let row = 0, i = 0; row < cells; row++) {
    const v = (row - margin + 0.5) / side;
    for (let column = 0; column < cells; column++, i++) {
      const u = (column - margin + 0.5) / side, w = 1 / (g * u + h * v + 1);
      const x = (a * u + b * v + c) * w - 0.5, y = (d * u + e * v + f) * w - 0.5;
      const left = Math.floor(x), top = Math.floor(y);
      if (!(left >= 0 && top >= 0 && left < width - 1 && top < height - 1)) return false;
      const fx = x - left, fy = y - top, at = top * width + left;
      levels[i] = (data[at] * (1 - fx) + data[at + 1] * fx) * (1 - fy) + (data[at + width] * (1 - fx) + data[at + width + 1] * fx) * fy;
    }
  }
  return true;
}

/** Mean light, 0 to 1, in the middle of each cell: what lies near its edges is mixed with its neighbours'. */
export function meanLight({ width, height, data }: Grey, quad: Quad, side: number): number[] | null {
  const [a, b, c, d, e, f, g, h] = homography(quad);
  const points = 5, share = 0.5;
  const levels: number[] = [];
  for (let row = 0; row < side; row++) {
    for (let column = 0; column < side; column++) {
      let sum = 0;
      for (let i = 0; i < points * points; i++) {
        const u = (column + 0.5 + share * ((i % points + 0.5) / points - 0.5)) / side;
        const v = (row + 0.5 + share * ((Math.floor(i / points) + 0.5) / points - 0.5)) / side;
        const w = 1 / (g * u + h * v + 1);
        const x = Math.floor((a * u + b * v + c) * w), y = Math.floor((d * u + e * v + f) * w);
        if (!(x >= 0 && y >= 0 && x < width && y < height)) return null;
        sum += lightOfByte[data[y * width + x]];
      }
      levels.push(sum / (points * points));
    }
  }
  return levels;
}

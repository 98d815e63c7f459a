import type { Homography } from './geometry';

/** A grey picture with one byte per pixel, row by row. */
export interface Grey {
  width: number;
  height: number;
  data: Uint8Array;
}

/** Mirrors a picture horizontally. */
export function mirrored({ width, height, data }: Grey): Grey {
  const swapped = new Uint8Array(data.length);
  for (let row = 0; row < height; row++)
    swapped.set(
      data
        .subarray(row * width, (row + 1) * width)
        .slice()
        .reverse(),
      row * width,
    );
  return { width, height, data: swapped };
}

/** Converts a byte of a picture to linear light, 0 to 1. Cameras store sRGB. */
export const lightOfByte = Float32Array.from({ length: 256 }, (_, v) => {
  const s = v / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
});

/** A picture in linear light, 0 to 1 per pixel, row by row. If sRGB values were smoothed, edges would move towards bright areas. */
export interface Light {
  width: number;
  height: number;
  data: Float32Array;
}

export function lightOf({ width, height, data }: Grey): Light {
  const light = new Float32Array(data.length);
  for (let i = 0; i < data.length; i++) light[i] = lightOfByte[data[i]];
  return { width, height, data: light };
}

/** Returns the light at a point, interpolated between the centres of pixels; NaN outside the picture. */
function lightAt({ width, height, data }: Light, x: number, y: number): number {
  const column = Math.floor(x - 0.5);
  const row = Math.floor(y - 0.5);
  if (!(column >= 0 && row >= 0 && column < width - 1 && row < height - 1)) return NaN;
  const right = x - 0.5 - column;
  const down = y - 0.5 - row;
  const at = row * width + column;
  const above = data[at] * (1 - right) + data[at + 1] * right;
  const below = data[at + width] * (1 - right) + data[at + width + 1] * right;
  return above * (1 - down) + below * down;
}

/** Returns the light at a point of the unit square, which a homography maps to the picture. */
export function lightThrough(picture: Light, { a, b, c, d, e, f, g, h }: Homography, u: number, v: number): number {
  const w = 1 / (g * u + h * v + 1);
  return lightAt(picture, (a * u + b * v + c) * w, (d * u + e * v + f) * w);
}

/** Light to which the brightest pixels of a dark picture are raised, the share of pixels that count as the brightest, and the maximum factor. */
const raisedTo = 0.5;
const brightest = 0.001;
const maxGain = 16;

/** Brightens a dark picture, so that its codes are found as in a bright one. */
export function brightened(light: Light): Light {
  const steps = 1024;
  const counts = new Uint32Array(steps + 1);
  for (let i = 0; i < light.data.length; i++) counts[(light.data[i] * steps) | 0]++;
  let step = steps;
  for (let above = 0; step > 0 && above < brightest * light.data.length; step--) above += counts[step];
  const gain = Math.min(maxGain, (raisedTo * steps) / (step + 1));
  if (gain <= 1) return light;
  const data = new Float32Array(light.data.length);
  for (let i = 0; i < data.length; i++) data[i] = gain * light.data[i];
  return { ...light, data };
}

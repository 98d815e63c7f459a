/** A grey picture with one byte per pixel, row by row. */
export interface Grey {
  width: number;
  height: number;
  data: Uint8Array;
  /** Red, green, blue and opacity of each pixel, if the picture has colours. The grey value is the brightest of the colours. */
  colours?: Uint8Array | Uint8ClampedArray;
}

/** Combines the bytes of red, green and blue. Each pixel consists of red, green, blue and opacity 255, in this order. */
export function rgbaOf(channels: Uint8Array[]): Uint8ClampedArray {
  const rgba = new Uint8ClampedArray(4 * channels[0].length).fill(255);
  for (let c = 0; c < channels.length; c++) {
    const channel = channels[c];
    for (let i = 0; i < channel.length; i++) rgba[4 * i + c] = channel[i];
  }
  return rgba;
}

/** Uses the brightest colour channel of each pixel, because the luma of a red or blue LED is only a small part of its light. */
export function greyOf({ width, height, data }: { width: number; height: number; data: Uint8Array | Uint8ClampedArray }): Grey {
  const grey = new Uint8Array(width * height);
  for (let i = 0, j = 0; i < grey.length; i++, j += 4) grey[i] = Math.max(data[j], data[j + 1], data[j + 2]);
  return { width, height, data: grey, colours: data };
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

export const lightOf = ({ width, height, data }: Grey): Light => ({ width, height, data: lightOfBytes(data, 0, 1) });

/** Yields the light of a picture in red, in green and in blue. Yields nothing if the picture has no colours. */
export function* coloursOf({ width, height, colours }: Grey): Generator<Light> {
  if (colours) for (const colour of [0, 1, 2]) yield { width, height, data: lightOfBytes(colours, colour, 4) };
}

function lightOfBytes(bytes: Uint8Array | Uint8ClampedArray, first: number, stride: number): Float32Array {
  const light = new Float32Array(bytes.length / stride);
  for (let i = 0, j = first; i < light.length; i++, j += stride) light[i] = lightOfByte[bytes[j]];
  return light;
}

/**
 * Computes the light at points of the unit square, which a homography maps to the picture. The light is interpolated between the centres of
 * pixels; NaN outside the picture.
 *
 * @param seen Coefficients of the homography; see `setHomography`.
 * @param points u and v of each point, one after another.
 * @param lights Receives the light at the points from `first` to `end`, exclusive.
 */
export function sampleLight(picture: Light, seen: Float64Array, points: Float64Array, lights: Float64Array, first: number, end: number): void {
  const [a, b, c, d, e, f, g, h] = [seen[0], seen[1], seen[2], seen[3], seen[4], seen[5], seen[6], seen[7]];
  const { width, height, data } = picture;
  const right = width - 1;
  const bottom = height - 1;
  for (let i = first; i < end; i++) {
    const u = points[2 * i];
    const v = points[2 * i + 1];
    const w = 1 / (g * u + h * v + 1);
    const x = (a * u + b * v + c) * w - 0.5;
    const y = (d * u + e * v + f) * w - 0.5;
    if (x >= 0 && y >= 0 && x < right && y < bottom) {
      const column = x | 0;
      const row = y | 0;
      const at = row * width + column;
      const across = x - column;
      const down = y - row;
      const above = data[at] * (1 - across) + data[at + 1] * across;
      const below = data[at + width] * (1 - across) + data[at + width + 1] * across;
      lights[i] = above * (1 - down) + below * down;
    } else lights[i] = NaN;
  }
}

/**
 * raisedTo: light to which the brightest pixels of a dark picture are raised. brightest: share of the pixels that count as the brightest. maxGain:
 * maximum factor.
 */
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

import { greyOf, rgbaOf, type Grey } from '../levels';
import { cv } from '../opencv';
import { addCode, type DrawnCode } from './codeLight';
import { normals, randomOf } from './random';
import { sceneOf } from './scene';

type Mat = InstanceType<typeof cv.Mat>;

/** A picture to render. Lengths are in px; light is linear, 1 is white. */
export interface Shot {
  width: number;
  height: number;
  /** Seed of the scene behind the codes. `sceneLight` is its brightness factor. */
  scene: number;
  sceneLight: number;
  codes: DrawnCode[];
  /** Standard deviation of the lens blur. */
  blur: number;
  /** Movement of the camera during the exposure. */
  motion: [number, number];
  /** Round reflections. */
  glares: { x: number; y: number; radius: number; light: number }[];
  /** Rectangles in front of all other objects: x, y, width, height. */
  covers: { box: [number, number, number, number]; light: number }[];
  /** Standard deviation of the sensor noise; 255 is white. */
  noise: number;
  noiseSeed: number;
}

/** Computed when the first picture is rendered, because most workers render none. */
let noiseTable: Float32Array | undefined;
const steps = 4095;
/** Converts linear light to sRGB. This is the inverse of `lightOfByte`. */
const byteOfLight = Float32Array.from({ length: steps + 1 }, (_, i) => {
  const v = i / steps;
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
});

const scenes = new Map<string, Mat>();
const scenesKept = 4;

/** Renders the picture that a camera takes of a scene with codes, in colour if a code has one. Equal shots give equal pictures. */
export function take(shot: Shot): Grey {
  if (shot.codes.every(({ colour }) => !colour)) return takeGrey(shot);
  const seen = [0, 1, 2].map(channel =>
    takeGrey({
      ...shot,
      codes: shot.codes.map(code => ({ ...code, light: code.light * (code.colour?.[channel] ?? 1) })),
      noiseSeed: shot.noiseSeed + channel,
    }),
  );
  return greyOf({ ...shot, data: rgbaOf(seen.map(({ data }) => data)) });
}

function takeGrey(shot: Shot): Grey {
  const light = new cv.Mat();
  try {
    keptScene(shot).convertTo(light, -1, shot.sceneLight);
    for (const code of shot.codes) addCode(light, code);
    for (const glare of shot.glares) addGlare(light, glare);
    for (const { box, light: grey } of shot.covers)
      cv.rectangle(light, new cv.Point(box[0], box[1]), new cv.Point(box[0] + box[2], box[1] + box[3]), new cv.Scalar(grey), cv.FILLED);
    if (shot.blur > 0) cv.GaussianBlur(light, light, new cv.Size(0, 0), shot.blur);
    smear(light, shot.motion);
    return { width: shot.width, height: shot.height, data: developed(light.data32F, shot) };
  } finally {
    light.delete();
  }
}

function keptScene({ scene, width, height }: Shot): Mat {
  const key = `${scene} ${width} ${height}`;
  let kept = scenes.get(key);
  if (!kept) {
    kept = sceneOf(scene, width, height);
    scenes.set(key, kept);
    const oldest = scenes.keys().next().value!;
    if (scenes.size > scenesKept) {
      scenes.get(oldest)!.delete();
      scenes.delete(oldest);
    }
  }
  return kept;
}

function addGlare(light: Mat, { x, y, radius, light: amount }: Shot['glares'][number]): void {
  const data = light.data32F;
  const width = light.cols;
  const top = Math.max(0, Math.floor(y - radius));
  const bottom = Math.min(light.rows, Math.ceil(y + radius));
  const left = Math.max(0, Math.floor(x - radius));
  const right = Math.min(width, Math.ceil(x + radius));
  for (let j = top; j < bottom; j++)
    for (let i = left; i < right; i++) {
      const r = ((i - x) ** 2 + (j - y) ** 2) / radius ** 2;
      if (r < 1) data[j * width + i] += amount * (1 - r) ** 2;
    }
}

function smear(light: Mat, [dx, dy]: [number, number]): void {
  const length = Math.hypot(dx, dy);
  if (length < 1) return;
  const half = Math.ceil(length / 2);
  const size = 2 * half + 1;
  const kernel = new cv.Mat(size, size, cv.CV_32FC1, new cv.Scalar(0));
  cv.line(kernel, new cv.Point(half - dx / 2, half - dy / 2), new cv.Point(half + dx / 2, half + dy / 2), new cv.Scalar(1), 1);
  kernel.convertTo(kernel, -1, 1 / kernel.data32F.reduce((a, b) => a + b, 0));
  cv.filter2D(light, light, -1, kernel);
  kernel.delete();
}

/** Converts light to bytes and adds the sensor noise. */
function developed(light: Float32Array, { noise, noiseSeed, width }: Shot): Uint8Array {
  const bytes = new Uint8ClampedArray(light.length);
  const random = randomOf(noiseSeed);
  const table = (noiseTable ??= normals(1 << 17, 1));
  const last = table.length - 1;
  for (let at = 0; at < light.length; at += width) {
    let n = (random() * table.length) | 0;
    for (let i = at; i < at + width; i++) {
      const v = light[i];
      bytes[i] = byteOfLight[v >= 1 ? steps : v <= 0 ? 0 : (v * steps) | 0] + noise * table[n++ & last];
    }
  }
  return new Uint8Array(bytes.buffer);
}

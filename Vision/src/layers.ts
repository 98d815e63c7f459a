import { minSide } from './candidates';
import { scaled, sizeOf, type Quad } from './geometry';
import type { Light } from './levels';
import type { Matcher } from './match';
import { cv } from './opencv';
import { Refiner, type Fit } from './refine';

type Mat = InstanceType<typeof cv.Mat>;

/** Maximum side of a code in a layer, px. Larger codes are searched for in a smaller copy of the picture, which is smooth at the scale of a cell. */
const maxSide = 1.8 * minSide;

/** A copy of the picture that is scaled by a factor. */
export interface Layer {
  factor: number;
  picture: Light;
  refiner: Refiner;
}

/**
 * Returns the picture and copies of it, each half as large as the previous one, until the shorter side is less than the minimum side of a code.
 * @param whole Scale of the searched picture relative to the original one.
 */
export function layersOf(picture: Mat, whole: number, matcher: Matcher, isFilled: boolean[]): Layer[] {
  const layers: Layer[] = [];
  for (let factor = 1; Math.min(picture.cols, picture.rows) * factor >= minSide; factor /= 2) {
    const copy = new cv.Mat();
    cv.resize(picture, copy, new cv.Size(Math.round(picture.cols * factor), Math.round(picture.rows * factor)), 0, 0, cv.INTER_AREA);
    if (factor < 1) smooth(copy);
    // Copies the data, because OpenCV's memory moves when it grows.
    const light = { width: copy.cols, height: copy.rows, data: copy.data32F.slice() };
    layers.push({ factor: factor * whole, picture: light, refiner: new Refiner(matcher, isFilled, light) });
    copy.delete();
  }
  return layers;
}

/** Returns the layer in which a quad of a given size is searched for. */
export const layerFor = (quad: Quad, layers: Layer[]) => layers.find(layer => sizeOf(quad) * layer.factor <= maxSide) ?? layers.at(-1)!;

/** Converts a fit from px of its layer to px of the picture. */
export const inPicture = (fit: Fit, layer: Layer): Fit => ({ ...fit, quad: scaled(fit.quad, 1 / layer.factor) });

export const smooth = (picture: Mat) => cv.GaussianBlur(picture, picture, new cv.Size(5, 5), 1.4);

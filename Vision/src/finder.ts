import { candidatesIn, minSide } from './candidates';
import { cellLight } from './cellLight';
import { centreOf, distance, scaled, sizeOf, type Quad } from './geometry';
import { lightOf, type Grey, type Light } from './levels';
import { Matcher } from './match';
import { cv } from './opencv';
import type { Pattern } from './pattern';
import { Refiner, type Fit } from './refine';

/** A code in a picture. */
export interface Found {
  kind: string;
  /** In px: the top left corner of the upright code, then clockwise. */
  corners: Quad;
  /** Light of each cell without the scene behind it, row by row; linear, 1 is white. */
  levels: number[];
}

/** Maximum side of the searched picture, px. A larger one takes longer and finds no code that can be read. */
const maxSearchedSide = 1280;
/** Codes above this size are searched in a smaller copy of the picture, which is smooth at the size of their cells. */
const maxSide = 1.8 * minSide;

/** Minimum light, 1 is white, and minimum share of agreeing steps of a code. */
const minLight = 0.02, minShare = 0.6;
/** Share of agreeing steps from which the search for this kind of code ends. */
const minShareOfGood = 0.8;
/** Minimum agreement of a candidate before any refinement. */
const minShareOfGuess = 0.1;

interface Layer {
  factor: number;
  refiner: Refiner;
}

/** Finds one code of each kind in a picture. Starts at their last positions, because codes rarely move far in a series. */
export class Finder {
  readonly #pattern: Pattern;
  readonly #matcher: Matcher;
  #last: Fit[] = [];
  #lastSize = '';

  constructor(pattern: Pattern) {
    this.#pattern = pattern;
    this.#matcher = new Matcher(pattern);
  }

  find(grey: Grey): Found[] {
    const size = `${grey.width}x${grey.height}`;
    if (size !== this.#lastSize) this.#last = [];
    this.#lastSize = size;
    const light = lightOf(grey), picture = searched(light), layers = this.#layersOf(picture, picture.cols / grey.width);
    try {
      let fits = this.#again(layers);
      if (fits.length < this.#matcher.kinds.length) fits = this.#search(picture, layers, fits);
      this.#last = fits.filter(isGood);
      return fits.map(fit => this.#foundAs(fit, light));
    } finally {
      picture.delete();
    }
  }

  /** Returns the picture and smaller copies, until the largest possible code has at most the maximum size. */
  #layersOf(picture: Mat, whole: number): Layer[] {
    const layers: Layer[] = [], isFilled = Object.values(this.#pattern.kinds).map(kind => kind.isFilled);
    for (let factor = 1; Math.min(picture.cols, picture.rows) * factor >= minSide; factor /= 2) {
      const copy = new cv.Mat();
      cv.resize(picture, copy, new cv.Size(Math.round(picture.cols * factor), Math.round(picture.rows * factor)), 0, 0, cv.INTER_AREA);
      if (factor < 1) smooth(copy);
      // The data are copied because OpenCV's memory moves when it grows.
      layers.push({ factor: factor * whole, refiner: new Refiner(this.#matcher, isFilled, { width: copy.cols, height: copy.rows, data: copy.data32F.slice() }) });
      copy.delete();
    }
    return layers;
  }

  /** Searches at and near the last positions. */
  #again(layers: Layer[]): Fit[] {
    return bestOfEach(this.#last.flatMap(last => {
      const layer = layerFor(last.quad, layers);
      return layer.refiner.guesses(scaled(last.quad, layer.factor)).filter(guess => guess.kind === last.kind)
        .flatMap(guess => codesAt(guess, layer)).filter(isGood);
    }));
  }

  /** Searches everywhere except at known codes, the most probable candidate first. */
  #search(picture: Mat, layers: Layer[], known: Fit[]): Fit[] {
    const fits = [...known], isKnown = (quad: Quad) => fits.some(fit => isGood(fit) && isWithin(quad, fit.quad));
    const guesses = layers.length === 0 ? [] : candidatesIn(picture).map(quad => scaled(quad, 1 / layers[0].factor))
      .filter(quad => !isKnown(quad)).flatMap(quad => {
        const layer = layerFor(quad, layers);
        return layer.refiner.guesses(scaled(quad, layer.factor)).map(guess => ({ guess, layer }));
      }).filter(({ guess }) => guess.light >= minLight / 2 && guess.share > minShareOfGuess);
    for (const { guess, layer } of guesses.sort((a, b) => b.guess.share - a.guess.share)) {
      if (this.#matcher.kinds.every((_, kind) => fits.some(fit => fit.kind === kind && isGood(fit)))) break;
      if (!isKnown(inPicture(guess, layer).quad)) fits.push(...codesAt(guess, layer));
    }
    return bestOfEach(fits);
  }

  #foundAs({ kind, quad }: Fit, light: Light): Found {
    const name = this.#matcher.kinds[kind];
    return { kind: name, corners: quad, levels: cellLight(light, quad, this.#pattern, this.#pattern.kinds[name]) };
  }
}

type Mat = InstanceType<typeof cv.Mat>;

function searched({ width, height, data }: Light): Mat {
  const picture = new cv.Mat(height, width, cv.CV_32FC1), factor = maxSearchedSide / Math.max(width, height);
  picture.data32F.set(data);
  if (factor < 1) cv.resize(picture, picture, new cv.Size(Math.round(width * factor), Math.round(height * factor)), 0, 0, cv.INTER_AREA);
  smooth(picture);
  return picture;
}

const smooth = (picture: Mat) => cv.GaussianBlur(picture, picture, new cv.Size(5, 5), 1.4);

const layerFor = (quad: Quad, layers: Layer[]) => layers.find(layer => sizeOf(quad) * layer.factor <= maxSide) ?? layers.at(-1)!;

/** Returns the refined code, or none if it is too weak or ambiguous. */
function codesAt(guess: Fit, layer: Layer): Fit[] {
  const fit = layer.refiner.refine(guess);
  return fit.light >= minLight && fit.share >= minShare && layer.refiner.isClear(fit) ? [inPicture(fit, layer)] : [];
}

const isGood = (fit: Fit) => fit.share >= minShareOfGood;

/** Converts a fit from the pixels of its layer to those of the picture. */
const inPicture = (fit: Fit, layer: Layer): Fit => ({ ...fit, quad: scaled(fit.quad, 1 / layer.factor) });

/** Keeps the best fit of each kind. A fit to a part of a code agrees less than the fit to the whole code. */
function bestOfEach(fits: Fit[]): Fit[] {
  const kept: Fit[] = [];
  for (const fit of fits.sort((a, b) => b.share - a.share))
    if (kept.every(other => other.kind !== fit.kind && !isWithin(fit.quad, other.quad))) kept.push(fit);
  return kept;
}

const isWithin = (quad: Quad, other: Quad) => distance(centreOf(quad), centreOf(other)) < 0.55 * Math.max(sizeOf(quad), sizeOf(other));

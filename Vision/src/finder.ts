import { candidatesIn, leastSide } from './candidates';
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
  /** px: the code's top left corner as it is read, then clockwise. */
  corners: Quad;
  /** Light of each cell, row by row, without what is behind it; linear, 1 is white. */
  levels: number[];
}

/** The longest side that is searched; more would cost time and find nothing that can be read. */
const longestSearched = 1280;
/** Codes that are larger than this are looked at in a smaller copy of the picture, which is smooth at the size of their cells. */
const greatestSide = 1.8 * leastSide;

/** What is accepted as a code: its light, 1 is white, and the share of its steps that must agree. */
const leastLight = 0.02, leastShare = 0.6;
/** A code that is as good as this spares further search. */
const leastShareOfGood = 0.8;
/** Minimum agreement of a candidate before any refinement. */
const leastShareOfGuess = 0.1;

interface Layer {
  factor: number;
  refiner: Refiner;
}

/** Finds one code of each kind in a picture. Remembers where they were: in a series they seldom move far. */
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

  /** The picture, and smaller copies until the largest code is of a size that is looked at. */
  #layersOf(picture: Mat, whole: number): Layer[] {
    const layers: Layer[] = [], isFilled = Object.values(this.#pattern.kinds).map(kind => kind.isFilled);
    for (let factor = 1; Math.min(picture.cols, picture.rows) * factor >= leastSide; factor /= 2) {
      const copy = new cv.Mat();
      cv.resize(picture, copy, new cv.Size(Math.round(picture.cols * factor), Math.round(picture.rows * factor)), 0, 0, cv.INTER_AREA);
      if (factor < 1) smooth(copy);
      // A copy: OpenCV's memory moves when it grows.
      layers.push({ factor: factor * whole, refiner: new Refiner(this.#matcher, isFilled, { width: copy.cols, height: copy.rows, data: copy.data32F.slice() }) });
      copy.delete();
    }
    return layers;
  }

  /** Where they were before, or near there. */
  #again(layers: Layer[]): Fit[] {
    return bestOfEach(this.#last.flatMap(last => {
      const layer = layerFor(last.quad, layers);
      return layer.refiner.guesses(scaled(last.quad, layer.factor)).filter(guess => guess.kind === last.kind)
        .flatMap(guess => codesAt(guess, layer)).filter(isGood);
    }));
  }

  /** Everywhere but where codes are known, what looks most like a code first. */
  #search(picture: Mat, layers: Layer[], known: Fit[]): Fit[] {
    const fits = [...known], isKnown = (quad: Quad) => fits.some(fit => isGood(fit) && isWithin(quad, fit.quad));
    const guesses = layers.length === 0 ? [] : candidatesIn(picture).map(quad => scaled(quad, 1 / layers[0].factor))
      .filter(quad => !isKnown(quad)).flatMap(quad => {
        const layer = layerFor(quad, layers);
        return layer.refiner.guesses(scaled(quad, layer.factor)).map(guess => ({ guess, layer }));
      }).filter(({ guess }) => guess.light >= leastLight / 2 && guess.share > leastShareOfGuess);
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
  const picture = new cv.Mat(height, width, cv.CV_32FC1), factor = longestSearched / Math.max(width, height);
  picture.data32F.set(data);
  if (factor < 1) cv.resize(picture, picture, new cv.Size(Math.round(width * factor), Math.round(height * factor)), 0, 0, cv.INTER_AREA);
  smooth(picture);
  return picture;
}

const smooth = (picture: Mat) => cv.GaussianBlur(picture, picture, new cv.Size(5, 5), 1.4);

const layerFor = (quad: Quad, layers: Layer[]) => layers.find(layer => sizeOf(quad) * layer.factor <= greatestSide) ?? layers.at(-1)!;

/** None, or one. */
function codesAt(guess: Fit, layer: Layer): Fit[] {
  const fit = layer.refiner.refine(guess);
  return fit.light >= leastLight && fit.share >= leastShare && layer.refiner.isClear(fit) ? [inPicture(fit, layer)] : [];
}

const isGood = (fit: Fit) => fit.share >= leastShareOfGood;

/** In pixels of the picture. */
const inPicture = (fit: Fit, layer: Layer): Fit => ({ ...fit, quad: scaled(fit.quad, 1 / layer.factor) });

/** Of each kind the best. What a part of a code looks like is worse than what the code looks like. */
function bestOfEach(fits: Fit[]): Fit[] {
  const kept: Fit[] = [];
  for (const fit of fits.sort((a, b) => b.share - a.share))
    if (kept.every(other => other.kind !== fit.kind && !isWithin(fit.quad, other.quad))) kept.push(fit);
  return kept;
}

const isWithin = (quad: Quad, other: Quad) => distance(centreOf(quad), centreOf(other)) < 0.55 * Math.max(sizeOf(quad), sizeOf(other));

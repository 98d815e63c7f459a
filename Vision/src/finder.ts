import { candidatesIn, minSide } from './candidates';
import { cellLight } from './cellLight';
import { centreOf, distance, scaled, sizeOf, turned, type Quad } from './geometry';
import { brightened, lightOf, type Grey, type Light } from './levels';
import { Matcher } from './match';
import { cv } from './opencv';
import type { Pattern } from './pattern';
import { Refiner, type Fit } from './refine';

/** A code in a picture. */
export interface Found {
  kind: string;
  /** In px: the top left corner of the upright code, then clockwise. */
  corners: Quad;
  /** Share of the steps of light between cells that are as expected, at most 1. */
  share: number;
  /** Light of each cell without the scene behind it, row by row; linear, 1 is white. */
  levels: number[];
}

/** Maximum side of the searched picture, px. A larger one takes longer and finds no code that can be read. */
const maxSearchedSide = 1280;
/** Codes above this size are searched in a smaller copy of the picture, which is smooth at the size of their cells. */
const maxSide = 1.8 * minSide;

/** Minimum light, 1 is white, and minimum share of agreeing steps of a code. */
const minLight = 0.02, minShare = 0.6;
/** Share of agreeing steps from which nothing better is searched at a position. A code that is taken for another kind reaches up to 0.85. */
const minShareOfCertain = 0.88;
/** Minimum share of agreeing steps of a second code of one kind. A part of another object may resemble a code up to this share. */
const minShareOfSecond = 0.8;
/** Minimum agreement of a candidate before any refinement. */
const minShareOfGuess = 0.1;
/** Maximum distance between the corners of candidates that count as one, in cells. The search around a candidate covers it. */
const maxDistanceOfSame = 0.5;

interface Layer {
  factor: number;
  refiner: Refiner;
}

/** Finds all codes in a picture. The result depends on this picture alone, not on earlier ones. */
export class Finder {
  readonly #pattern: Pattern;
  readonly #matcher: Matcher;

  constructor(pattern: Pattern) {
    this.#pattern = pattern;
    this.#matcher = new Matcher(pattern);
  }

  find(grey: Grey): Found[] {
    const light = lightOf(grey), picture = searched(brightened(light));
    try {
      return this.#search(picture, this.#layersOf(picture, picture.cols / grey.width)).map(fit => this.#foundAs(fit, light));
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

  /** Refines all candidates, the most probable one first. */
  #search(picture: Mat, layers: Layer[]): Fit[] {
    if (layers.length === 0) return [];
    const candidates = distinct(candidatesIn(picture), this.#pattern.side).map(quad => {
      const found = scaled(quad, 1 / layers[0].factor), layer = layerFor(found, layers);
      return { layer, starts: layer.refiner.startsAt(scaled(found, layer.factor)) };
    });
    const fits: Fit[] = [], isKnown = (quad: Quad, { factor }: Layer) =>
      fits.some(fit => isCertain(fit) && isWithin(scaled(quad, 1 / factor), fit.quad));
    for (const { layer, starts } of candidates.sort((a, b) => b.starts[0].share - a.starts[0].share)) {
      if (isKnown(starts[0].quad, layer)) continue;
      for (const guess of layer.refiner.guesses(starts))
        if (guess.light >= minLight / 2 && guess.share > minShareOfGuess && !isKnown(guess.quad, layer)) fits.push(...codesAt(guess, layer));
    }
    const codes = bestOfEach(fits);
    return codes.filter(fit => codes.every(other => other.kind !== fit.kind || other === fit || isMoreThanResemblance(fit, other)));
  }

  #foundAs({ kind, quad, share }: Fit, light: Light): Found {
    const name = this.#matcher.kinds[kind];
    return { kind: name, corners: quad, share, levels: cellLight(light, quad, this.#pattern, this.#pattern.kinds[name]) };
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

const isCertain = ({ share }: Fit) => share >= minShareOfCertain;

/** Whether a fit is a code, although there is another fit of the same kind. */
const isMoreThanResemblance = (fit: Fit, other: Fit) => fit.share >= minShareOfSecond || other.share < minShareOfSecond;

/** Converts a fit from the pixels of its layer to those of the picture. */
const inPicture = (fit: Fit, layer: Layer): Fit => ({ ...fit, quad: scaled(fit.quad, 1 / layer.factor) });

/** Keeps the best fit at each position. A fit to a part of a code agrees less than the fit to the whole code. */
function bestOfEach(fits: Fit[]): Fit[] {
  const kept: Fit[] = [];
  for (const fit of fits.sort((a, b) => b.share - a.share)) if (!kept.some(other => isWithin(fit.quad, other.quad))) kept.push(fit);
  return kept;
}

/** Keeps one of several candidates with nearly the same corners, in any order of the corners. */
function distinct(quads: Quad[], side: number): Quad[] {
  const kept: Quad[] = [];
  for (const quad of quads) {
    const near = maxDistanceOfSame * sizeOf(quad) / side;
    const isSame = (other: Quad) => [0, 1, 2, 3].some(turns => turned(other, turns).every((p, i) => distance(p, quad[i]) <= near));
    if (!kept.some(isSame)) kept.push(quad);
  }
  return kept;
}

const isWithin = (quad: Quad, other: Quad) => distance(centreOf(quad), centreOf(other)) < 0.55 * Math.max(sizeOf(quad), sizeOf(other));

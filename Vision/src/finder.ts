import { candidatesIn, greatestSide, leastSide } from './candidates';
import { centreOf, distance, scaled, sizeOf, turned, type Quad } from './geometry';
import { meanLight, type Grey } from './levels';
import { cv } from './opencv';
import { Matcher, type Pattern } from './pattern';
import { Refiner, type Fit } from './refine';

/** A code in a picture. */
export interface Found {
  kind: string;
  /** px: the code's top left corner as it is read, then clockwise. */
  corners: Quad;
  /** Mean light of each cell, row by row, 0 (black) to 1 (white), linear. */
  levels: number[];
  /** Rest over light of the fit: 0 is perfect. */
  rest: number;
}

/** The longest side that is searched; more would cost time and find nothing that can be read. */
const longestSearched = 1280;

/** What is accepted as a code: by how much its light stands out, of 255, and over what is not explained. */
const leastLight = 12, greatestRest = 0.22, leastContrast = 0.4;
/** A code that is as good as this spares further search. */
const greatestRestOfGood = 0.15, leastContrastOfGood = 0.5;

interface Layer {
  factor: number;
  mat: InstanceType<typeof cv.Mat>;
  refiner: Refiner;
}

/** Finds one code of each kind in a picture. Remembers where they were: in a series they seldom move far. */
export class Finder {
  readonly #matcher: Matcher;
  readonly #kinds: string[];
  #last = new Map<string, Quad>();
  #lastSize = '';

  constructor(pattern: Pattern) {
    this.#matcher = new Matcher(pattern);
    this.#kinds = Object.keys(pattern.kinds);
  }

  find(grey: Grey): Found[] {
    const size = `${grey.width}x${grey.height}`;
    if (size !== this.#lastSize) this.#last.clear();
    this.#lastSize = size;
    const layers = this.#layersOf(grey);
    try {
      let fits = this.#again(layers);
      if (fits.size < this.#kinds.length) fits = this.#search(layers, fits);
      for (const [kind, fit] of fits) this.#last.set(kind, fit.quad);
      return [...fits].flatMap(([kind, fit]) => this.#foundAs(kind, fit, grey));
    } finally {
      for (const layer of layers) layer.mat.delete();
    }
  }

  /** The picture, and smaller copies until the largest code is of a size that is searched for. */
  #layersOf(grey: Grey): Layer[] {
    const whole = new cv.Mat(grey.height, grey.width, cv.CV_8UC1);
    whole.data.set(grey.data);
    const layers: Layer[] = [];
    let factor = Math.min(1, longestSearched / Math.max(grey.width, grey.height));
    for (; Math.min(grey.width, grey.height) * factor >= leastSide; factor /= 2) {
      const mat = new cv.Mat();
      const size = new cv.Size(Math.round(grey.width * factor), Math.round(grey.height * factor));
      if (factor === 1) whole.copyTo(mat);
      else cv.resize(whole, mat, size, 0, 0, cv.INTER_AREA);
      cv.GaussianBlur(mat, mat, new cv.Size(5, 5), 1.4);
      // A copy: OpenCV's memory moves when it grows.
      layers.push({ factor, mat, refiner: new Refiner(this.#matcher, { width: mat.cols, height: mat.rows, data: mat.data.slice() }) });
    }
    whole.delete();
    return layers;
  }

  /** Where they were before, or near there. */
  #again(layers: Layer[]): Map<string, Fit> {
    const fits: Fit[] = [];
    for (const [kind, quad] of this.#last) {
      const layer = layers.find(l => sizeOf(quad) * l.factor <= greatestSide) ?? layers.at(-1);
      if (!layer) continue;
      const near = scaled(quad, layer.factor);
      const guess = layer.refiner.guess(near);
      const fit = guess && guess.agreement.kind === kind && guess.agreement.turns === 0 ? layer.refiner.refine(guess) : null;
      if (fit && isCode(fit) && layer.refiner.isClear(fit) && isGood(fit)) fits.push(inPicture(fit, layer));
      else fits.push(...this.#codesIn(layer, around(near, layer.mat)).filter(f => f.agreement.kind === kind && isGood(f)));
    }
    return bestOfEach(fits);
  }

  /** Everywhere; large codes first, which are found quickly. */
  #search(layers: Layer[], known: Map<string, Fit>): Map<string, Fit> {
    const fits = [...known.values()];
    let found = known;
    for (const layer of [...layers].reverse()) {
      fits.push(...this.#codesIn(layer, new cv.Rect(0, 0, layer.mat.cols, layer.mat.rows)));
      found = bestOfEach(fits);
      if (found.size === this.#kinds.length && [...found.values()].every(isGood)) break;
    }
    return found;
  }

  #codesIn(layer: Layer, part: { x: number; y: number; width: number; height: number }): Fit[] {
    const fits: Fit[] = [], view = layer.mat.roi(part);
    for (const inPart of candidatesIn(view)) {
      const quad = inPart.map(p => [p[0] + part.x, p[1] + part.y]) as Quad;
      const guess = best([1, 0.93, 1.08].map(factor => layer.refiner.guess(grownBy(quad, factor))));
      if (!guess || guess.agreement.light < leastLight / 2 || guess.agreement.rest > 0.7 * guess.agreement.light) continue;
      const fit = layer.refiner.refine(guess);
      if (isCode(fit) && layer.refiner.isClear(fit)) fits.push(inPicture(fit, layer));
    }
    view.delete();
    return fits;
  }

  #foundAs(kind: string, fit: Fit, grey: Grey): Found[] {
    const levels = meanLight(grey, fit.quad, this.#matcher.side);
    return levels ? [{ kind, corners: fit.quad, levels, rest: fit.agreement.rest / fit.agreement.light }] : [];
  }
}

function isCode({ agreement: { light, rest }, contrast }: Fit): boolean {
  return light >= leastLight && rest < greatestRest * light && contrast > leastContrast * light;
}

const isGood = ({ agreement: { light, rest }, contrast, edge }: Fit) =>
  rest < greatestRestOfGood * light && contrast > leastContrastOfGood * light && edge > -0.3 * light;

/** Of fits to the same code, which lies better; of several things, which is more of a code. */
const quality = (fit: Fit) => fit.score / fit.agreement.light;

/** A quad's surroundings, as far as a hand moves a camera from picture to picture. */
function around(quad: Quad, { cols, rows }: { cols: number; rows: number }) {
  const size = sizeOf(quad), [x, y] = centreOf(quad), reach = 1.4 * size;
  const left = Math.max(0, Math.floor(x - reach)), top = Math.max(0, Math.floor(y - reach));
  return new cv.Rect(left, top, Math.min(cols, Math.ceil(x + reach)) - left, Math.min(rows, Math.ceil(y + reach)) - top);
}

const best = (fits: (Fit | null)[]) => fits.reduce((a, b) => !a || b && b.score > a.score ? b : a, null);

function grownBy(quad: Quad, factor: number): Quad {
  const [x, y] = centreOf(quad);
  return quad.map(p => [x + (p[0] - x) * factor, y + (p[1] - y) * factor]) as Quad;
}

/** In pixels of the picture, its first corner the code's top left one. */
function inPicture(fit: Fit, layer: Layer): Fit {
  const quad = scaled(turned(fit.quad, fit.agreement.turns), 1 / layer.factor);
  return { ...fit, quad, agreement: { ...fit.agreement, turns: 0 } };
}

/** Of each kind the best. What a part of a code looks like is worse than what the code looks like. */
function bestOfEach(fits: Fit[]): Map<string, Fit> {
  const kept: Fit[] = [];
  for (const fit of fits.sort((a, b) => quality(b) - quality(a)))
    if (kept.every(other => other.agreement.kind !== fit.agreement.kind && !isWithin(fit, other))) kept.push(fit);
  return new Map(kept.map(fit => [fit.agreement.kind, fit]));
}

const isWithin = (fit: Fit, other: Fit) =>
  distance(centreOf(fit.quad), centreOf(other.quad)) < 0.55 * Math.max(sizeOf(fit.quad), sizeOf(other.quad));

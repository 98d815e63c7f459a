import { candidatesIn } from './candidates';
import { CellLightModel, pairDeviation, whiteShare, type CellLight } from './cellLight';
import { edgesIn } from './edges';
import { areNear, cornersOf, isWithin, scaled, sizeOf, type Corners, type Quad } from './geometry';
import { inPicture, layerFor, layersOf, smooth, type Layer } from './layers';
import { brightened, coloursOf, lightOf, type Grey, type Light } from './levels';
import { Matcher } from './match';
import { cv } from './opencv';
import { clearestPart, type Placed } from './parts';
import type { Band, Pattern } from './pattern';
import { minShareOfStart, type Fit } from './refine';

/** A code in a picture. */
export interface Found extends CellLight {
  kind: string;
  /** Corners in px. The first is the top left corner of the upright code; the others follow clockwise. */
  corners: Corners;
  /** Share of the steps of light between cells that agree with the code; at most 1. */
  share: number;
  /** Whether this match is weak and a better one of its kind exists, so that it may be another object. A weak code counts only if it can be read. */
  isWeak: boolean;
  /** Share of the cells whose middle is white. */
  white: number;
}

/** Maximum side of the searched picture, px. A larger one takes longer but contains no additional codes that can be read. */
const maxSearchedSide = 1280;
/** minLight: minimum light of a code; 1 is white. minShare: minimum share of agreeing steps. */
const minLight = 0.02;
const minShare = 0.6;
/** Share of agreeing steps above which the search at a position ends. A code that is matched as the other kind reaches 0.85. */
const minShareOfCertain = 0.88;
/**
 * Limits of the share of agreeing steps for a second code of the same kind. Below minShareOfSecond it is weak; below minShareOfWeak it is ignored.
 * Other objects reach 0.74, and most of them less than 0.7. A quarter of these objects have pairs that can be read by chance.
 */
const minShareOfSecond = 0.77;
const minShareOfWeak = 0.7;
/** Like minShareOfSecond, if all found codes have the same kind. In a bright scene, one of them may be a code of the other kind. */
const minShareOfOnlyKind = 0.9;
/** Minimum light of a code in a single colour channel; 1 is white. Below it, the noise is too large relative to the light. */
const minLightOfColour = 0.04;
/** Maximum distance between the corners of two candidates that count as one, in cells. The search around a candidate covers this distance. */
const maxDistanceOfSame = 0.5;

/** Quads whose corners nearly coincide, represented by the first of them. */
interface Candidate {
  /** In px of the picture. */
  quad: Quad;
  /** Whether the quad was found in the light itself, not only in its square root. */
  isClear: boolean;
  /** Number of the quads. The edge of a code is found with many thresholds and gaps, that of another object only with a few. */
  votes: number;
}

/** Finds all codes in a picture. The result does not depend on earlier pictures. */
export class Finder {
  readonly #pattern: Pattern;
  readonly #matcher: Matcher;
  readonly #isFilled: boolean[];
  /** By kind and hidden band, because a picture needs several fits of the same model. */
  readonly #models = new Map<string, CellLightModel>();

  constructor(pattern: Pattern) {
    this.#pattern = pattern;
    this.#isFilled = Object.values(pattern.kinds).map(kind => kind.isFilled);
    this.#matcher = new Matcher(pattern);
  }

  find(grey: Grey): Found[] {
    const light = lightOf(grey);
    const picture = searched(brightened(light));
    try {
      const layers = layersOf(picture, picture.cols / grey.width, this.#matcher, this.#isFilled);
      const fits = this.#search(layers, light);
      return fits.map(fit => this.#foundAs({ ...fit, quad: exactly(fit, layers) }, isWeak(fit, fits), light, grey));
    } finally {
      picture.delete();
    }
  }

  /** Refines the candidates, and then searches for a partly hidden code. Those with the most votes come first, because most of them are codes. */
  #search(layers: Layer[], light: Light): Fit[] {
    if (layers.length === 0) return [];
    const candidates = this.#candidatesIn(layers[0]);
    const fits: Fit[] = [];
    const placed: Placed[] = [];
    const isKnown = (quad: Quad, { factor }: Layer) => fits.some(fit => isCertain(fit) && isWithin(scaled(quad, 1 / factor), fit.quad));
    for (const { quad, isClear } of [...candidates].sort((a, b) => b.votes - a.votes)) {
      const layer = layerFor(quad, layers);
      const start = scaled(quad, layer.factor);
      if (isKnown(start, layer)) continue;
      const starts = layer.refiner.startsAt(start);
      if (starts.length === 0 || starts[0].share < minShareOfStart || isKnown(starts[0].quad, layer)) continue;
      for (const guess of layer.refiner.guesses(starts)) {
        if (guess.light < minLight / 2 || isKnown(guess.quad, layer)) continue;
        const fit = layer.refiner.refine(guess);
        if (isClear) placed.push({ fit, layer });
        if (isCode(fit, layer)) fits.push(inPicture(fit, layer));
      }
    }
    const all = bestOfEach(fits);
    const clear = all.filter(code => !isWeak(code, all));
    const codes = all.filter(code => clear.includes(code) || code.share >= minShareOfWeak);
    const isComplete = this.#isFilled.every((_, kind) => clear.filter(code => code.kind === kind).length === 1);
    const part = isComplete
      ? clearestPart(
          candidates.filter(({ isClear }) => isClear).map(({ quad }) => quad),
          placed,
          clear,
          layers,
          fit => this.#deviationOf(fit, light),
        )
      : undefined;
    return part ? [...codes, part] : codes;
  }

  /**
   * Returns candidates in px of the picture: first those found in the light itself, then those found in its square root. The root amplifies the steps
   * of a weak code beside a bright one. It also amplifies dark structures, so partly hidden codes are searched for only among the candidates from the
   * light itself.
   */
  #candidatesIn({ picture, factor }: Layer): Candidate[] {
    const { ofLight, ofRoot } = edgesIn(picture);
    const candidates: Candidate[] = [];
    for (const isClear of [true, false])
      for (const quad of candidatesIn(isClear ? ofLight : ofRoot)) {
        const near = (maxDistanceOfSame * sizeOf(quad)) / this.#pattern.side;
        const same = candidates.find(candidate => isSame(quad, candidate.quad, near));
        if (same) same.votes++;
        else candidates.push({ quad, isClear, votes: 1 });
      }
    return candidates.map(candidate => ({ ...candidate, quad: scaled(candidate.quad, 1 / factor) }));
  }

  #deviationOf({ kind, quad, hidden }: Fit, light: Light): number {
    const seen = this.#pattern.kinds[this.#matcher.kinds[kind]];
    return pairDeviation(this.#modelOf(kind, hidden).fit(light, quad).levels, this.#pattern, seen, hidden!);
  }

  #foundAs({ kind, quad, share }: Fit, isWeak: boolean, light: Light, grey: Grey): Found {
    return { kind: this.#matcher.kinds[kind], corners: cornersOf(quad), share, isWeak, ...this.#cellsIn(light, grey, quad, kind) };
  }

  #modelOf(kind: number, hidden?: Band): CellLightModel {
    const key = `${kind} ${hidden}`;
    let model = this.#models.get(key);
    if (!model) {
      model = new CellLightModel(this.#pattern, this.#pattern.kinds[this.#matcher.kinds[kind]], hidden);
      this.#models.set(key, model);
    }
    return model;
  }

  /**
   * Measures the cells in the brightest channel of each pixel. If cells are clipped, uses the single channel with the fewest clipped cells among
   * those that show the code.
   */
  #cellsIn(light: Light, grey: Grey, quad: Quad, kind: number): CellLight & Pick<Found, 'white'> {
    const { pairs, side } = this.#pattern;
    const cellsIn = (seen: Light) => ({ white: whiteShare(seen, quad, side), ...this.#modelOf(kind).fit(seen, quad) });
    let best = cellsIn(light);
    if (best.white === 0) return best;
    for (const colour of coloursOf(grey)) {
      const cells = cellsIn(colour);
      const isSeen = pairs.every(left => cells.levels[left] + cells.levels[left + 1] >= minLightOfColour);
      if (isSeen && cells.white < best.white) best = cells;
    }
    return best;
  }
}

type Mat = InstanceType<typeof cv.Mat>;

function searched({ width, height, data }: Light): Mat {
  const picture = new cv.Mat(height, width, cv.CV_32FC1);
  const factor = maxSearchedSide / Math.max(width, height);
  picture.data32F.set(data);
  if (factor < 1) cv.resize(picture, picture, new cv.Size(Math.round(width * factor), Math.round(height * factor)), 0, 0, cv.INTER_AREA);
  smooth(picture);
  return picture;
}

/**
 * Returns the quad of a code after a last refinement. The search ends at the first certain fit, which can be off by a tenth of a cell. The share of
 * agreeing steps is not computed again, because its limits apply to the fits of the search.
 */
function exactly(fit: Fit, layers: Layer[]): Quad {
  const layer = layerFor(fit.quad, layers);
  return inPicture(layer.refiner.refineExactly({ ...fit, quad: scaled(fit.quad, layer.factor) }), layer).quad;
}

/** Returns whether a fit is strong and unambiguous enough to be a code. */
const isCode = (fit: Fit, layer: Layer) => fit.light >= minLight && fit.share >= minShare && layer.refiner.isClear(fit);

const isCertain = ({ share }: Fit) => share >= minShareOfCertain;

/** Returns whether a fit may be another object or a code of the other kind. `codes` contains all fits in decreasing order of agreement. */
function isWeak(fit: Fit, codes: Fit[]): boolean {
  const isOnlyKind = codes.every(({ kind }) => kind === fit.kind);
  return fit !== codes.find(({ kind }) => kind === fit.kind) && fit.share < (isOnlyKind ? minShareOfOnlyKind : minShareOfSecond);
}

/** Keeps the best fit at each position. A fit to a part of a code agrees less than a fit to the whole code. */
function bestOfEach(fits: Fit[]): Fit[] {
  const kept: Fit[] = [];
  for (const fit of fits.sort((a, b) => b.share - a.share)) if (!kept.some(other => isWithin(fit.quad, other.quad))) kept.push(fit);
  return kept;
}

/** Returns whether the corners of two quads nearly coincide, regardless of the corner with which they start. */
const isSame = (quad: Quad, other: Quad, near: number) =>
  areNear(quad, other, near, 0) || areNear(quad, other, near, 1) || areNear(quad, other, near, 2) || areNear(quad, other, near, 3);

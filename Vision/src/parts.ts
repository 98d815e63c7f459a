import { extendedBy, isPlausible, isWithin, scaled, sideOf, type Quad } from './geometry';
import { inPicture, layerFor, type Layer } from './layers';
import { Band, bands, isHalf } from './pattern';
import type { Fit } from './refine';

/** A fit with its layer. Its coordinates are in px of the layer. */
export interface Placed {
  fit: Fit;
  layer: Layer;
}

/**
 * Minimum scores of the visible part of a code without a third and without a half of it. The score is the share of agreeing steps minus the mean
 * deviation of the visible pairs from one lit and one dark cell. In 198 rendered pictures, most codes had 0.8 or more. Perforated plates had at most
 * 0.68 and 0.75, and other objects at most 0.72.
 */
const minScore = 0.73;
const minScoreOfHalf = 0.77;
/** Minimum share of agreeing steps before the last refinement. */
const minShareOnTheWay = 0.6;
/** Minimum agreement of a visible outer edge. */
const minShareOfEdge = 0.3;

/** Range of the ratio of a candidate's longer to its shorter side at which it can be the visible part of a code, of which up to a half is hidden. */
const minRatio = 1.06;
const maxRatio = 2.3;
/** Minimum ratio at which more than a third of a code is hidden. */
const minRatioOfHalf = 1.45;

/**
 * Finds the best match of a code of which up to a half is covered or outside the picture. The visible part of a code agrees almost
 * completely, because its pairs and its ring are redundant. Structured scenes have no such redundancy.
 *
 * @param candidates Quads in px of the picture. The quad of a partly hidden code contains only the visible part.
 * @param fits Fits of whole quads, regardless of their agreement.
 * @param known Whole codes. Their positions are not searched.
 * @param deviationOf Returns the mean deviation of the visible pairs.
 */
export function clearestPart(candidates: Quad[], fits: Placed[], known: Fit[], layers: Layer[], deviationOf: (fit: Fit) => number): Fit | undefined {
  const isKnown = (quad: Quad, { factor }: Layer) => known.some(code => isWithin(scaled(quad, 1 / factor), code.quad));
  const parts = [...fits, ...candidates.flatMap(quad => partsAt(quad, layers, isKnown))]
    .filter(({ fit, layer }) => !isKnown(fit.quad, layer))
    .flatMap(({ fit, layer }) =>
      (fit.hidden === undefined ? bands : [fit.hidden])
        .map(band => layer.refiner.without(fit, band))
        .filter(({ share }) => share >= minShareOnTheWay)
        .map(part => inPicture(layer.refiner.refineLast(part), layer)),
    );
  const surplusOf = ({ share, hidden }: Fit) => share - (isHalf(hidden!) ? minScoreOfHalf : minScore);
  let best: { part: Fit; surplus: number } | undefined;
  for (const part of parts.sort((a, b) => surplusOf(b) - surplusOf(a))) {
    // A deviation only lowers the score, so the remaining parts cannot be better.
    if (surplusOf(part) < (best?.surplus ?? 0)) break;
    const surplus = surplusOf(part) - deviationOf(part);
    if (surplus >= 0 && !(best && best.surplus >= surplus)) best = { part, surplus };
  }
  return best?.part;
}

/** Extends a candidate that is too short in one direction to a square, on one side or the other, and refines both results without the added part. */
function partsAt(candidate: Quad, layers: Layer[], isKnown: (quad: Quad, layer: Layer) => boolean): Placed[] {
  const [top, right, bottom, left] = [0, 1, 2, 3].map(side => sideOf(candidate, side));
  const ratio = (left + right) / (top + bottom);
  const by = Math.max(ratio, 1 / ratio);
  if (by < minRatio || by > maxRatio) return [];
  return (ratio < 1 ? [Band.Top, Band.Bottom] : [Band.Right, Band.Left]).flatMap(side => {
    const hidden = by < minRatioOfHalf ? side : side + Band.TopHalf;
    const found = extendedBy(candidate, side, by);
    const layer = layerFor(found, layers);
    const quad = scaled(found, layer.factor);
    if (!isPlausible(quad, 1) || isKnown(quad, layer)) return [];
    return layer.refiner
      .guesses(layer.refiner.startsAt(quad, hidden).filter(({ share }) => share >= minShareOfEdge))
      .map(guess => ({ fit: layer.refiner.refine(guess), layer }));
  });
}

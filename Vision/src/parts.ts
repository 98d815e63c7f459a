import { distance, extendedBy, isPlausible, isWithin, scaled, type Quad } from './geometry';
import { inPicture, layerFor, type Layer } from './layers';
import { Band } from './pattern';
import type { Fit } from './refine';

/** A fit with its layer. Its coordinates are in px of the layer. */
export interface Placed {
  fit: Fit;
  layer: Layer;
}

/** Minimum share of agreeing steps in the visible part of a code. Codes have at least 0.85; perforated plates and letters reach 0.86. */
const minShareOfPart = 0.84;
/** Maximum mean deviation of the visible pairs from one lit and one dark cell. Codes have at most 0.3, most perforated plates have more. */
const maxDeviation = 0.3;
/** Minimum share of agreeing steps before the last refinement. */
const minShareOnTheWay = 0.6;
/** Minimum agreement of a visible outer edge. */
const minShareOfEdge = 0.3;

/** Range of the ratio of a candidate's longer to its shorter side at which it can be the visible part of a code, of which up to a third is hidden. */
const minRatio = 1.06;
const maxRatio = 1.7;

/**
 * Finds the best match of a code of which up to a third is covered or outside the picture. The visible part of a code agrees almost
 * completely, because its pairs and its ring are redundant. Structured scenes have no such redundancy.
 *
 * @param candidates Quads in px of the picture. The quad of a partly hidden code contains only the visible part.
 * @param fits Fits of whole quads, regardless of their agreement.
 * @param known Whole codes. Their positions are not searched.
 * @param deviationOf Returns the mean deviation of the visible pairs.
 */
export function clearestPart(candidates: Quad[], fits: Placed[], known: Fit[], layers: Layer[], deviationOf: (fit: Fit) => number): Fit | undefined {
  const isKnown = (quad: Quad, { factor }: Layer) => known.some(code => isWithin(scaled(quad, 1 / factor), code.quad));
  const isPart = (fit: Fit) => fit.share >= minShareOfPart && deviationOf(fit) <= maxDeviation;
  const parts = [...fits, ...candidates.flatMap(quad => partsAt(quad, layers, isKnown))]
    .filter(({ fit, layer }) => !isKnown(fit.quad, layer))
    .flatMap(({ fit, layer }) =>
      (fit.hidden === undefined ? bands : [fit.hidden])
        .map(band => layer.refiner.without(fit, band))
        .filter(({ share }) => share >= minShareOnTheWay)
        .map(part => inPicture(layer.refiner.refineLast(part), layer)),
    );
  return parts.sort((a, b) => b.share - a.share).find(isPart);
}

const bands = [Band.Top, Band.Right, Band.Bottom, Band.Left, Band.Columns, Band.Rows];

/** Extends a candidate that is too short in one direction to a square, on one side or the other, and refines both results without the added part. */
function partsAt(candidate: Quad, layers: Layer[], isKnown: (quad: Quad, layer: Layer) => boolean): Placed[] {
  const [top, right, bottom, left] = candidate.map((p, i) => distance(p, candidate[(i + 1) & 3]));
  const ratio = (left + right) / (top + bottom);
  const by = Math.max(ratio, 1 / ratio);
  if (by < minRatio || by > maxRatio) return [];
  return (ratio < 1 ? [Band.Top, Band.Bottom] : [Band.Right, Band.Left]).flatMap(side => {
    const found = extendedBy(candidate, side, by);
    const layer = layerFor(found, layers);
    const quad = scaled(found, layer.factor);
    if (!isPlausible(quad, 1) || isKnown(quad, layer)) return [];
    return layer.refiner
      .guesses(layer.refiner.startsAt(quad, side).filter(({ share }) => share >= minShareOfEdge))
      .map(guess => ({ fit: layer.refiner.refine(guess), layer }));
  });
}

import { coefficients, setHomography, type Quad } from './geometry';
import { Equations, leastAbsolute } from './leastAbsolute';
import { sampleLight, type Light } from './levels';
import { type Band, Cell, cellAt, eachEdge, isWithinBand, type Kind, type Pattern } from './pattern';

/** Number of samples along one side of a cell. */
const samples = 8;
/** Sample positions in filled cells: distances from the edge between two cells, on both sides, and positions along the edge. */
const filled = { across: [1, 2], along: [1, 2, 3, 4, 5, 6] };
/** Sample positions in LEDs, which leave gaps between them. */
const dots = { across: [4], along: [3, 4] };

/** Light of the cells of a code. */
export interface CellLight {
  /** Light of each cell without the scene behind it, row by row; 1 is white. */
  levels: number[];
  /** 90th percentile of the residuals of the light model, relative to the light of a lit cell. */
  residual: number;
}

/**
 * Model of the light of the cells of a code and of the scene behind it.
 *
 * Along the whole edge between two adjacent cells, the light changes by the difference between the cells. An edge of the scene crosses this
 * edge and affects only a few samples. The model of the light is therefore the sum of the light of the cells and of a scene that is quadratic in
 * the position. The model is fitted with the minimum sum of absolute residuals, so a few outliers have no effect, however bright they are.
 */
export class CellLightModel {
  /** Index of the unknown of each cell; null for a dark cell. Unknowns: light of the ring, light of the cells of pairs, five coefficients of the scene. */
  readonly #unknowns: (number | null)[];
  readonly #equations: Equations;
  /** Positions of the samples of each equation: pairs of points after and before the edge between the cells. */
  readonly #points: Float64Array;
  /** Number of pairs of samples of an equation. */
  readonly #pairs: number;

  /** @param hidden Band of the code that is ignored. */
  constructor(pattern: Pattern, kind: Kind, hidden?: Band) {
    const { side } = pattern;
    const cell = cellAt(pattern, kind);
    const ofPairs = new Map<number, number>(pattern.pairs.flatMap(left => [left, left + 1]).map((each, i) => [each, 1 + i]));
    const unknownAt = (row: number, column: number) =>
      cell(row, column) > Cell.Lit ? ofPairs.get(row * side + column)! : cell(row, column) === Cell.Lit ? 0 : null;
    this.#unknowns = Array.from({ length: side * side }, (_, i) => unknownAt(Math.floor(i / side), i % side));
    const slope = 1 + ofPairs.size;
    this.#equations = new Equations(slope + 5);
    const { across, along } = kind.isFilled ? filled : dots;
    const apart = (2 * across.reduce((a, b) => a + b)) / across.length / samples / side;
    const at = (sample: number) => (sample + 0.5) / samples / side;
    const points: number[] = [];
    eachEdge(side, (row, column, nextRow, nextColumn) => {
      if (hidden !== undefined && isWithinBand(hidden, (column + nextColumn + 1) / 2 / side, (row + nextRow + 1) / 2 / side)) return;
      const isBeside = row === nextRow;
      const before = unknownAt(row, column);
      const after = unknownAt(nextRow, nextColumn);
      const edge = (isBeside ? nextColumn : nextRow) * samples;
      const start = (isBeside ? row : column) * samples;
      for (const sample of along) {
        const place = at(start + sample);
        for (const by of across) for (const to of [by - 1, -by]) points.push(...(isBeside ? [at(edge + to), place] : [place, at(edge + to)]));
        const onEdge = edge / samples / side - 0.5;
        const beside = place - 0.5;
        if (before !== after && after !== null) this.#equations.term(after, 1);
        if (before !== after && before !== null) this.#equations.term(before, -1);
        // Difference of the scene across the edge between the cells. The scene is modelled as b x + c y + d x² + e xy + f y².
        this.#equations.term(isBeside ? slope : slope + 1, apart);
        this.#equations.term(isBeside ? slope + 2 : slope + 4, 2 * onEdge * apart);
        this.#equations.term(slope + 3, beside * apart);
        this.#equations.end();
      }
    });
    this.#points = Float64Array.from(points);
    this.#pairs = across.length;
  }

  /** Estimates the light of each cell without the scene behind it. */
  fit(picture: Light, quad: Quad): CellLight {
    const light = lightAt(picture, quad, this.#points);
    const differences = new Float64Array(this.#equations.count);
    for (let i = 0; i < light.length; i += 2) differences[Math.floor(i / 2 / this.#pairs)] += (light[i] - light[i + 1]) / this.#pairs;
    const { found, residuals } = leastAbsolute(this.#equations, differences);
    const levels = this.#unknowns.map(unknown => (unknown === null ? 0 : found[unknown]));
    const [ofRing] = found;
    return { levels, residual: ofRing > 0 ? residuals.sort()[Math.floor(0.9 * residuals.length)] / ofRing : 1 };
  }
}

/**
 * Returns the mean deviation of the visible pairs from one lit and one dark cell, relative to the light of a lit cell and at most 1 per pair. A
 * pair that changed during the exposure does not deviate, because its cells together have the light of one lit cell.
 */
export function pairDeviation(levels: number[], { side, pairs, ring }: Pattern, { lit }: Kind, hidden: Band): number {
  const isVisible = (cell: number) => !isWithinBand(hidden, ((cell % side) + 0.5) / side, (Math.floor(cell / side) + 0.5) / side);
  const light = levels[ring.find((_, i) => lit[i])!];
  if (!(light > 0)) return 1;
  const deviations = pairs
    .filter(left => isVisible(left) && isVisible(left + 1))
    .map(left => {
      const [a, b] = [levels[left] / light, levels[left + 1] / light];
      return Math.min(1, Math.max(Math.abs(a + b - 1) / 2, -Math.min(a, b), Math.max(a, b) - 1));
    });
  return deviations.reduce((a, b) => a + b) / deviations.length;
}

/** Minimum light at which a pixel counts as white. It corresponds to the byte value 252. */
const white = 0.97;

/** Returns the share of cells whose middle is white. Such cells are overexposed, and their light cannot be measured. */
export function whiteShare(picture: Light, quad: Quad, side: number): number {
  const middles = Array.from({ length: side * side }, (_, cell) => [(cell % side) + 0.5, Math.floor(cell / side) + 0.5]);
  const lights = lightAt(
    picture,
    quad,
    Float64Array.from(middles.flat(), at => at / side),
  );
  return lights.filter(light => light >= white).length / lights.length;
}

/** @param points u and v of each point, one after another. */
function lightAt(picture: Light, quad: Quad, points: Float64Array): Float64Array {
  const seen = new Float64Array(coefficients);
  setHomography(quad, seen);
  const light = new Float64Array(points.length / 2);
  sampleLight(picture, seen, points, light, 0, light.length);
  return light;
}

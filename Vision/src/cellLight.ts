import { homography, type Quad } from './geometry';
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
 * Estimates the light of each cell without the scene behind it.
 *
 * Along the whole edge between two adjacent cells, the light changes by the difference between the cells. An edge of the scene crosses this
 * edge and affects only a few samples. The model of the light is therefore the sum of the light of the cells and of a scene that is quadratic in
 * the position. The model is fitted with the minimum sum of absolute residuals, so a few outliers have no effect, however bright they are.
 *
 * @param hidden Band of the code that is ignored.
 */
export function cellLight(picture: Light, quad: Quad, pattern: Pattern, kind: Kind, hidden?: Band): CellLight {
  const { side } = pattern;
  const cell = cellAt(pattern, kind);
  // Order of the unknowns: light of the ring, light of the cells of pairs, five coefficients of the scene.
  const unknowns = new Map<number, number>(pattern.pairs.flatMap(left => [left, left + 1]).map((each, i) => [each, 1 + i]));
  const slope = 1 + unknowns.size;
  const count = slope + 5;
  const unknownAt = (row: number, column: number) =>
    cell(row, column) > Cell.Lit ? unknowns.get(row * side + column)! : cell(row, column) === Cell.Lit ? 0 : null;
  const equations = new Equations();
  const { across, along } = kind.isFilled ? filled : dots;
  const sampled = samplesOf(picture, quad, side);
  const apart = (2 * across.reduce((a, b) => a + b)) / across.length / samples / side;
  eachEdge(side, (row, column, nextRow, nextColumn) => {
    if (hidden !== undefined && isWithinBand(hidden, (column + nextColumn + 1) / 2 / side, (row + nextRow + 1) / 2 / side)) return;
    const isBeside = row === nextRow;
    const before = unknownAt(row, column);
    const after = unknownAt(nextRow, nextColumn);
    const edge = (isBeside ? nextColumn : nextRow) * samples;
    const start = (isBeside ? row : column) * samples;
    for (const at of along) {
      const sample = (to: number) => (isBeside ? sampled(start + at, edge + to) : sampled(edge + to, start + at));
      const difference = across.reduce((sum, by) => sum + sample(by - 1) - sample(-by), 0) / across.length;
      if (Number.isNaN(difference)) continue;
      const onEdge = edge / samples / side - 0.5;
      const beside = (start + at + 0.5) / samples / side - 0.5;
      if (before !== after && after !== null) equations.term(after, 1);
      if (before !== after && before !== null) equations.term(before, -1);
      // Difference of the scene across the edge between the cells. The scene is modelled as b x + c y + d x² + e xy + f y².
      equations.term(isBeside ? slope : slope + 1, apart);
      equations.term(isBeside ? slope + 2 : slope + 4, 2 * onEdge * apart);
      equations.term(slope + 3, beside * apart);
      equations.end(difference);
    }
  });
  const { found, residuals } = leastAbsolute(equations, count);
  const levels = Array.from({ length: side * side }, (_, i) => {
    const unknown = unknownAt(Math.floor(i / side), i % side);
    return unknown === null ? 0 : found[unknown];
  });
  const [light] = found;
  return { levels, residual: light > 0 ? residuals.sort()[Math.floor(0.9 * residuals.length)] / light : 1 };
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
  const middles = gridLight(picture, quad, side, i => (i + 0.5) / side);
  return middles.filter(light => light >= white).length / middles.length;
}

/** Samples the light along the rows and columns of a code, from one cell outside the code to one cell outside on the other side. */
function samplesOf(picture: Light, quad: Quad, side: number): (row: number, column: number) => number {
  const length = (side + 2) * samples;
  const light = new Float32Array(gridLight(picture, quad, length, sample => ((sample + 0.5) / samples - 1) / side));
  return (row, column) => light[(row + samples) * length + column + samples];
}

/** Samples the light on a square grid. `along` returns the position of a row or column by its index, relative to the side of the code. */
function gridLight(picture: Light, quad: Quad, length: number, along: (index: number) => number): Float64Array {
  const points = new Float64Array(2 * length * length);
  for (let row = 0, i = 0; row < length; row++)
    for (let column = 0; column < length; column++, i += 2) [points[i], points[i + 1]] = [along(column), along(row)];
  const light = new Float64Array(length * length);
  sampleLight(picture, homography(quad), points, light, 0, light.length);
  return light;
}

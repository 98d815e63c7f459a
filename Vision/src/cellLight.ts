import { homography, type Quad } from './geometry';
import { Equations, leastAbsolute } from './leastAbsolute';
import { lightThrough, type Light } from './levels';
import { type Band, Cell, cellAt, eachEdge, isWithinBand, type Kind, type Pattern } from './pattern';

/** Samples along one side of a cell. */
const samples = 8;
/** Samples of filled cells: their distances from the edge between two cells, on either side, and their positions along it. */
const filled = { across: [1, 2], along: [1, 2, 3, 4, 5, 6] };
/** Samples of LEDs, which leave gaps. */
const dots = { across: [4], along: [3, 4] };

/**
 * Estimates the light of each cell without the scene behind it; 1 is white.
 *
 * Between adjacent cells, light steps by their difference along the whole edge. An edge of the scene crosses it and affects few samples.
 * The model of the steps is therefore the cells' light plus a quadratic scene, fitted with the minimum sum of absolute residuals:
 * outliers in few samples do not count, however bright they are.
 */
export function cellLight(picture: Light, quad: Quad, pattern: Pattern, kind: Kind): number[] {
  const { side } = pattern;
  const cell = cellAt(pattern, kind);
  // Order of the unknowns: the code's light, the light of the cells of pairs, the five coefficients of the scene.
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
      // Difference of the scene's b x + c y + d x² + e xy + f y² across the edge.
      equations.term(isBeside ? slope : slope + 1, apart);
      equations.term(isBeside ? slope + 2 : slope + 4, 2 * onEdge * apart);
      equations.term(slope + 3, beside * apart);
      equations.end(difference);
    }
  });
  const found = leastAbsolute(equations, count);
  return Array.from({ length: side * side }, (_, i) => {
    const unknown = unknownAt(Math.floor(i / side), i % side);
    return unknown === null ? 0 : found[unknown];
  });
}

/**
 * Returns the mean deviation of the visible pairs from a lit and a dark cell, relative to the light of a lit cell and at most 1 for each
 * pair. A pair that changed during the exposure does not deviate: its light is that of one lit cell, divided between both.
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

/** Minimum light of a white pixel: byte 252. */
const white = 0.97;

/** Returns the share of a code's cells that are white in their middle: an overexposed cell has lost its light. */
export function whiteShare(picture: Light, quad: Quad, side: number): number {
  const seen = homography(quad);
  const middles = Array.from({ length: side * side }, (_, i) =>
    lightThrough(picture, seen, ((i % side) + 0.5) / side, (Math.floor(i / side) + 0.5) / side),
  );
  return middles.filter(light => light >= white).length / middles.length;
}

/** Samples light along the code's rows and columns, from one cell before the code to one behind it. */
function samplesOf(picture: Light, quad: Quad, side: number): (row: number, column: number) => number {
  const seen = homography(quad);
  const length = (side + 2) * samples;
  const light = new Float32Array(length * length);
  const along = (sample: number) => ((sample + 0.5) / samples - 1) / side;
  for (let row = 0, i = 0; row < length; row++)
    for (let column = 0; column < length; column++, i++) light[i] = lightThrough(picture, seen, along(column), along(row));
  return (row, column) => light[(row + samples) * length + column + samples];
}

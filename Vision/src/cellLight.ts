import { homography, type Quad } from './geometry';
import { lightAt, type Light } from './levels';
import { cv } from './opencv';
import { Cell, cellAt, eachEdge, type Kind, type Pattern } from './pattern';

type Mat = InstanceType<typeof cv.Mat>;

/** Samples along one side of a cell. */
const samples = 8;
/** Where filled cells are looked at: in these samples from an edge between two, on either side, and in these along it. */
const filled = { across: [1, 2], along: [1, 2, 3, 4, 5, 6] };
/** And where LEDs are, which leave gaps. */
const dots = { across: [4], along: [3, 4] };

const rounds = 15;
/** What is off by no more than this, in medians of what all are off by, is noise. */
const noise = 1.5;
/** Holds the light of a cell of which nothing is seen; too little to be noticed in others. */
const held = 1e-6;

/** A difference of light as the sum of unknowns times factors. */
interface Equation {
  difference: number;
  terms: [unknown: number, factor: number][];
}

/**
 * The light of each cell without the scene behind it, 1 is white.
 *
 * Where cells touch, light steps by the difference of both, along all of their edge; an edge of the scene crosses it, and is seen by few
 * samples. So the steps are explained by the cells' light and a scene that bends like a parabola, with the least sum of absolute rests:
 * what few samples see does not count, however bright it is.
 */
export function cellLight(picture: Light, quad: Quad, pattern: Pattern, kind: Kind): number[] {
  const { side } = pattern, cell = cellAt(pattern, kind);
  // The code's light first, then that of the cells of pairs, then the scene's slope.
  const unknowns = new Map<number, number>(pattern.pairs.flatMap(left => [left, left + 1]).map((each, i) => [each, 1 + i]));
  const slope = 1 + unknowns.size, count = slope + 5;
  const unknownAt = (row: number, column: number) =>
    cell(row, column) > Cell.Lit ? unknowns.get(row * side + column)! : cell(row, column) === Cell.Lit ? 0 : null;
  const equations: Equation[] = [], { across, along } = kind.isFilled ? filled : dots, sampled = samplesOf(picture, quad, side);
  const apart = (2 * across.reduce((a, b) => a + b) / across.length) / samples / side;
  eachEdge(side, (row, column, nextRow, nextColumn) => {
    const isBeside = row === nextRow, before = unknownAt(row, column), after = unknownAt(nextRow, nextColumn);
    const cells: Equation['terms'] = before === after ? [] : [[after, 1], [before, -1]].filter(([unknown]) => unknown !== null) as Equation['terms'];
    const edge = (isBeside ? nextColumn : nextRow) * samples, start = (isBeside ? row : column) * samples;
    for (const at of along) {
      const sample = (to: number) => isBeside ? sampled(start + at, edge + to) : sampled(edge + to, start + at);
      const difference = across.reduce((sum, by) => sum + sample(by - 1) - sample(-by), 0) / across.length;
      if (Number.isNaN(difference)) continue;
      const onEdge = edge / samples / side - 0.5, beside = (start + at + 0.5) / samples / side - 0.5;
      // Of b x + c y + d x² + e xy + f y².
      const scene: Equation['terms'] = isBeside
        ? [[slope, apart], [slope + 2, 2 * onEdge * apart], [slope + 3, beside * apart]]
        : [[slope + 1, apart], [slope + 3, beside * apart], [slope + 4, 2 * onEdge * apart]];
      equations.push({ difference, terms: [...cells, ...scene] });
    }
  });
  const found = leastAbsolute(equations, count);
  return Array.from({ length: side * side }, (_, i) => {
    const unknown = unknownAt(Math.floor(i / side), i % side);
    return unknown === null ? 0 : found[unknown];
  });
}

/** Light in the code's own rows and columns of samples, from one cell before it to one behind it. */
function samplesOf(picture: Light, quad: Quad, side: number): (row: number, column: number) => number {
  const [a, b, c, d, e, f, g, h] = homography(quad), length = (side + 2) * samples, light = new Float32Array(length * length);
  for (let row = 0, i = 0; row < length; row++)
    for (let column = 0; column < length; column++, i++) {
      const u = ((column + 0.5) / samples - 1) / side, v = ((row + 0.5) / samples - 1) / side, w = 1 / (g * u + h * v + 1);
      light[i] = lightAt(picture, (a * u + b * v + c) * w, (d * u + e * v + f) * w);
    }
  return (row, column) => light[(row + samples) * length + column + samples];
}

/** Unknowns with the least sum of absolute rests, by least squares in which each counts the less the farther off it was. */
function leastAbsolute(equations: Equation[], count: number): Float64Array {
  const normal = new cv.Mat(count, count, cv.CV_64FC1), right = new cv.Mat(count, 1, cv.CV_64FC1), found = new cv.Mat(count, 1, cv.CV_64FC1);
  try {
    let weights = equations.map(() => 1);
    for (let round = 0; round < rounds; round++) {
      setNormal(equations, weights, count, normal, right);
      cv.solve(normal, right, found, cv.DECOMP_CHOLESKY);
      const values = found.data64F;
      const rests = equations.map(({ difference, terms }) => Math.abs(terms.reduce((rest, [unknown, factor]) => rest - factor * values[unknown], difference)));
      const least = Math.max(held, noise * Float64Array.from(rests).sort()[rests.length >> 1]);
      weights = rests.map(rest => 1 / Math.max(rest, least));
    }
    return found.data64F.slice();
  } finally {
    for (const made of [normal, right, found]) made.delete();
  }
}

function setNormal(equations: Equation[], weights: number[], count: number, normal: Mat, right: Mat): void {
  const squares = normal.data64F.fill(0), products = right.data64F.fill(0);
  for (let i = 0; i < count; i++) squares[i * count + i] = held;
  equations.forEach(({ difference, terms }, i) => {
    for (const [unknown, factor] of terms) {
      products[unknown] += weights[i] * factor * difference;
      for (const [other, by] of terms) squares[unknown * count + other] += weights[i] * factor * by;
    }
  });
}

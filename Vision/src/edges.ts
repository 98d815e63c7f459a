import type { Light } from './levels';
import { cv } from './opencv';

type Mat = InstanceType<typeof cv.Mat>;

/** Size of the blocks in which edges are detected, px. Smaller blocks are not needed. */
const block = 4;

/** Steps of light at edges in blocks of a picture, row by row; 255 is white. */
export interface Edges {
  columns: number;
  rows: number;
  steps: Uint8Array;
  /** Size of the blocks, px. */
  block: number;
}

/** Values of the light and of its square root are in one number: the root in the upper 16 bits. */
const rootBits = 16;

/**
 * Returns the mean difference between the brightest and the darkest of 3×3 adjacent pixels for each block: of the light, and of its square root; 255 is
 * white. The root amplifies the steps of a weak code beside a bright one.
 */
export function edgesIn({ width, height, data }: Light): { ofLight: Edges; ofRoot: Edges } {
  const [columns, rows] = [Math.floor(width / block), Math.floor(height / block)];
  const sums = new Int32Array(columns * rows);
  let [above, at, below] = [0, 0, 0].map(() => new Int32Array(width));
  setValues(data, 0, at);
  setValues(data, 0, below);
  for (let row = 0; row < rows * block; row++) {
    [above, at, below] = [at, below, above];
    setValues(data, Math.min(row + 1, height - 1) * width, below);
    addSteps(above, at, below, sums, Math.floor(row / block) * columns, columns);
  }
  const edges = (shift: number): Edges => ({ columns, rows, steps: meanOf(sums, shift), block });
  return { ofLight: edges(0), ofRoot: edges(rootBits) };
}

/** Converts a row of the picture. A pixel that is not darker than another one is so in its root, too, so one comparison of numbers compares both. */
function setValues(light: Float32Array, start: number, values: Int32Array): void {
  for (let i = 0; i < values.length; i++) {
    const value = Math.min(1, light[start + i]);
    values[i] = ((255 * Math.sqrt(value) + 0.5) << rootBits) | (255 * value + 0.5);
  }
}

// Without branches, which take three times as long because the processor cannot predict them. Math.max and Math.min have one each.
const max = (a: number, b: number) => a - ((a - b) & ((a - b) >> 31));
const min = (a: number, b: number) => b + ((a - b) & ((a - b) >> 31));

/** Adds the steps at the pixels of a row to those of their blocks. Above and below it are the adjacent rows. */
function addSteps(above: Int32Array, at: Int32Array, below: Int32Array, sums: Int32Array, first: number, columns: number): void {
  const last = at.length - 1;
  let most = max(max(above[0], at[0]), below[0]);
  let least = min(min(above[0], at[0]), below[0]);
  let [mostBefore, leastBefore] = [most, least];
  for (let column = 0, next = 1; column < columns; column++) {
    let sum = 0;
    for (let i = 0; i < block; i++, next++) {
      const right = next > last ? last : next;
      const mostAfter = max(max(above[right], at[right]), below[right]);
      const leastAfter = min(min(above[right], at[right]), below[right]);
      sum += max(max(mostBefore, most), mostAfter) - min(min(leastBefore, least), leastAfter);
      mostBefore = most;
      leastBefore = least;
      most = mostAfter;
      least = leastAfter;
    }
    sums[first + column] += sum;
  }
}

function meanOf(sums: Int32Array, shift: number): Uint8Array {
  const mean = new Uint8Array(sums.length);
  for (let i = 0; i < mean.length; i++) mean[i] = ((sums[i] >> shift) & 0xffff) / block / block + 0.5;
  return mean;
}

/** Returns edges in blocks of twice the size. Each has the largest step of its four blocks. */
export function coarser({ columns, rows, steps, block: size }: Edges): Edges {
  const [half, halfRows] = [columns >> 1, rows >> 1];
  const largest = new Uint8Array(half * halfRows);
  for (let i = 0; i < largest.length; i++) {
    const at = 2 * (Math.floor(i / half) * columns + (i % half));
    largest[i] = Math.max(steps[at], steps[at + 1], steps[at + columns], steps[at + columns + 1]);
  }
  return { columns: half, rows: halfRows, steps: largest, block: 2 * size };
}

/** Returns the edges as a matrix. The caller must delete it. */
export function matrixOf({ columns, rows, steps }: Edges): Mat {
  const matrix = new cv.Mat(rows, columns, cv.CV_8UC1);
  matrix.data.set(steps);
  return matrix;
}

import { medianOf } from './median';

const rounds = 15;
/** Multiple of the median residual up to which residuals count as noise and have equal weights. */
const noise = 1.5;
/** Regularisation for unknowns without a measurement. Small enough not to affect the others. */
const held = 1e-6;

/** Left sides of linear equations: each is a sum of unknowns times factors. Stored in flat arrays, because there are hundreds. */
export class Equations {
  /** Number of unknowns. */
  readonly unknowns: number;
  /** Index of the first term of each equation. */
  readonly #starts: number[] = [0];
  readonly #terms: number[] = [];
  readonly #factors: number[] = [];

  constructor(unknowns: number) {
    this.unknowns = unknowns;
  }

  get count(): number {
    return this.#starts.length - 1;
  }

  /** Adds a term to the current equation, which the next call of `end` completes. */
  term(unknown: number, factor: number): void {
    this.#terms.push(unknown);
    this.#factors.push(factor);
  }

  end(): void {
    this.#starts.push(this.#terms.length);
  }

  /** Returns the left side of an equation. */
  valueOf(equation: number, values: Float64Array): number {
    let value = 0;
    for (let at = this.#starts[equation]; at < this.#starts[equation + 1]; at++) value += this.#factors[at] * values[this.#terms[at]];
    return value;
  }

  /** Adds an equation with a weight to the normal equations: to AᵀWy and to the lower triangle of AᵀWA. */
  addTo(squares: Float64Array, products: Float64Array, equation: number, weight: number, measured: number): void {
    const [start, end] = [this.#starts[equation], this.#starts[equation + 1]];
    for (let at = start; at < end; at++) {
      const unknown = this.#terms[at];
      const weighted = weight * this.#factors[at];
      products[unknown] += weighted * measured;
      for (let by = start; by < end; by++)
        if (this.#terms[by] <= unknown) squares[unknown * this.unknowns + this.#terms[by]] += weighted * this.#factors[by];
    }
  }
}

/**
 * Finds the unknowns that minimise the sum of absolute residuals, by iteratively reweighted least squares. Also returns these residuals.
 * @param measured Right side of each equation. Equations with NaN are ignored.
 */
export function leastAbsolute(equations: Equations, measured: Float64Array): { found: Float64Array; residuals: Float64Array } {
  const used = Array.from(measured.keys()).filter(equation => !Number.isNaN(measured[equation]));
  const found = new Float64Array(equations.unknowns);
  const squares = new Float64Array(equations.unknowns ** 2);
  const weights = new Float64Array(used.length).fill(1);
  const residuals = new Float64Array(used.length);
  const ordered = new Float64Array(used.length);
  for (let round = 0; round < rounds; round++) {
    squares.fill(0);
    found.fill(0);
    for (let i = 0; i < found.length; i++) squares[i * found.length + i] = held;
    for (let i = 0; i < used.length; i++) equations.addTo(squares, found, used[i], weights[i], measured[used[i]]);
    solve(squares, found);
    for (let i = 0; i < used.length; i++) residuals[i] = Math.abs(measured[used[i]] - equations.valueOf(used[i], found));
    ordered.set(residuals);
    const floor = Math.max(held, noise * medianOf(ordered, ordered.length));
    for (let i = 0; i < weights.length; i++) weights[i] = 1 / Math.max(residuals[i], floor);
  }
  return { found, residuals };
}

/**
 * Solves linear equations with a symmetric positive definite matrix by Cholesky decomposition.
 * @param matrix Lower triangle of the matrix, row by row. Receives the decomposition.
 * @param values Right sides. Receives the solution.
 */
function solve(matrix: Float64Array, values: Float64Array): void {
  const count = values.length;
  for (let row = 0; row < count; row++)
    for (let column = 0; column <= row; column++) {
      let sum = matrix[row * count + column];
      for (let i = 0; i < column; i++) sum -= matrix[row * count + i] * matrix[column * count + i];
      matrix[row * count + column] = row === column ? Math.sqrt(sum) : sum / matrix[column * count + column];
    }
  for (let row = 0; row < count; row++) {
    for (let i = 0; i < row; i++) values[row] -= matrix[row * count + i] * values[i];
    values[row] /= matrix[row * count + row];
  }
  for (let row = count - 1; row >= 0; row--) {
    for (let i = row + 1; i < count; i++) values[row] -= matrix[i * count + row] * values[i];
    values[row] /= matrix[row * count + row];
  }
}

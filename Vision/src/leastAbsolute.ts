import { medianOf } from './median';
import { cv } from './opencv';

type Mat = InstanceType<typeof cv.Mat>;

const rounds = 15;
/** Multiple of the median residual up to which residuals count as noise and have equal weights. */
const noise = 1.5;
/** Regularisation for unknowns without a measurement. Small enough not to affect the others. */
const held = 1e-6;

/** Linear equations. Each equates a sum of unknowns times factors with a measured value. Stored in flat arrays, because there are thousands. */
export class Equations {
  readonly #measured: number[] = [];
  /** Index of the first term of each equation. */
  readonly #starts: number[] = [0];
  readonly #unknowns: number[] = [];
  readonly #factors: number[] = [];

  get count(): number {
    return this.#measured.length;
  }

  /** Adds a term to the current equation, which the next call of `end` completes. */
  term(unknown: number, factor: number): void {
    this.#unknowns.push(unknown);
    this.#factors.push(factor);
  }

  end(measured: number): void {
    this.#measured.push(measured);
    this.#starts.push(this.#unknowns.length);
  }

  /** Computes the absolute residual of each equation. */
  setResiduals(values: Float64Array, residuals: Float64Array): void {
    for (let i = 0; i < residuals.length; i++) {
      let residual = this.#measured[i];
      for (let at = this.#starts[i]; at < this.#starts[i + 1]; at++) residual -= this.#factors[at] * values[this.#unknowns[at]];
      residuals[i] = Math.abs(residual);
    }
  }

  /** Computes the normal equations: AᵀWy and the lower triangle of AᵀWA. OpenCV's Cholesky decomposition reads no other elements. */
  setNormal(weights: Float64Array, squares: Float64Array, products: Float64Array): void {
    const count = products.length;
    squares.fill(0);
    products.fill(0);
    for (let i = 0; i < count; i++) squares[i * count + i] = held;
    for (let i = 0; i < weights.length; i++)
      for (let at = this.#starts[i]; at < this.#starts[i + 1]; at++) {
        const unknown = this.#unknowns[at];
        const weight = weights[i] * this.#factors[at];
        products[unknown] += weight * this.#measured[i];
        for (let by = this.#starts[i]; by < this.#starts[i + 1]; by++)
          if (this.#unknowns[by] <= unknown) squares[unknown * count + this.#unknowns[by]] += weight * this.#factors[by];
      }
  }
}

/** Finds the unknowns that minimise the sum of absolute residuals, by iteratively reweighted least squares. Also returns these residuals. */
export function leastAbsolute(equations: Equations, count: number): { found: Float64Array; residuals: Float64Array } {
  const [normal, right, found] = [count, 1, 1].map(columns => new cv.Mat(count, columns, cv.CV_64FC1)) as [Mat, Mat, Mat];
  const weights = new Float64Array(equations.count).fill(1);
  const residuals = new Float64Array(equations.count);
  try {
    for (let round = 0; round < rounds; round++) {
      equations.setNormal(weights, normal.data64F, right.data64F);
      cv.solve(normal, right, found, cv.DECOMP_CHOLESKY);
      equations.setResiduals(found.data64F, residuals);
      const floor = Math.max(held, noise * medianOf(residuals.slice(), residuals.length));
      for (let i = 0; i < weights.length; i++) weights[i] = 1 / Math.max(residuals[i], floor);
    }
    return { found: found.data64F.slice(), residuals };
  } finally {
    for (const made of [normal, right, found]) made.delete();
  }
}

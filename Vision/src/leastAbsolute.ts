import { medianOf } from './median';
import { cv } from './opencv';

type Mat = InstanceType<typeof cv.Mat>;

const rounds = 15;
/** What is off by no more than this, in medians of what all are off by, is noise. */
const noise = 1.5;
/** Holds an unknown of which nothing is seen; too little to be noticed in others. */
const held = 1e-6;

/** Sums of unknowns times factors that are to be equal to what was measured. Kept flat: there are a thousand of them, many times over. */
export class Equations {
  readonly #measured: number[] = [];
  /** Of each equation, where its terms start. */
  readonly #starts: number[] = [0];
  readonly #unknowns: number[] = [];
  readonly #factors: number[] = [];

  get count(): number { return this.#measured.length; }

  /** Adds a term to the equation that is ended next. */
  term(unknown: number, factor: number): void {
    this.#unknowns.push(unknown);
    this.#factors.push(factor);
  }

  end(measured: number): void {
    this.#measured.push(measured);
    this.#starts.push(this.#unknowns.length);
  }

  /** How far each is off. */
  setRests(values: Float64Array, rests: Float64Array): void {
    for (let i = 0; i < rests.length; i++) {
      let rest = this.#measured[i];
      for (let at = this.#starts[i]; at < this.#starts[i + 1]; at++) rest -= this.#factors[at] * values[this.#unknowns[at]];
      rests[i] = Math.abs(rest);
    }
  }

  /** The normal equations, AᵀWA and AᵀWy. */
  setNormal(weights: Float64Array, squares: Float64Array, products: Float64Array): void {
    const count = products.length;
    squares.fill(0);
    products.fill(0);
    for (let i = 0; i < count; i++) squares[i * count + i] = held;
    for (let i = 0; i < weights.length; i++)
      for (let at = this.#starts[i]; at < this.#starts[i + 1]; at++) {
        const unknown = this.#unknowns[at], weight = weights[i] * this.#factors[at];
        products[unknown] += weight * this.#measured[i];
        for (let by = this.#starts[i]; by < this.#starts[i + 1]; by++) squares[unknown * count + this.#unknowns[by]] += weight * this.#factors[by];
      }
  }
}

/** Finds the unknowns with the minimum sum of absolute residuals, by iteratively reweighted least squares. */
export function leastAbsolute(equations: Equations, count: number): Float64Array {
  const [normal, right, found] = [count, 1, 1].map(columns => new cv.Mat(count, columns, cv.CV_64FC1)) as [Mat, Mat, Mat];
  const weights = new Float64Array(equations.count).fill(1), rests = new Float64Array(equations.count);
  try {
    for (let round = 0; round < rounds; round++) {
      equations.setNormal(weights, normal.data64F, right.data64F);
      cv.solve(normal, right, found, cv.DECOMP_CHOLESKY);
      equations.setRests(found.data64F, rests);
      const least = Math.max(held, noise * medianOf(rests.slice(), rests.length));
      for (let i = 0; i < weights.length; i++) weights[i] = 1 / Math.max(rests[i], least);
    }
    return found.data64F.slice();
  } finally {
    for (const made of [normal, right, found]) made.delete();
  }
}

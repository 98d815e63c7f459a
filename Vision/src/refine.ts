import { centreOf, distance, isPlausible, sizeOf, type Quad } from './geometry';
import { sampleCentres, type Grey } from './levels';
import type { Agreement, Matcher } from './pattern';

/** A quad with how well the levels inside it agree with a code. */
export interface Fit {
  quad: Quad;
  agreement: Agreement;
  contrast: number;
  /** How much brighter the ring is than what lies around it, at the side where that is least; NaN at the picture's edge. */
  edge: number;
  score: number;
}

/** Steps of the corners, in cells: from a row more or less, to what no longer matters. */
const steps = [1, 0.5, 0.25, 0.12, 0.06];

/** Farther than this a corner is not moved, in cells: it would be looking for another code. */
const farthest = 2.4;

/** Moves a quad's corners to where a code of some kind fits best. For pictures that are smooth at the size of a cell. */
export class Refiner {
  readonly #matcher: Matcher;
  readonly #grey: Grey;
  readonly #around: Float64Array;
  readonly #levels: Float64Array;

  constructor(matcher: Matcher, grey: Grey) {
    this.#matcher = matcher;
    this.#grey = grey;
    this.#around = new Float64Array((matcher.side + 2) ** 2);
    this.#levels = new Float64Array(matcher.side ** 2);
  }

  /** The best of what a quad might be, before any refinement; null when it reaches out of the picture. */
  guess(quad: Quad): Fit | null {
    if (!this.#sample(quad)) return null;
    return this.#fitOf(quad, this.#matcher.all(this.#levels)[0]);
  }

  /** @param fit What the quad is taken for: kind and turn stay. */
  refine(fit: Fit, stepsToTake = steps): Fit {
    const kind = this.#matcher.kindIndex(fit.agreement.kind), { turns } = fit.agreement;
    const cell = sizeOf(fit.quad) / this.#matcher.side;
    let best = fit;
    for (const step of stepsToTake) {
      for (let round = 0; round < 3; round++) {
        const before = best.score;
        for (const move of moves) {
          const quad = move(best.quad, step * cell);
          if (quad.some((p, i) => distance(p, fit.quad[i]) > farthest * cell) || !this.#sample(quad)) continue;
          const tried = this.#fitOf(quad, this.#matcher.one(this.#levels, kind, turns));
          if (tried.score > best.score) best = tried;
        }
        if (best.score <= before) break;
      }
    }
    return isPlausible(best.quad, 5 * this.#matcher.side) ? best : fit;
  }

  /** Whether no other kind or turn explains the levels nearly as well. */
  isClear(fit: Fit): boolean {
    if (!this.#sample(fit.quad)) return false;
    const [first, second] = this.#matcher.all(this.#levels);
    return first.kind === fit.agreement.kind && first.turns === fit.agreement.turns && second.rest > 1.25 * first.rest;
  }

  #sample(quad: Quad): boolean {
    const { side } = this.#matcher;
    if (!sampleCentres(this.#grey, quad, side, 1, this.#around)) return this.#sampleInside(quad);
    for (let row = 0; row < side; row++)
      for (let column = 0; column < side; column++) this.#levels[row * side + column] = this.#around[(row + 1) * (side + 2) + column + 1];
    return true;
  }

  /** A code at the picture's edge has no surroundings to be compared with. */
  #sampleInside(quad: Quad): boolean {
    if (!sampleCentres(this.#grey, quad, this.#matcher.side, 0, this.#levels)) return false;
    this.#around.fill(NaN);
    return true;
  }

  #fitOf(quad: Quad, agreement: Agreement): Fit {
    const { mean, spread } = this.#matcher.contrast(this.#levels, agreement.turns);
    const edges = this.#edges(), edge = Math.min(...edges);
    // Pairs may be washed out by a long exposure; the ring never is.
    const held = edges.map(e => Math.max(-agreement.light, Math.min(e, agreement.light)));
    const ring = (0.8 / held.length) * held.reduce((a, b) => a + b) + 0.3 * Math.min(...held);
    const score = 1 * Math.min(mean, agreement.light) + (ring || 0) - 2 * agreement.rest - 0.4 * spread;
    return { quad, agreement, contrast: mean, edge, score };
  }

  /** Of each side. Holds the ring's cells where they are: a row of cells that are half lit would pass for a part of the ring. */
  #edges(): number[] {
    const n = this.#matcher.side + 2, a = this.#around;
    const starts = [[1, n], [(n - 1) * n + 1, -n], [n, 1], [2 * n - 1, -1]], strides = [1, 1, n, n];
    return starts.map(([outside, inwards], side) => {
      let sum = 0;
      for (let i = 0; i < n - 2; i++) {
        const at = outside + i * strides[side];
        sum += a[at + inwards] - a[at];
      }
      return sum / (n - 2);
    });
  }
}

type Move = (quad: Quad, by: number) => Quad;

const directions = [[1, 0], [-1, 0], [0, 1], [0, -1]];
const shifted = (dx: number, dy: number): Move => (quad, by) => quad.map(p => [p[0] + dx * by, p[1] + dy * by]) as Quad;
const cornered = (corner: number, dx: number, dy: number): Move =>
  (quad, by) => quad.map((p, i) => i === corner ? [p[0] + dx * by, p[1] + dy * by] : p) as Quad;
const grown = (sign: number): Move => (quad, by) => {
  const [x, y] = centreOf(quad), factor = 1 + sign * 1.4 * by / sizeOf(quad);
  return quad.map(p => [x + (p[0] - x) * factor, y + (p[1] - y) * factor]) as Quad;
};
const rotated = (sign: number): Move => (quad, by) => {
  const [x, y] = centreOf(quad), angle = sign * 1.4 * by / sizeOf(quad);
  const c = Math.cos(angle), s = Math.sin(angle);
  return quad.map(p => [x + (p[0] - x) * c - (p[1] - y) * s, y + (p[0] - x) * s + (p[1] - y) * c]) as Quad;
};

const edged = (side: number, sign: number): Move => (quad, by) => {
  // Both of a side's corners, away from the opposite side or towards it.
  const next = (side + 1) & 3, across = [(side + 3) & 3, (side + 2) & 3];
  return quad.map((p, i) => {
    if (i !== side && i !== next) return p;
    const q = quad[across[i === side ? 0 : 1]], length = distance(p, q);
    return [p[0] + sign * by * (p[0] - q[0]) / length, p[1] + sign * by * (p[1] - q[1]) / length];
  }) as Quad;
};

const moves: Move[] = [
  ...directions.map(([dx, dy]) => shifted(dx, dy)),
  grown(1), grown(-1), rotated(1), rotated(-1),
  ...[0, 1, 2, 3].flatMap(side => [edged(side, 1), edged(side, -1)]),
  ...[0, 1, 2, 3].flatMap(corner => directions.map(([dx, dy]) => cornered(corner, dx, dy))),
];

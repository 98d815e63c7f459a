import { areNear, centreOf, distance, grownBy, isPlausible, mapped, shiftedBy, sizeOf, turned, type Quad } from './geometry';
import type { Light } from './levels';
import type { Agreement, Matcher } from './match';
import { turnedBand, type Band } from './pattern';

/** A quad, and the agreement of its outer edge. */
interface Start extends Agreement {
  quad: Quad;
  /** Band of the quad that is ignored, because it can be covered or outside the picture. */
  hidden?: Band;
}

/** A quad that is assumed to be a code. Its first corner is the top left corner of the code. */
export interface Fit extends Start {
  kind: number;
}

/** Start positions around a candidate. sizes: factors of its size. shifts: shifts in each direction, in cells. */
const sizes = [0.8, 0.9, 1, 1.1, 1.2];
const shifts = [-1, 0, 1];
/** Number of start positions that are refined: those with the best agreement. */
const followed = 2;

/** Step sizes of the corners for fitting the outer edge alone, in cells. */
const outerSteps = [0.5, 0.25];

/** One step of a refinement. */
interface RefineStep {
  /** Step size of the corners, in cells. */
  by: number;
  /** Distance from the edges of cells at which light is sampled, in cells. */
  reach: number;
  /** Minimum share of agreeing steps between cells after this refinement step. Below it, the refinement ends early. */
  minShare: number;
}

/**
 * Refinement steps that fit all changes of light between cells, with step sizes from one cell down to a negligible size. In 128 rendered pictures,
 * all codes that were found had shares of at least 0.53, 0.61, 0.63 and 0.66 after the first four steps, and four fifths of the other objects had
 * less than 0.45 after the first one.
 */
const steps: RefineStep[] = [
  { by: 1, reach: 0.4, minShare: 0.42 },
  { by: 0.5, reach: 0.35, minShare: 0.48 },
  { by: 0.25, reach: 0.3, minShare: 0.5 },
  { by: 0.12, reach: 0.25, minShare: 0.5 },
  { by: 0.06, reach: 0.2, minShare: 0.5 },
];

/**
 * Sampling distance at the middle of cells. With a larger distance, a start position can be farther from the code, but the scene disturbs the fit
 * more often.
 */
const middle = 0.5;
/** Sampling distance for determining kind and orientation of a code whose position is known. */
const inPlace = 0.3;

/** Maximum distance by which a corner is moved, in cells. A larger distance would reach another code. */
const maxDistance = 2.4;

/**
 * Minimum share of agreeing steps of a guess that is refined. In 192 rendered pictures with two or three codes each, the best guess of each found
 * code had 0.3 or more, and a third of all guesses had less than 0.25.
 */
const minShareOfGuess = 0.25;
/** Minimum agreement of the outer edge of a start position. In the same pictures, the best start position of each found code had 0.42 or more. */
export const minShareOfStart = 0.35;

/** Minimum lead of the best kind and orientation over the second-best, in the share of agreeing steps. Two kinds differ in 8 % of the steps. */
const minLead = 0.02;

/** Moves the corners of a quad to where they best fit a code of any kind. The picture must be smooth at the scale of a cell. */
export class Refiner {
  readonly #matcher: Matcher;
  readonly #isFilled: boolean[];
  readonly #picture: Light;

  /** @param isFilled For each kind, whether cells are lit up to their edges. If not, light is sampled in the middle of cells. */
  constructor(matcher: Matcher, isFilled: boolean[], picture: Light) {
    this.#matcher = matcher;
    this.#isFilled = isFilled;
    this.#picture = picture;
  }

  /** Returns the start positions around a candidate whose outer edges agree best, in decreasing order of agreement. */
  startsAt(candidate: Quad, hidden?: Band): Start[] {
    const cell = sizeOf(candidate) / this.#matcher.side;
    return sizes
      .map(size => grownBy(candidate, size))
      .flatMap(quad => shifts.flatMap(x => shifts.map(y => this.#outer(shiftedBy(quad, x * cell, y * cell), hidden))))
      .sort(byScore)
      .slice(0, followed);
  }

  /** Fits the outer edge of each start position. Returns the results that are worth refining, in decreasing order of agreement. */
  guesses(starts: Start[]): Fit[] {
    return starts
      .map(start => {
        const cell = sizeOf(start.quad) / this.#matcher.side;
        const at = (quad: Quad) => this.#matcher.outerAgreement(this.#picture, quad, start.hidden);
        return outerSteps.reduce((best, step) => climb(best, step * cell, 2, at), start);
      })
      .map(({ quad, hidden }) => this.#alternatives(quad, middle, hidden)[0])
      .filter(({ share }) => share > minShareOfGuess)
      .sort(byScore);
  }

  #outer(quad: Quad, hidden?: Band): Start {
    return { quad, hidden, ...this.#matcher.outerAgreement(this.#picture, quad, hidden) };
  }

  /** @param fit The assumed code. Kind and orientation change only if others agree better at the refined position. */
  refine(fit: Fit): Fit {
    const found = this.#refined(fit, steps);
    if (found.share < steps.at(-1)!.minShare) return found;
    const best = this.#alternatives(found.quad, middle, found.hidden)[0];
    const isSame = best.kind === found.kind && best.quad[0] === found.quad[0];
    return isSame ? found : this.#refined(best, steps.slice(-3));
  }

  /** Returns whether all other kinds and orientations agree clearly less. */
  isClear(fit: Fit): boolean {
    const [first, second] = this.#alternatives(fit.quad, this.#reach(fit.kind, inPlace));
    return first.kind === fit.kind && first.quad[0] === fit.quad[0] && first.share - second.share > minLead;
  }

  /** Returns the fit with its agreement recomputed without the steps in a band. */
  without(fit: Fit, hidden: Band): Fit {
    return { ...fit, hidden, ...this.#matcher.agreement(this.#picture, fit.quad, fit.kind, this.#reach(fit.kind, inPlace), hidden) };
  }

  /** Refines, with small steps, a fit whose kind and orientation are known. */
  refineLast(fit: Fit): Fit {
    return this.#refined(fit, steps.slice(-3));
  }

  #refined(fit: Fit, stepsToTake: RefineStep[]): Fit {
    const { kind, hidden } = fit;
    const cell = sizeOf(fit.quad) / this.#matcher.side;
    let best = fit;
    const isNear = (quad: Quad) => areNear(quad, fit.quad, maxDistance * cell);
    for (const { by, reach, minShare } of stepsToTake) {
      const at = (quad: Quad, needed?: number) => this.#matcher.agreement(this.#picture, quad, kind, this.#reach(kind, reach), hidden, needed);
      best = climb({ ...best, ...at(best.quad) }, by * cell, 3, at, isNear);
      if (best.share < minShare) break;
    }
    return isPlausible(best.quad, 5 * this.#matcher.side) ? best : fit;
  }

  /** Returns one fit of the quad for each kind of code in each of the four orientations, the best agreement first. */
  #alternatives(quad: Quad, reach: number, hidden?: Band): Fit[] {
    const { light } = this.#matcher.outerAgreement(this.#picture, quad, hidden);
    return [0, 1, 2, 3]
      .flatMap(turns =>
        this.#isFilled.map((_, kind) => {
          const seen = turned(quad, turns);
          const band = hidden === undefined ? undefined : turnedBand(hidden, turns);
          return { quad: seen, kind, hidden: band, ...this.#matcher.agreement(this.#picture, seen, kind, reach, band, 0, light) };
        }),
      )
      .sort(byScore);
  }

  #reach(kind: number, reach: number): number {
    return this.#isFilled[kind] ? reach : middle;
  }
}

const score = ({ light, share }: Agreement) => light * share;
const byScore = (a: Agreement, b: Agreement) => score(b) - score(a);

/**
 * Moves, scales and deforms a quad by steps of `by` px as long as this improves its score, for at most `rounds` rounds.
 *
 * @param at Returns the agreement of a quad. If its score cannot reach `needed`, the agreement may be zero.
 */
function climb<T extends Start>(
  start: T,
  by: number,
  rounds: number,
  at: (quad: Quad, needed: number) => Agreement,
  isAllowed: (quad: Quad) => boolean = () => true,
): T {
  let best = start;
  let failed = 0;
  for (let tries = 0; tries < rounds * moves.length && failed < moves.length; tries++) {
    const quad = moves[tries % moves.length](best.quad, by);
    const found = isAllowed(quad) ? at(quad, score(best)) : undefined;
    if (found && score(found) > score(best)) {
      best = { ...best, quad, ...found };
      failed = 0;
    } else failed++;
  }
  return best;
}

type Move = (quad: Quad, by: number) => Quad;

const directions = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
];
const shifted =
  (dx: number, dy: number): Move =>
  (quad, by) =>
    shiftedBy(quad, dx * by, dy * by);
const cornered =
  (corner: number, dx: number, dy: number): Move =>
  (quad, by) => {
    const moved = quad.slice() as Quad;
    moved[corner] = [quad[corner][0] + dx * by, quad[corner][1] + dy * by];
    return moved;
  };
const grown =
  (sign: number): Move =>
  (quad, by) =>
    grownBy(quad, 1 + (sign * 1.4 * by) / sizeOf(quad));
const rotated =
  (sign: number): Move =>
  (quad, by) => {
    const [x, y] = centreOf(quad);
    const angle = (sign * 1.4 * by) / sizeOf(quad);
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    return mapped(quad, p => [x + (p[0] - x) * c - (p[1] - y) * s, y + (p[0] - x) * s + (p[1] - y) * c]);
  };

const edged =
  (side: number, sign: number): Move =>
  (quad, by) => {
    // Moves both corners of a side away from the opposite side or towards it.
    const moved = quad.slice() as Quad;
    for (const corner of [side, (side + 1) & 3]) {
      const p = quad[corner];
      const q = quad[corner === side ? (side + 3) & 3 : (side + 2) & 3];
      const length = distance(p, q);
      moved[corner] = [p[0] + (sign * by * (p[0] - q[0])) / length, p[1] + (sign * by * (p[1] - q[1])) / length];
    }
    return moved;
  };

const moves: Move[] = [
  ...directions.map(([dx, dy]) => shifted(dx, dy)),
  grown(1),
  grown(-1),
  rotated(1),
  rotated(-1),
  ...[0, 1, 2, 3].flatMap(side => [edged(side, 1), edged(side, -1)]),
  ...[0, 1, 2, 3].flatMap(corner => directions.map(([dx, dy]) => cornered(corner, dx, dy))),
];

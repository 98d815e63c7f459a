import { areNear, grownBy, isPlausible, shiftedBy, sizeOf, turned, type Quad } from './geometry';
import type { Light } from './levels';
import type { Agreement, Matcher } from './match';
import { moves } from './moves';
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

/** The steps for the fit to a code. All of them have the same sampling distance, so a later one does not undo the result of an earlier one. */
const exactSteps: RefineStep[] = [0.25, 0.12, 0.06, 0.03].map(by => ({ by, reach: 0.2, minShare: 0 }));

/** The steps for a fit whose kind and orientation are known. */
const lastSteps = steps.slice(-3);

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

/** What a quad is fitted to. */
interface Target {
  /** Kind of the code; undefined to fit the outer edge alone. */
  kind?: number;
  /** Distance from the edges of cells at which light is sampled, in cells. */
  reach: number;
  hidden?: Band;
  /** The corners stay within a distance from those of this quad, px. */
  near?: { quad: Quad; distance: number };
}

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

  /** Returns the start positions around a candidate whose outer edges agree best, in decreasing order of agreement. Can be empty. */
  startsAt(candidate: Quad, hidden?: Band): Start[] {
    const cell = sizeOf(candidate) / this.#matcher.side;
    const best: Start[] = [];
    for (const size of sizes) {
      const grown = grownBy(candidate, size);
      for (const x of shifts)
        for (const y of shifts) {
          const quad = shiftedBy(grown, x * cell, y * cell);
          const found = this.#matcher.outerAgreement(this.#picture, quad, hidden, best.length < followed ? 0 : score(best[followed - 1]));
          if (!(found.light > 0)) continue;
          best.push({ quad, hidden, light: found.light, share: found.share });
          best.sort(byScore);
          best.length = Math.min(best.length, followed);
        }
    }
    return best;
  }

  /** Fits the outer edge of each start position. Returns the results that are worth refining, in decreasing order of agreement. */
  guesses(starts: Start[]): Fit[] {
    return starts
      .map(start => {
        const cell = sizeOf(start.quad) / this.#matcher.side;
        const target = { reach: middle, hidden: start.hidden };
        const fitted = outerSteps.reduce((best, step) => this.#climb(best, step * cell, 2, target), start);
        return this.#best(fitted.quad, middle, fitted.hidden);
      })
      .filter(({ share }) => share > minShareOfGuess)
      .sort(byScore);
  }

  /** @param fit The assumed code. Kind and orientation change only if others agree better at the refined position. */
  refine(fit: Fit): Fit {
    const found = this.#refined(fit, steps);
    if (found.share < steps.at(-1)!.minShare) return found;
    const best = this.#best(found.quad, middle, found.hidden);
    return isSame(best, found) ? found : this.#refined(best, lastSteps);
  }

  /** Returns whether all other kinds and orientations agree clearly less. */
  isClear(fit: Fit): boolean {
    const [first, second] = [...this.#alternatives(fit.quad, this.#reach(fit.kind, inPlace))].sort(byScore);
    return isSame(first, fit) && first.share - second.share > minLead;
  }

  /** Returns the fit with its agreement recomputed without the steps in a band. */
  without(fit: Fit, hidden: Band): Fit {
    return { ...fit, hidden, ...this.#matcher.agreement(this.#picture, fit.quad, fit.kind, this.#reach(fit.kind, inPlace), hidden) };
  }

  /** Refines, with small steps, a fit whose kind and orientation are known. */
  refineLast(fit: Fit): Fit {
    return this.#refined(fit, lastSteps);
  }

  /** Refines a fit to a code once more, without limits of the share of agreeing steps. */
  refineExactly(fit: Fit): Fit {
    return this.#refined(fit, exactSteps);
  }

  #refined(fit: Fit, stepsToTake: RefineStep[]): Fit {
    const { kind, hidden } = fit;
    const cell = sizeOf(fit.quad) / this.#matcher.side;
    const near = { quad: fit.quad, distance: maxDistance * cell };
    let best = fit;
    for (const { by, reach, minShare } of stepsToTake) {
      const target = { kind, hidden, reach: this.#reach(kind, reach), near };
      best = this.#climb({ ...best, ...this.#agreement(best.quad, target) }, by * cell, 3, target);
      if (best.share < minShare) break;
    }
    return isPlausible(best.quad, 5 * this.#matcher.side) ? best : fit;
  }

  /**
   * Moves, scales and deforms a quad by steps of `by` px as long as this improves its score, for at most `rounds` rounds.
   * @param start The quad and its agreement with the target.
   */
  #climb<T extends Start>(start: T, by: number, rounds: number, target: Target): T {
    let { quad } = start;
    let found: Agreement = start;
    let failed = 0;
    for (let tries = 0; tries < rounds * moves.length && failed < moves.length; tries++) {
      const moved = moves[tries % moves.length](quad, by);
      const at = target.near && !areNear(moved, target.near.quad, target.near.distance) ? found : this.#agreement(moved, target, score(found));
      if (score(at) > score(found)) {
        quad = moved;
        found = at;
        failed = 0;
      } else failed++;
    }
    return { ...start, quad, light: found.light, share: found.share };
  }

  /** @param needed Score that the agreement must exceed. If it does not, the result is an agreement of zero. */
  #agreement(quad: Quad, { kind, reach, hidden }: Target, needed = 0): Agreement {
    return kind === undefined
      ? this.#matcher.outerAgreement(this.#picture, quad, hidden, needed)
      : this.#matcher.agreement(this.#picture, quad, kind, reach, hidden, needed);
  }

  /** Returns the fit of the quad with the best agreement. */
  #best(quad: Quad, reach: number, hidden?: Band): Fit {
    let best: Fit | undefined;
    // A fit that does not exceed the best one so far is not computed completely.
    for (const fit of this.#alternatives(quad, reach, hidden, () => (best ? score(best) : 0))) if (!best || score(fit) > score(best)) best = fit;
    return best!;
  }

  /**
   * Yields one fit of the quad for each kind of code in each of the four orientations.
   * @param needed Score that the next fit must exceed. If it does not, its agreement is zero.
   */
  *#alternatives(quad: Quad, reach: number, hidden?: Band, needed = () => 0): Generator<Fit> {
    const { light } = this.#matcher.outerAgreement(this.#picture, quad, hidden);
    for (const turns of [0, 1, 2, 3]) {
      const seen = turned(quad, turns);
      const band = hidden === undefined ? undefined : turnedBand(hidden, turns);
      for (const kind of this.#isFilled.keys())
        yield { quad: seen, kind, hidden: band, ...this.#matcher.agreement(this.#picture, seen, kind, reach, band, needed(), light) };
    }
  }

  #reach(kind: number, reach: number): number {
    return this.#isFilled[kind] ? reach : middle;
  }
}

const score = ({ light, share }: Agreement) => light * share;
const byScore = (a: Agreement, b: Agreement) => score(b) - score(a);

/** Returns whether two fits at the same position have the same kind and orientation. */
const isSame = (fit: Fit, other: Fit) => fit.kind === other.kind && areNear(fit.quad, other.quad, 0);

import { homography, type Quad } from './geometry';
import { lightThrough, type Light } from './levels';
import { medianOf } from './median';
import { Band, Expected, isWithinBand, outer, stepsOf, type Pattern, type Step } from './pattern';

/** Agreement of a quad with a kind of code. The quad's first corner is the top left corner of the code. */
export interface Agreement {
  /** Light of a lit cell minus that of a dark cell; linear, 1 is white. */
  light: number;
  /** Share of the steps from cell to cell that agree with the code, −1 to 1. */
  share: number;
}

/** Distance from the outer edge at which light is sampled, relative to the length of a step. */
const outerReach = 0.5;

/**
 * Computes how well a picture agrees with codes, from the changes of light between adjacent cells (steps). The size of a step counts at most up to
 * the code's light, which is the median of the steps. Edges of the scene therefore affect only the few steps that they cross.
 */
export class Matcher {
  readonly kinds: string[];
  readonly side: number;
  /** For each kind, the steps of the whole code, and the steps of the code without each band. */
  readonly #kinds: { whole: Steps; parts: Steps[] }[];
  readonly #outer: { whole: Float64Array; parts: Float64Array[] };
  readonly #steps: Float64Array;
  readonly #rises: Float64Array;

  constructor(pattern: Pattern) {
    this.side = pattern.side;
    this.kinds = Object.keys(pattern.kinds);
    this.#kinds = Object.values(pattern.kinds).map(kind => {
      const steps = stepsOf(pattern, kind);
      return { whole: stepsIn(steps), parts: bands.map(band => stepsIn(steps.filter(({ x, y }) => !isWithinBand(band, x, y)))) };
    });
    const edges = outerOf(pattern.side);
    this.#outer = {
      whole: Float64Array.from(edges.flat()),
      parts: bands.map(band => Float64Array.from(edges.filter(([x, y]) => !isWithinBand(band, x, y)).flat())),
    };
    this.#steps = new Float64Array(Math.max(...this.#kinds.map(({ whole }) => whole.expected.length)));
    this.#rises = new Float64Array(this.#steps.length);
  }

  /**
   * @param reach Distance from the edge of a cell at which light is sampled, in cells; 0.5 is the middle of the cell.
   * @param hidden Band of the code that is ignored.
   * @param given Light of the code if it is known, so that kinds and orientations of the same quad can be compared.
   */
  agreement(picture: Light, quad: Quad, kind: number, reach: number, hidden?: Band, given?: number): Agreement {
    const { whole, parts } = this.#kinds[kind];
    const { points, expected, most } = hidden === undefined ? whole : parts[hidden];
    const steps = this.#steps;
    this.#sample(picture, quad, points, reach);
    let count = 0;
    for (let i = 0; i < expected.length; i++) if (expected[i] === Expected.Rise) this.#rises[count++] = steps[i];
    const light = given ?? medianOf(this.#rises, count);
    if (!(light > 0)) return { light: 0, share: 0 };
    let sum = 0;
    for (let i = 0; i < expected.length; i++) {
      const step = steps[i];
      if (expected[i] === Expected.Rise) sum += Math.max(-light, Math.min(step, light));
      else sum += (expected[i] === Expected.Pair ? 1 : -1) * Math.min(Math.abs(step), light);
    }
    return { light, share: sum / light / most };
  }

  /** Computes the agreement of the outer edge alone, which is independent of kind and orientation of the code. */
  outerAgreement(picture: Light, quad: Quad, hidden?: Band): Agreement {
    const points = hidden === undefined ? this.#outer.whole : this.#outer.parts[hidden];
    const count = points.length / 4;
    this.#sample(picture, quad, points, outerReach);
    this.#rises.set(this.#steps.subarray(0, count));
    const light = medianOf(this.#rises, count);
    if (!(light > 0)) return { light: 0, share: 0 };
    let sum = 0;
    for (let i = 0; i < count; i++) sum += Math.max(-light, Math.min(this.#steps[i], light));
    return { light, share: sum / light / count };
  }

  /** Computes the steps of light. A step is 0 if one of its samples is outside the picture. */
  #sample(picture: Light, quad: Quad, points: Float64Array, reach: number): void {
    const seen = homography(quad);
    const steps = this.#steps;
    for (let i = 0, at = 0; at < points.length; i++, at += 4) {
      const x = points[at];
      const y = points[at + 1];
      const dx = reach * points[at + 2];
      const dy = reach * points[at + 3];
      steps[i] = lightThrough(picture, seen, x + dx, y + dy) - lightThrough(picture, seen, x - dx, y - dy) || 0;
    }
  }
}

/** Points and directions of steps in flat arrays, and the number of steps at which a change of light is expected. */
interface Steps {
  points: Float64Array;
  expected: Uint8Array;
  most: number;
}

const bands = [Band.Top, Band.Right, Band.Bottom, Band.Left, Band.Columns, Band.Rows];

const stepsIn = (steps: Step[]): Steps => ({
  points: Float64Array.from(steps.flatMap(({ x, y, dx, dy }) => [x, y, dx, dy])),
  expected: Uint8Array.from(steps, step => step.expected),
  most: steps.filter(step => step.expected !== Expected.Level).length,
});

/** Returns the points and directions of the inward steps across the outer edge. */
function outerOf(side: number): number[][] {
  const edge = outer.inwards / side;
  const step = outer.length / side;
  return Array.from({ length: side }, (_, i) => (i + 0.5) / side).flatMap(along => [
    [edge, along, step, 0],
    [1 - edge, along, -step, 0],
    [along, edge, 0, step],
    [along, 1 - edge, 0, -step],
  ]);
}

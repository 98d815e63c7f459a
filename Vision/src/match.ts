import { coefficients, setHomography, type Quad } from './geometry';
import { sampleLight, type Light } from './levels';
import { medianOf } from './median';
import { bands, Expected, isWithinBand, outer, stepsOf, type Band, type Pattern, type Step } from './pattern';

/** Agreement of a quad with a kind of code. The quad's first corner is the top left corner of the code. */
export interface Agreement {
  /** Light of a lit cell minus that of a dark cell; linear, 1 is white. */
  light: number;
  /** Agreement of the steps from cell to cell with the code, from −1 (all are opposite) to 1 (all agree). */
  share: number;
}

/** Distance from the outer edge at which light is sampled, relative to the length of a step. */
const outerReach = 0.5;

/**
 * Computes how well a picture agrees with codes, from the changes of light between adjacent cells (steps). The size of a step is clipped at the
 * code's light, which is the median of the steps at which the light rises. Edges of the scene therefore affect only the few steps that they cross.
 */
export class Matcher {
  readonly kinds: string[];
  readonly side: number;
  /** For each kind, the steps of the whole code, and the steps of the code without each band. */
  readonly #kinds: { whole: Steps; parts: Steps[] }[];
  readonly #outer: { whole: Steps; parts: Steps[] };
  readonly #lights: Float64Array;
  readonly #rises: Float64Array;
  readonly #seen = new Float64Array(coefficients);

  constructor(pattern: Pattern) {
    this.side = pattern.side;
    this.kinds = Object.keys(pattern.kinds);
    const withParts = (steps: Step[]) => ({
      whole: new Steps(steps),
      parts: bands.map(band => new Steps(steps.filter(({ x, y }) => !isWithinBand(band, x, y)))),
    });
    this.#kinds = Object.values(pattern.kinds).map(kind => withParts(stepsOf(pattern, kind)));
    this.#outer = withParts(outerOf(pattern.side));
    this.#lights = new Float64Array(2 * Math.max(...this.#kinds.map(({ whole }) => whole.count)));
    this.#rises = new Float64Array(this.#lights.length / 2);
  }

  /**
   * @param reach Distance from the edge of a cell at which light is sampled, in cells; 0.5 is the middle of the cell.
   * @param hidden Band of the code that is ignored.
   * @param needed Light times share that the caller requires. If it is not exceeded, the result is an agreement of zero.
   * @param given Light of the code if it is known, so that kinds and orientations of the same quad can be compared.
   */
  agreement(picture: Light, quad: Quad, kind: number, reach: number, hidden?: Band, needed = 0, given?: number): Agreement {
    const { whole, parts } = this.#kinds[kind];
    return this.#agreement(picture, quad, hidden === undefined ? whole : parts[hidden], reach, needed, given);
  }

  /** Computes the agreement of the outer edge alone, which is independent of kind and orientation of the code. */
  outerAgreement(picture: Light, quad: Quad, hidden?: Band, needed = 0): Agreement {
    return this.#agreement(picture, quad, hidden === undefined ? this.#outer.whole : this.#outer.parts[hidden], outerReach, needed);
  }

  #agreement(picture: Light, quad: Quad, steps: Steps, reach: number, needed: number, given?: number): Agreement {
    const seen = this.#seen;
    const points = steps.pointsAt(reach);
    const lights = this.#lights;
    const rises = this.#rises;
    const { count, riseCount, pairCount } = steps;
    setHomography(quad, seen);
    sampleLight(picture, seen, points, lights, 0, 2 * riseCount);
    for (let i = 0; i < riseCount; i++) rises[i] = lights[2 * i] - lights[2 * i + 1] || 0;
    const light = given ?? medianOf(rises, riseCount);
    // The share is at most 1.
    if (!(light > needed)) return none;
    // medianOf has moved the values that are at least as large as the light to the end. Steps that are not sampled yet are assumed to agree.
    const smaller = given === undefined ? riseCount >> 1 : riseCount;
    let sum = (riseCount - smaller + pairCount) * light;
    for (let i = 0; i < smaller; i++) sum += Math.max(-light, Math.min(rises[i], light));
    const most = riseCount + pairCount;
    const minSum = (1 - rounding) * needed * most;
    for (let first = riseCount; first < count; first += block) {
      if (sum < minSum) return none;
      const end = Math.min(count, first + block);
      sampleLight(picture, seen, points, lights, 2 * first, 2 * end);
      for (let i = first; i < end; i++) {
        const size = Math.min(Math.abs(lights[2 * i] - lights[2 * i + 1] || 0), light);
        sum -= i < riseCount + pairCount ? light - size : size;
      }
    }
    const share = sum / light / most;
    return light * share > needed ? { light, share } : none;
  }
}

const none: Agreement = { light: 0, share: 0 };

/** Number of steps that are sampled between two comparisons of the agreement with the needed one. */
const block = 8;
/** Bound of the relative rounding error of a sum. */
const rounding = 1e-9;

/** Steps of a code or of a part of it: first those at which the light rises, then those within pairs, then those without a change of light. */
class Steps {
  readonly count: number;
  readonly riseCount: number;
  readonly pairCount: number;
  readonly #steps: Step[];
  readonly #points = new Map<number, Float64Array>();

  constructor(steps: Step[]) {
    const [rises, pairs, levels] = [Expected.Rise, Expected.Pair, Expected.Level].map(kind => steps.filter(({ expected }) => expected === kind));
    this.#steps = [...rises, ...pairs, ...levels];
    this.count = steps.length;
    this.riseCount = rises.length;
    this.pairCount = pairs.length;
  }

  /** Returns the two points of each step at which light is sampled, the brighter one first. */
  pointsAt(reach: number): Float64Array {
    let points = this.#points.get(reach);
    if (!points) {
      points = Float64Array.from(this.#steps.flatMap(({ x, y, dx, dy }) => [x + reach * dx, y + reach * dy, x - reach * dx, y - reach * dy]));
      this.#points.set(reach, points);
    }
    return points;
  }
}

/** Returns the inward steps across the outer edge. */
function outerOf(side: number): Step[] {
  const edge = outer.inwards / side;
  const step = outer.length / side;
  const expected = Expected.Rise;
  return Array.from({ length: side }, (_, i) => (i + 0.5) / side).flatMap(along => [
    { x: edge, y: along, dx: step, dy: 0, expected },
    { x: 1 - edge, y: along, dx: -step, dy: 0, expected },
    { x: along, y: edge, dx: 0, dy: step, expected },
    { x: along, y: 1 - edge, dx: 0, dy: -step, expected },
  ]);
}

/** What a code looks like. The command line hands it over, so that there is one specification. */
export interface Pattern {
  /** Cells along one side. */
  side: number;
  /** Of each pair, the left cell's index; its right neighbour belongs to it. Of a pair, one cell is lit. */
  pairs: number[];
  /** Cells of the ring around the pairs, and by kind of code which of them are lit. */
  ring: number[];
  kinds: Record<string, boolean[]>;
}

/** How well levels agree with a kind of code, read with a corner of the quad as its first. */
export interface Agreement {
  kind: string;
  turns: number;
  /** How much brighter a lit cell is than a dark one, in the levels' unit. */
  light: number;
  /** Root mean square of what a scene that changes gently, and that light, do not explain. */
  rest: number;
}

/**
 * Explains levels by a scene that changes gently across the code plus the light of the lit cells. Of a pair, the mean is looked at:
 * it has half of the light, whichever of the two is lit and however many codes one exposure shows.
 */
export class Matcher {
  readonly #pattern: Pattern;
  readonly #kinds: { kind: string; solve: Float64Array[]; design: number[][] }[];
  readonly #turns: number[][];
  readonly #observed: Float64Array;

  constructor(pattern: Pattern) {
    this.#pattern = pattern;
    this.#kinds = Object.entries(pattern.kinds).map(([kind, lit]) => {
      const design = designOf(pattern, lit);
      return { kind, design, solve: pseudoInverse(design) };
    });
    this.#turns = [0, 1, 2, 3].map(turns => turnOf(pattern.side, turns));
    this.#observed = new Float64Array(pattern.ring.length + pattern.pairs.length);
  }

  get side(): number { return this.#pattern.side; }

  /** Levels as they are read when the quad is turned. */
  turned(levels: ArrayLike<number>, turns: number): number[] {
    return this.#turns[turns].map(cell => levels[cell]);
  }

  /** Agreement with each kind in each turn, the best first. */
  all(levels: ArrayLike<number>): Agreement[] {
    const found: Agreement[] = [];
    for (let turns = 0; turns < 4; turns++)
      for (let kind = 0; kind < this.#kinds.length; kind++) found.push(this.one(levels, kind, turns));
    return found.sort((a, b) => a.rest - b.rest);
  }

  one(levels: ArrayLike<number>, kindIndex: number, turns: number): Agreement {
    const { kind, solve, design } = this.#kinds[kindIndex];
    const cells = this.#turns[turns], { ring, pairs } = this.#pattern, y = this.#observed;
    for (let i = 0; i < ring.length; i++) y[i] = levels[cells[ring[i]]];
    for (let i = 0; i < pairs.length; i++) y[ring.length + i] = (levels[cells[pairs[i]]] + levels[cells[pairs[i] + 1]]) / 2;
    const found = solve.map(row => { let sum = 0; for (let i = 0; i < y.length; i++) sum += row[i] * y[i]; return sum; });
    let squares = 0;
    for (let i = 0; i < y.length; i++) {
      const row = design[i];
      let rest = y[i];
      for (let k = 0; k < row.length; k++) rest -= row[k] * found[k];
      squares += rest * rest;
    }
    return { kind, turns, light: found[0], rest: Math.sqrt(squares / y.length) };
  }

  kindIndex(kind: string): number { return this.#kinds.findIndex(k => k.kind === kind); }

  /**
   * Difference within the pairs, read in that turn: its mean, which says how sharp the code is, and its standard deviation, which is
   * small where all cells are where they are looked for.
   */
  contrast(levels: ArrayLike<number>, turns: number): { mean: number; spread: number } {
    const cells = this.#turns[turns], { pairs } = this.#pattern;
    let sum = 0, squares = 0;
    for (const cell of pairs) {
      const difference = Math.abs(levels[cells[cell]] - levels[cells[cell + 1]]);
      sum += difference;
      squares += difference * difference;
    }
    const mean = sum / pairs.length;
    return { mean, spread: Math.sqrt(Math.max(0, squares / pairs.length - mean * mean)) };
  }
}

/** For each observation: share of the light, then the scene, which bends at most as a parabola. */
function designOf({ side, pairs, ring }: Pattern, lit: boolean[]): number[][] {
  const at = (column: number, row: number, light: number) => {
    const x = column / (side - 1) - 0.5, y = row / (side - 1) - 0.5;
    return [light, 1, x, y, x * x, x * y, y * y];
  };
  return [
    ...ring.map((cell, i) => at(cell % side, Math.floor(cell / side), lit[i] ? 1 : 0)),
    ...pairs.map(cell => at(cell % side + 0.5, Math.floor(cell / side), 0.5)),
  ];
}

/** Rows that, times the observations, give the least-squares solution. */
function pseudoInverse(design: number[][]): Float64Array[] {
  const n = design[0].length;
  const rows = Array.from({ length: n }, (_, i) => [
    ...Array.from({ length: n }, (_, j) => design.reduce((sum, d) => sum + d[i] * d[j], 0)),
    ...design.map(d => d[i]),
  ]);
  for (let i = 0; i < n; i++) {
    const pivot = rows[i][i];
    for (let k = 0; k < rows[i].length; k++) rows[i][k] /= pivot;
    for (let j = 0; j < n; j++) {
      if (j === i) continue;
      const factor = rows[j][i];
      for (let k = 0; k < rows[j].length; k++) rows[j][k] -= factor * rows[i][k];
    }
  }
  return rows.map(row => Float64Array.from(row.slice(n)));
}

/** Where each cell of a code is found when the quad's corner of that turn is taken for its top left one. */
function turnOf(side: number, turns: number): number[] {
  let cells = Array.from({ length: side * side }, (_, i) => i);
  for (let t = 0; t < turns; t++) {
    // One more corner on, clockwise: the top row is then what was the right column, from its top.
    cells = cells.map((_, i) => cells[(i % side) * side + side - 1 - Math.floor(i / side)]);
  }
  return cells;
}

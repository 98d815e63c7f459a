/** Layout of a code. The command line sends it, so that it is specified in one place. */
export interface Pattern {
  /** Cells along one side. */
  side: number;
  /** Index of each pair's left cell; the right cell is its neighbour. Exactly one cell of a pair is lit. */
  pairs: number[];
  /** Cells of the ring around the pairs. */
  ring: number[];
  kinds: Record<string, Kind>;
}

/** A kind of code. */
export interface Kind {
  /** For each cell of the ring, whether it is lit. */
  lit: boolean[];
  /** Whether a lit cell is lit up to its edges; LEDs leave gaps. */
  isFilled: boolean;
}

/** Role of a cell, which is known before a code is read: dark, lit, or left or right in a pair. */
export enum Cell {
  Dark,
  Lit,
  Left,
  Right,
}

/** Expected step of light from a cell to its neighbour, for any value of the code: 0, the code's light, or that light up or down. */
export enum Expected {
  Level,
  Rise,
  Pair,
}

/** Expected step of light between two adjacent cells. Lengths are in sides of the code. */
export interface Step {
  /** Midpoint of the two samples, right and down from the top left corner. */
  x: number;
  y: number;
  /** Maximum distance between the two samples, towards the brighter cell. */
  dx: number;
  dy: number;
  expected: Expected;
}

/** Bands of a code that an object may hide: along its sides in the order of a quad's sides, and across its middle. */
export enum Band {
  Top,
  Right,
  Bottom,
  Left,
  Columns,
  Rows,
}

/** Width of a band, in sides of the code: a third, and at least the cells that it cuts. */
const bandWidth = 3 / 8;

/** Whether a point of the code is within a band. Lengths are in sides of the code, from its top left corner. */
export function isWithinBand(band: Band, x: number, y: number): boolean {
  const far = 1 - bandWidth;
  const isMiddle = (at: number) => Math.abs(at - 0.5) < bandWidth / 2;
  return [y < bandWidth, x > far, y > far, x < bandWidth, isMiddle(x), isMiddle(y)][band];
}

/** Returns the same band of a code whose corners start by a number of quarter turns later. */
export const turnedBand = (band: Band, turns: number): Band =>
  band >= Band.Columns ? (turns & 1 ? Band.Columns + Band.Rows - band : band) : (band - turns) & 3;

/** Returns the role of each cell of a code. Cells outside the code are dark. */
export function cellAt({ side, pairs, ring }: Pattern, { lit }: Kind): (row: number, column: number) => Cell {
  const cells = new Array<Cell>(side * side);
  ring.forEach((cell, i) => {
    cells[cell] = lit[i] ? Cell.Lit : Cell.Dark;
  });
  for (const cell of pairs) [cells[cell], cells[cell + 1]] = [Cell.Left, Cell.Right];
  return (row, column) => (row < 0 || column < 0 || row >= side || column >= side ? Cell.Dark : cells[row * side + column]);
}

/** Calls `visit` for each edge between adjacent cells, including the code's outer edge: with a cell and its right or lower neighbour. */
export function eachEdge(side: number, visit: (row: number, column: number, nextRow: number, nextColumn: number) => void): void {
  for (let line = 0; line <= side; line++)
    for (let at = 0; at < side; at++) {
      visit(at, line - 1, at, line);
      visit(line - 1, at, line, at);
    }
}

/**
 * Distance in cells from a code's edge at which light outside of it is sampled; inside, it is sampled in a cell's middle, at 0.5. The
 * housing around LEDs may be as narrow as half a gap between them, and the scene behind it may be brighter than the LEDs.
 */
const outside = 0.3;
/** Shift inwards and length of a step across the outer edge, in cells, that result from this distance. */
export const outer = { inwards: (0.5 - outside) / 2, length: 0.5 + outside };

/** Returns the expected steps of a kind of code. */
export function stepsOf(pattern: Pattern, kind: Kind): Step[] {
  const { side } = pattern;
  const steps: Step[] = [];
  const at = cellAt(pattern, kind);
  eachEdge(side, (row, column, nextRow, nextColumn) => {
    const expected = expectedBetween(at(row, column), at(nextRow, nextColumn));
    if (expected === null || (expected === Expected.Pair && row !== nextRow)) return;
    const sign = at(row, column) === Cell.Lit && expected === Expected.Rise ? -1 : 1;
    const isFromOutside = Math.min(row, column) < 0;
    const isOuter = isFromOutside || Math.max(nextRow, nextColumn) >= side;
    const { inwards, length } = isOuter && !kind.isFilled ? outer : { inwards: 0, length: 1 };
    const across = nextColumn - column;
    const down = nextRow - row;
    const moved = isFromOutside ? inwards : -inwards;
    steps.push({
      x: ((column + nextColumn + 1) / 2 + moved * across) / side,
      y: ((row + nextRow + 1) / 2 + moved * down) / side,
      dx: (sign * length * across) / side,
      dy: (sign * length * down) / side,
      expected,
    });
  });
  return steps;
}

function expectedBetween(a: Cell, b: Cell): Expected | null {
  if (a === Cell.Left && b === Cell.Right) return Expected.Pair;
  if (a > Cell.Lit || b > Cell.Lit) return null;
  return a === b ? Expected.Level : Expected.Rise;
}

/** Layout of a code. The command line sends it to this process, so that the layout is specified in one place only. */
export interface Pattern {
  /** Number of cells along one side. */
  side: number;
  /** Index of the left cell of each pair. The right cell is next to it. Exactly one cell of a pair is lit. */
  pairs: number[];
  /** Indices of the cells of the ring around the pairs. */
  ring: number[];
  kinds: Record<string, Kind>;
}

/** A kind of code. */
export interface Kind {
  /** Whether each cell of the ring is lit. */
  lit: boolean[];
  /** Whether cells are lit up to their edges. LEDs leave gaps. */
  isFilled: boolean;
}

/** Kind of a cell, which is known before the code is read: dark, lit, or the left or right cell of a pair. */
export enum Cell {
  Dark,
  Lit,
  Left,
  Right,
}

/**
 * Expected change in brightness from a cell to its neighbour, for every value of the code: none, an increase by the
 * brightness of a lit cell, or either an increase or a decrease by that amount.
 */
export enum Expected {
  Level,
  Rise,
  Pair,
}

/** Expected change of light between two adjacent cells. Lengths are relative to the side of the code. */
export interface Step {
  /** Middle between the two samples, to the right and down from the top left corner. */
  x: number;
  y: number;
  /** Vector from the darker to the brighter sample if both are as far from the edge as possible. */
  dx: number;
  dy: number;
  expected: Expected;
}

/**
 * Bands of a code that an object can hide: along each side, in the order of a quad's sides, and across the middle. Side bands have two widths: a third
 * and a half of the code.
 */
export enum Band {
  Top,
  Right,
  Bottom,
  Left,
  Columns,
  Rows,
  TopHalf,
  RightHalf,
  BottomHalf,
  LeftHalf,
}

/** All bands, the narrow ones first. */
export const bands = Array.from({ length: 10 }, (_, band) => band as Band);

export const isHalf = (band: Band) => band >= Band.TopHalf;

/** Width of a band relative to the side of the code: a third, rounded up to whole cells. */
const third = 3 / 8;
/** A half. The steps across the middle of the code are within the band, too. */
const half = 0.51;

/** Returns whether a point of the code is within a band. Lengths are relative to the side of the code, from its top left corner. */
export function isWithinBand(band: Band, x: number, y: number): boolean {
  const width = isHalf(band) ? half : third;
  const isMiddle = (at: number) => Math.abs(at - 0.5) < third / 2;
  const isInside = [y < width, x > 1 - width, y > 1 - width, x < width, isMiddle(x), isMiddle(y)];
  return isInside[isHalf(band) ? band - Band.TopHalf : band];
}

/** Returns a band as it is named after the first corner of the quad has moved by a number of quarter turns. */
export function turnedBand(band: Band, turns: number): Band {
  if (isHalf(band)) return ((band - Band.TopHalf - turns) & 3) + Band.TopHalf;
  if (band >= Band.Columns) return turns & 1 ? Band.Columns + Band.Rows - band : band;
  return (band - turns) & 3;
}

/** Returns a function that returns the kind of a cell of a code. Cells outside the code are dark. */
export function cellAt({ side, pairs, ring }: Pattern, { lit }: Kind): (row: number, column: number) => Cell {
  const cells = new Array<Cell>(side * side);
  ring.forEach((cell, i) => {
    cells[cell] = lit[i] ? Cell.Lit : Cell.Dark;
  });
  for (const cell of pairs) [cells[cell], cells[cell + 1]] = [Cell.Left, Cell.Right];
  return (row, column) => (row < 0 || column < 0 || row >= side || column >= side ? Cell.Dark : cells[row * side + column]);
}

/** Calls `visit` with each pair of adjacent cells, left and right or upper and lower, including those across the code's outer edge. */
export function eachEdge(side: number, visit: (row: number, column: number, nextRow: number, nextColumn: number) => void): void {
  for (let line = 0; line <= side; line++)
    for (let at = 0; at < side; at++) {
      visit(at, line - 1, at, line);
      visit(line - 1, at, line, at);
    }
}

/**
 * Distance from the outer edge of a code at which light outside the code is sampled, in cells. Inside, light is sampled in the middle of a
 * cell, at 0.5. The housing around LEDs can be as narrow as half a gap between LEDs, and the scene behind it can be brighter than the LEDs.
 */
const outside = 0.3;
/** Inward shift and length of a step across the outer edge, in cells, that follow from this distance. */
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

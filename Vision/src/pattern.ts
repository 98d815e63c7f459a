/** What a code looks like. The command line hands it over, so that there is one specification. */
export interface Pattern {
  /** Cells along one side. */
  side: number;
  /** Of each pair, the left cell's index; its right neighbour belongs to it. Of a pair, one cell is lit. */
  pairs: number[];
  /** Cells of the ring around the pairs. */
  ring: number[];
  kinds: Record<string, Kind>;
}

/** A kind of code. */
export interface Kind {
  /** Of the ring's cells, which are lit. */
  lit: boolean[];
  /** Whether a lit cell is lit up to its edges; LEDs leave gaps. */
  isFilled: boolean;
}

/** What cells are, as far as it is known before a code is read. */
export enum Cell { Dark, Lit, Left, Right }

/** Expected step from a cell to its neighbour, independent of the code's value: 0, the code's light, or that light up or down. */
export enum Expected { Level, Rise, Pair }

/** Cells that touch, of which it is known how their light differs. Lengths in sides of the code. */
export interface Step {
  /** Middle between where they are looked at, right and down from the top left corner. */
  x: number;
  y: number;
  /** From where one is looked at to where the other is, at most; towards the brighter one. */
  dx: number;
  dy: number;
  expected: Expected;
}

/** What each cell of a code is; around it all is dark. */
export function cellAt({ side, pairs, ring }: Pattern, { lit }: Kind): (row: number, column: number) => Cell {
  const cells = new Array<Cell>(side * side);
  ring.forEach((cell, i) => { cells[cell] = lit[i] ? Cell.Lit : Cell.Dark; });
  for (const cell of pairs) [cells[cell], cells[cell + 1]] = [Cell.Left, Cell.Right];
  return (row, column) => row < 0 || column < 0 || row >= side || column >= side ? Cell.Dark : cells[row * side + column];
}

/** All edges between neighbours, and those between the ring and what is around it: `visit` gets a cell and the one right of it, or below. */
export function eachEdge(side: number, visit: (row: number, column: number, nextRow: number, nextColumn: number) => void): void {
  for (let line = 0; line <= side; line++)
    for (let at = 0; at < side; at++) {
      visit(at, line - 1, at, line);
      visit(line - 1, at, line, at);
    }
}

/**
 * Around LEDs is a housing that may be no wider than half a gap between them, before a scene that may be brighter than they are. So of
 * steps from outside of a code, the outer light is looked at this near to the edge where the inner one is looked at in a cell's middle.
 */
const outside = 0.3;
/** For this purpose, a step is moved inwards by this distance and shortened to this length. */
export const outer = { inwards: (0.5 - outside) / 2, length: 0.5 + outside };

/** The steps of a kind of code that are known. */
export function stepsOf(pattern: Pattern, kind: Kind): Step[] {
  const { side } = pattern, steps: Step[] = [], at = cellAt(pattern, kind);
  eachEdge(side, (row, column, nextRow, nextColumn) => {
    const expected = expectedBetween(at(row, column), at(nextRow, nextColumn));
    if (expected === null || expected === Expected.Pair && row !== nextRow) return;
    const sign = at(row, column) === Cell.Lit && expected === Expected.Rise ? -1 : 1;
    const isFromOutside = Math.min(row, column) < 0, isOuter = isFromOutside || Math.max(nextRow, nextColumn) >= side;
    const { inwards, length } = isOuter && !kind.isFilled ? outer : { inwards: 0, length: 1 };
    const across = nextColumn - column, down = nextRow - row, moved = isFromOutside ? inwards : -inwards;
    steps.push({
      x: ((column + nextColumn + 1) / 2 + moved * across) / side, y: ((row + nextRow + 1) / 2 + moved * down) / side,
      dx: sign * length * across / side, dy: sign * length * down / side, expected,
    });
  });
  return steps;
}

function expectedBetween(a: Cell, b: Cell): Expected | null {
  if (a === Cell.Left && b === Cell.Right) return Expected.Pair;
  if (a > Cell.Lit || b > Cell.Lit) return null;
  return a === b ? Expected.Level : Expected.Rise;
}

// Encodes a control time as 8×8 lights. Nowpose.Latency.TimestampCode implements and documents the same code.
// Both are tested with led-matrix/timestamp-codes.csv of the manual.

/** Number of cells along one side. */
export const SIDE = 8;

/** Period of the codes, ms. */
export const PERIOD_MS = 65536;

const PAIRS = 18;
const PAIRS_PER_ROW = 3;

function parity(bits: number): number {
  let odd = 0;
  for (let rest = bits; rest !== 0; rest &= rest - 1) odd ^= 1;
  return odd;
}

function isLitRing(row: number, column: number): boolean {
  return row !== 0 || (column !== 1 && column !== 2);
}

/** Returns which cells of the control system's code are lit, row by row. @param value Time in whole milliseconds, 0 to 65535. */
export function controlCells(value: number): boolean[] {
  const gray = value ^ (value >> 1);
  const word = (gray << 2) | (parity(gray & 0x5555) << 1) | parity(gray & 0xaaaa);
  const cells = Array.from({ length: SIDE * SIDE }, (_, cell) => {
    const row = Math.floor(cell / SIDE);
    const column = cell % SIDE;
    const isRing = row === 0 || row === SIDE - 1 || column === 0 || column === SIDE - 1;
    return isRing && isLitRing(row, column);
  });
  for (let pair = 0; pair < PAIRS; pair++) {
    const isOne = ((word >> (PAIRS - 1 - pair)) & 1) !== 0;
    const left = (1 + Math.floor(pair / PAIRS_PER_ROW)) * SIDE + 1 + (pair % PAIRS_PER_ROW) * 2;
    cells[left] = isOne;
    cells[left + 1] = !isOne;
  }
  return cells;
}

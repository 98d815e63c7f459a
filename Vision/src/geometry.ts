/**
 * Corners of a code in the picture, px: x and y of the top left, top right, bottom right and bottom left corner of the upright code. The numbers are in
 * one array, because the search makes millions of quads.
 */
export type Quad = readonly [x0: number, y0: number, x1: number, y1: number, x2: number, y2: number, x3: number, y3: number];

/** A quad as it is sent to other processes: x and y of each corner. */
export type Corners = [x: number, y: number][];

export const cornersOf = (q: Quad): Corners => [0, 2, 4, 6].map(i => [q[i], q[i + 1]]);

/** Number of coefficients of a perspective map. They map u, v to x = (a u + b v + c) / (g u + h v + 1), y = (d u + e v + f) / (g u + h v + 1). */
export const coefficients = 8;

/** Sets `to` to the perspective map from the unit square to a quad (Heckbert 1989). u runs along the code's top edge, v along its left edge. */
export function setHomography([x0, y0, x1, y1, x2, y2, x3, y3]: Quad, to: Float64Array): void {
  const sx = x0 - x1 + x2 - x3;
  const sy = y0 - y1 + y2 - y3;
  const dx1 = x1 - x2;
  const dy1 = y1 - y2;
  const dx2 = x3 - x2;
  const dy2 = y3 - y2;
  const area = dx1 * dy2 - dx2 * dy1;
  const g = (sx * dy2 - dx2 * sy) / area;
  const h = (dx1 * sy - sx * dy1) / area;
  to[0] = x1 - x0 + g * x1;
  to[1] = x3 - x0 + h * x3;
  to[2] = x0;
  to[3] = y1 - y0 + g * y1;
  to[4] = y3 - y0 + h * y3;
  to[5] = y0;
  to[6] = g;
  to[7] = h;
}

/** Returns a quad with its corners in the order for a code that is rotated clockwise by a number of quarter turns. */
export function turned([x0, y0, x1, y1, x2, y2, x3, y3]: Quad, turns: number): Quad {
  if (turns === 0) return [x0, y0, x1, y1, x2, y2, x3, y3];
  if (turns === 1) return [x1, y1, x2, y2, x3, y3, x0, y0];
  if (turns === 2) return [x2, y2, x3, y3, x0, y0, x1, y1];
  return [x3, y3, x0, y0, x1, y1, x2, y2];
}

// Math.hypot takes ten times as long, because it also handles overflow.
const lengthOf = (x: number, y: number): number => Math.sqrt(x * x + y * y);

/** Length of the side that starts at a corner, px. */
export function sideOf(q: Quad, corner: number): number {
  const from = 2 * corner;
  const to = 2 * ((corner + 1) & 3);
  return lengthOf(q[from] - q[to], q[from + 1] - q[to + 1]);
}

/** Mean length of the sides, px. */
export const sizeOf = (q: Quad): number => (sideOf(q, 0) + sideOf(q, 1) + sideOf(q, 2) + sideOf(q, 3)) / 4;

const centreX = (q: Quad): number => (q[0] + q[2] + q[4] + q[6]) / 4;
const centreY = (q: Quad): number => (q[1] + q[3] + q[5] + q[7]) / 4;

export const scaled = (q: Quad, by: number): Quad => [q[0] * by, q[1] * by, q[2] * by, q[3] * by, q[4] * by, q[5] * by, q[6] * by, q[7] * by];

export const shiftedBy = (q: Quad, dx: number, dy: number): Quad => [
  q[0] + dx,
  q[1] + dy,
  q[2] + dx,
  q[3] + dy,
  q[4] + dx,
  q[5] + dy,
  q[6] + dx,
  q[7] + dy,
];

/** Maps each corner p to c + m (p - c), where c is the centre and m the matrix with the rows (a, b) and (-b, a). */
export function turnedAndScaled(q: Quad, a: number, b: number): Quad {
  const x = centreX(q);
  const y = centreY(q);
  const [x0, y0, x1, y1] = [q[0] - x, q[1] - y, q[2] - x, q[3] - y];
  const [x2, y2, x3, y3] = [q[4] - x, q[5] - y, q[6] - x, q[7] - y];
  return [
    x + x0 * a + y0 * b,
    y - x0 * b + y0 * a,
    x + x1 * a + y1 * b,
    y - x1 * b + y1 * a,
    x + x2 * a + y2 * b,
    y - x2 * b + y2 * a,
    x + x3 * a + y3 * b,
    y - x3 * b + y3 * a,
  ];
}

/** Scales a quad around its centre. */
export const grownBy = (q: Quad, factor: number): Quad => turnedAndScaled(q, factor, 0);

/** Returns a quad with one corner moved by a distance. */
export function withCorner(q: Quad, corner: number, dx: number, dy: number): Quad {
  const moved = [...q] as { -readonly [i in keyof Quad]: Quad[i] };
  moved[2 * corner] += dx;
  moved[2 * corner + 1] += dy;
  return moved;
}

/** Returns whether corresponding corners of two quads have at most a given distance. */
export function areNear(q: Quad, other: Quad, reach: number, turns = 0): boolean {
  for (let i = 0; i < 8; i += 2) {
    const j = (i + 2 * turns) & 7;
    if (!(lengthOf(q[i] - other[j], q[i + 1] - other[j + 1]) <= reach)) return false;
  }
  return true;
}

/**
 * Returns whether a quad is convex and clockwise (y down), its sides are at least `minSide` px long, and they differ no more than the sides of a code
 * that is seen at an angle.
 */
export function isPlausible(q: Quad, minSide: number): boolean {
  const sides = [sideOf(q, 0), sideOf(q, 1), sideOf(q, 2), sideOf(q, 3)];
  const shortest = Math.min(sides[0], sides[1], sides[2], sides[3]);
  const longest = Math.max(sides[0], sides[1], sides[2], sides[3]);
  if (shortest < minSide || longest > 2.5 * shortest) return false;
  for (let i = 0; i < 4; i++) {
    const [p, a, b] = [2 * i, (2 * i + 2) & 7, (2 * i + 4) & 7];
    const turn = (q[a] - q[p]) * (q[b + 1] - q[a + 1]) - (q[a + 1] - q[p + 1]) * (q[b] - q[a]);
    if (!(turn > 0.4 * sides[i] * sides[(i + 1) & 3])) return false;
  }
  return true;
}

/** Moves one side of a quad so that the adjacent sides become longer by a factor. The side has the index of its first corner. */
export function extendedBy(q: Quad, side: number, factor: number): Quad {
  const next = (side + 1) & 3;
  const longer = (moved: Quad, corner: number, fixed: number) =>
    withCorner(moved, corner, (factor - 1) * (q[2 * corner] - q[2 * fixed]), (factor - 1) * (q[2 * corner + 1] - q[2 * fixed + 1]));
  return longer(longer(q, side, (side + 3) & 3), next, (side + 2) & 3);
}

/** Returns whether the centres of two quads are so close that at most one of them can be a code. */
export const isWithin = (quad: Quad, other: Quad) =>
  lengthOf(centreX(quad) - centreX(other), centreY(quad) - centreY(other)) < 0.55 * Math.max(sizeOf(quad), sizeOf(other));

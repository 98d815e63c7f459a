export type Point = [x: number, y: number];

/** Corners of a code in the picture, px: top left, top right, bottom right and bottom left of the upright code. */
export type Quad = [Point, Point, Point, Point];

/** Maps u, v to x = (a u + b v + c) / (g u + h v + 1), y = (d u + e v + f) / (g u + h v + 1). */
export interface Homography {
  a: number;
  b: number;
  c: number;
  d: number;
  e: number;
  f: number;
  g: number;
  h: number;
}

/** Returns the perspective map from the unit square to a quad (Heckbert 1989). u runs along the code's top edge, v along its left edge. */
export function homography([p0, p1, p2, p3]: Quad): Homography {
  const sx = p0[0] - p1[0] + p2[0] - p3[0];
  const sy = p0[1] - p1[1] + p2[1] - p3[1];
  const dx1 = p1[0] - p2[0];
  const dy1 = p1[1] - p2[1];
  const dx2 = p3[0] - p2[0];
  const dy2 = p3[1] - p2[1];
  const area = dx1 * dy2 - dx2 * dy1;
  const g = (sx * dy2 - dx2 * sy) / area;
  const h = (dx1 * sy - sx * dy1) / area;
  return {
    a: p1[0] - p0[0] + g * p1[0],
    b: p3[0] - p0[0] + h * p3[0],
    c: p0[0],
    d: p1[1] - p0[1] + g * p1[1],
    e: p3[1] - p0[1] + h * p3[1],
    f: p0[1],
    g,
    h,
  };
}

/** Returns a quad with its corners in the order for a code that is rotated clockwise by a number of quarter turns. */
export const turned = (q: Quad, turns: number): Quad => [0, 1, 2, 3].map(i => q[(i + turns) & 3]) as Quad;

// Math.hypot takes ten times as long, because it also handles overflow.
export const distance = (a: Point, b: Point): number => Math.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2);

/** Mean length of the sides, px. */
export const sizeOf = ([a, b, c, d]: Quad): number => (distance(a, b) + distance(b, c) + distance(c, d) + distance(d, a)) / 4;

export const centreOf = ([a, b, c, d]: Quad): Point => [(a[0] + b[0] + c[0] + d[0]) / 4, (a[1] + b[1] + c[1] + d[1]) / 4];

/** Returns a quad with its corners transformed. Does not call `map`, because this function runs millions of times. */
export const mapped = ([a, b, c, d]: Quad, to: (p: Point) => Point): Quad => [to(a), to(b), to(c), to(d)];

export const scaled = (q: Quad, factor: number): Quad => mapped(q, p => [p[0] * factor, p[1] * factor]);

export const shiftedBy = (q: Quad, dx: number, dy: number): Quad => mapped(q, p => [p[0] + dx, p[1] + dy]);

/** Returns whether corresponding corners of two quads have at most a given distance. */
export const areNear = (q: Quad, other: Quad, reach: number, turns = 0): boolean =>
  distance(q[0], other[turns & 3]) <= reach
  && distance(q[1], other[(turns + 1) & 3]) <= reach
  && distance(q[2], other[(turns + 2) & 3]) <= reach
  && distance(q[3], other[(turns + 3) & 3]) <= reach;

/** Scales a quad around its centre. */
export function grownBy(q: Quad, factor: number): Quad {
  const [x, y] = centreOf(q);
  return mapped(q, p => [x + (p[0] - x) * factor, y + (p[1] - y) * factor]);
}

/**
 * Returns whether a quad is convex and clockwise (y down), its sides are at least `minSide` px long, and they differ no more than the sides of a code
 * that is seen at an angle.
 */
export function isPlausible(q: Quad, minSide: number): boolean {
  const sides = q.map((p, i) => distance(p, q[(i + 1) & 3]));
  if (Math.min(...sides) < minSide || Math.max(...sides) > 2.5 * Math.min(...sides)) return false;
  return q.every((p, i) => {
    const a = q[(i + 1) & 3];
    const b = q[(i + 2) & 3];
    const turn = (a[0] - p[0]) * (b[1] - a[1]) - (a[1] - p[1]) * (b[0] - a[0]);
    return turn > 0.4 * sides[i] * sides[(i + 1) & 3];
  });
}

/** Moves one side of a quad so that the adjacent sides become longer by a factor. The side has the index of its first corner. */
export function extendedBy(q: Quad, side: number, factor: number): Quad {
  const moved = (corner: number, fixed: number): Point => [
    q[fixed][0] + factor * (q[corner][0] - q[fixed][0]),
    q[fixed][1] + factor * (q[corner][1] - q[fixed][1]),
  ];
  const next = (side + 1) & 3;
  return q.map((p, i) => (i === side ? moved(i, (side + 3) & 3) : i === next ? moved(i, (side + 2) & 3) : p)) as Quad;
}

/** Returns whether the centres of two quads are so close that at most one of them can be a code. */
export const isWithin = (quad: Quad, other: Quad) => distance(centreOf(quad), centreOf(other)) < 0.55 * Math.max(sizeOf(quad), sizeOf(other));

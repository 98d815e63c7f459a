import { grownBy, shiftedBy, sizeOf, turnedAndScaled, withCorner, type Quad } from './geometry';

/** Changes a quad by a step of `by` px. */
type Move = (quad: Quad, by: number) => Quad;

const directions = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
];

const shifted =
  (dx: number, dy: number): Move =>
  (quad, by) =>
    shiftedBy(quad, dx * by, dy * by);

const cornered =
  (corner: number, dx: number, dy: number): Move =>
  (quad, by) =>
    withCorner(quad, corner, dx * by, dy * by);

const grown =
  (sign: number): Move =>
  (quad, by) =>
    grownBy(quad, 1 + (sign * 1.4 * by) / sizeOf(quad));

const rotated =
  (sign: number): Move =>
  (quad, by) => {
    const angle = (sign * 1.4 * by) / sizeOf(quad);
    return turnedAndScaled(quad, Math.cos(angle), -Math.sin(angle));
  };

/** Moves both corners of a side away from the opposite side or towards it. */
const edged =
  (side: number, sign: number): Move =>
  (quad, by) =>
    along(along(quad, side, (side + 3) & 3, sign * by), (side + 1) & 3, (side + 2) & 3, sign * by);

/** Moves a corner away from another one. */
function along(quad: Quad, corner: number, from: number, by: number): Quad {
  const dx = quad[2 * corner] - quad[2 * from];
  const dy = quad[2 * corner + 1] - quad[2 * from + 1];
  const length = Math.sqrt(dx * dx + dy * dy);
  return withCorner(quad, corner, (by * dx) / length, (by * dy) / length);
}

/** Moves, scales and deforms a quad. */
export const moves: Move[] = [
  ...directions.map(([dx, dy]) => shifted(dx, dy)),
  grown(1),
  grown(-1),
  rotated(1),
  rotated(-1),
  ...[0, 1, 2, 3].flatMap(side => [edged(side, 1), edged(side, -1)]),
  ...[0, 1, 2, 3].flatMap(corner => directions.map(([dx, dy]) => cornered(corner, dx, dy))),
];

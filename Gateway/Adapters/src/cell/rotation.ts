/** A rotation as the quaternion x, y, z, w. */
export type Quaternion = readonly [number, number, number, number];

export const IDENTITY: Quaternion = [0, 0, 0, 1];

/** Maximum difference of a read quaternion's length from 1: single precision and rounded decimals are allowed, other data are not. */
const MAX_LENGTH_ERROR = 0.01;

/** Gets the unit quaternion with this direction; null if the numbers are not those of a rotation. */
export function unit([x, y, z, w]: readonly number[]): Quaternion | null {
  const length = Math.hypot(x, y, z, w);
  return Math.abs(length - 1) <= MAX_LENGTH_ERROR ? [x / length, y / length, z / length, w / length] : null;
}

/** Gets the rotation of a vector, whose direction is the axis and whose length is the angle in rad. */
export function ofVector([x, y, z]: readonly number[]): Quaternion {
  const angle = Math.hypot(x, y, z);
  // The limit of sin(angle / 2) / angle for small angles.
  const factor = angle < 1e-9 ? 0.5 : Math.sin(angle / 2) / angle;
  return [x * factor, y * factor, z * factor, Math.cos(angle / 2)];
}

/**
 * Gets the rotation of three successive rotations about coordinate axes.
 * @param angles In rad.
 * @param order The axes in the order of the angles, such as "xyz".
 * @param isFixed Whether the axes are those of the parent; otherwise they turn with the preceding rotations.
 * @remarks Fixed axes: R = R₃ R₂ R₁. Moving axes: R = R₁ R₂ R₃.
 */
export function ofAngles(angles: readonly number[], order: string, isFixed: boolean): Quaternion {
  return angles.reduce<Quaternion>((before, angle, i) => {
    const turn = about(order[i], angle);
    return isFixed ? product(turn, before) : product(before, turn);
  }, IDENTITY);
}

function about(axis: string, angle: number): Quaternion {
  const sine = Math.sin(angle / 2);
  const part = (name: string): number => (axis === name ? sine : 0);
  return [part('x'), part('y'), part('z'), Math.cos(angle / 2)];
}

const product = ([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion => [
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
  aw * bw - ax * bx - ay * by - az * bz,
];

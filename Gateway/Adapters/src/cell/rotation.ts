/** A rotation as the quaternion x, y, z, w. */
export type Quaternion = readonly [number, number, number, number];

export const IDENTITY: Quaternion = [0, 0, 0, 1];

/** Maximum deviation of a quaternion's length from 1. Single precision and rounded decimals stay below it; other data do not. */
const MAX_LENGTH_ERROR = 0.01;

/** Normalises a quaternion; null if its length shows that the numbers are not a rotation. */
export function unit([x, y, z, w]: readonly number[]): Quaternion | null {
  const length = Math.hypot(x, y, z, w);
  return Math.abs(length - 1) <= MAX_LENGTH_ERROR ? [x / length, y / length, z / length, w / length] : null;
}

/** Gets the angle of the rotation from one orientation to another, in rad from 0 to π. */
export function angleBetween([ax, ay, az, aw]: Quaternion, [x, y, z, w]: Quaternion): number {
  // The vector part of the difference is precise also for small angles.
  const [dx, dy, dz, dw] = product([-ax, -ay, -az, aw], [x, y, z, w]);
  return 2 * Math.atan2(Math.hypot(dx, dy, dz), Math.abs(dw));
}

/** Gets the rotation for a rotation vector, whose direction is the axis and whose length is the angle in rad. */
export function ofVector([x, y, z]: readonly number[]): Quaternion {
  const angle = Math.hypot(x, y, z);
  // 0.5 is the limit of sin(angle / 2) / angle for small angles.
  const factor = angle < 1e-9 ? 0.5 : Math.sin(angle / 2) / angle;
  return [x * factor, y * factor, z * factor, Math.cos(angle / 2)];
}

/**
 * Gets the rotation that results from three successive rotations about coordinate axes.
 * @param angles Angles in rad.
 * @param order Axes in the order of the angles, such as "xyz".
 * @param isFixed Whether the axes are the fixed axes of the parent; otherwise they turn with the preceding rotations.
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

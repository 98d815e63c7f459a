export type Vector = readonly [number, number, number];

/** A pose: the columns x, y and z of its rotation matrix, and its position in m. */
export interface Rigid {
  x: Vector;
  y: Vector;
  z: Vector;
  at: Vector;
}

export const ORIGIN: Rigid = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], at: [0, 0, 0] };

export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const cross = ([a, b, c]: Vector, [d, e, f]: Vector): Vector => [b * f - c * e, c * d - a * f, a * e - b * d];

/** Returns a + factor · b. */
export const plus = (a: Vector, b: Vector, factor = 1): Vector => [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];

const turned = ({ x, y, z }: Rigid, [a, b, c]: Vector): Vector => plus(plus(plus([0, 0, 0], x, a), y, b), z, c);

/** Returns the product of two poses: converts pose b, which is given relative to frame a, to the frame in which a is given. */
export const times = (a: Rigid, b: Rigid): Rigid => ({ x: turned(a, b.x), y: turned(a, b.y), z: turned(a, b.z), at: plus(a.at, turned(a, b.at)) });

export function inverse({ x, y, z, at }: Rigid): Rigid {
  const rows = { x: [x[0], y[0], z[0]], y: [x[1], y[1], z[1]], z: [x[2], y[2], z[2]] } as const;
  return { ...rows, at: [-dot(x, at), -dot(y, at), -dot(z, at)] };
}

export const shift = (at: Vector): Rigid => ({ ...ORIGIN, at });

export function aboutX(angle: number): Rigid {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return { ...ORIGIN, y: [0, cosine, sine], z: [0, -sine, cosine] };
}

function aboutY(angle: number): Rigid {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return { ...ORIGIN, x: [cosine, 0, -sine], z: [sine, 0, cosine] };
}

export function aboutZ(angle: number): Rigid {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return { ...ORIGIN, x: [cosine, sine, 0], y: [-sine, cosine, 0] };
}

/** Converts roll, pitch and yaw of a URDF to a pose: rotations about the fixed axes x, y and z, in this order. */
export const ofRpy = ([roll, pitch, yaw]: Vector): Rigid => times(aboutZ(yaw), times(aboutY(pitch), aboutX(roll)));

/**
 * Converts a rotation to roll, pitch and yaw of a URDF.
 * @remarks Valid for a pitch that is not near a quarter turn, as in the descriptions of UR's arms.
 */
export const rpyOf = ({ x, y, z }: Rigid): Vector => [Math.atan2(y[2], z[2]), Math.asin(-x[2]), Math.atan2(x[1], x[0])];

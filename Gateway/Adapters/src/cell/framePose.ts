import type { Component, Frame } from '../configuration/frames';
import { refusalMessages } from '../messages/values';
import type { Refusal } from '../samples/stampRule';
import { type Pose, tooFar } from './messages';
import { IDENTITY, ofAngles, ofVector, type Quaternion, unit } from './rotation';

/** Maximum change of a component of a quaternion, or of a rotation vector in rad, between two samples. A larger one means that all signs have changed. */
const MAX_STEP = 1;

/** Value of `jump` for a number that must not be interpolated. */
export const STEP = 0;

/** Gets the indices of the values from which the pose of a frame is computed. */
export const valuesOf = ({ selector, position, rotation }: Frame): number[] =>
  [...(selector === null ? [] : [selector]), ...position, ...(rotation?.parts ?? [])].flatMap(part => ('value' in part ? [part.value] : []));

/**
 * Computes the pose of a frame; null if a number is missing, and a refusal if the numbers do not form a valid parent and rotation.
 * @param numberOf Gets the number of a value. Between two numbers that differ by more than `jump`, it must not interpolate.
 */
export function poseOf(
  { frame, parents, selector, position, scale, rotation }: Frame,
  numberOf: (value: number, jump: number) => number | null,
): Pose | Refusal | null {
  const found = (parts: Component[], jump: number): number[] | null => {
    const all = parts.map(part => ('constant' in part ? part.constant : numberOf(part.value, jump)));
    return all.includes(null) ? null : (all as number[]);
  };
  const place = found(position, Infinity);
  const parts = rotation === null ? [] : found(rotation.parts, maxStepOf(rotation));
  const [choice] = selector === null ? [0] : (found([selector], STEP) ?? [null]);
  if (place === null || parts === null || choice === null) return null;
  if (!Number.isInteger(choice) || choice < 0 || choice >= parents.length)
    return { reason: 'parent', text: refusalMessages.parent(choice, parents.length - 1) };
  const turned = turnOf(rotation, parts);
  if (turned === null) return { reason: 'not-unit', text: refusalMessages.quaternion(Math.hypot(...parts)) };
  const metres = place.map(value => value * scale);
  const far = tooFar(metres);
  if (far !== null) return far;
  return { frame, parent: parents[choice], position: metres, rotation: turned };
}

/** Gets the maximum change of a number of a rotation, in its own unit, that is interpolated. */
function maxStepOf(rotation: NonNullable<Frame['rotation']>): number {
  if (rotation.kind === 'quaternion') return MAX_STEP;
  return (rotation.kind === 'vector' ? MAX_STEP : Math.PI) / rotation.scale;
}

function turnOf(rotation: Frame['rotation'], parts: number[]): Quaternion | null {
  if (rotation === null) return IDENTITY;
  if (rotation.kind === 'quaternion') return unit(parts);
  const radians = parts.map(part => part * rotation.scale);
  return rotation.kind === 'vector' ? ofVector(radians) : ofAngles(radians, rotation.order, rotation.isFixed);
}

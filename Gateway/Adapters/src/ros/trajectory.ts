import { type Nanoseconds, ofRosTime, toRosTime } from '../times';
import type { JointNames } from './jointNames';

interface Point {
  positions?: unknown[];
  velocities?: unknown[];
  accelerations?: unknown[];
  time_from_start?: unknown;
}

interface Trajectory {
  header?: unknown;
  joint_names?: unknown[];
  points?: unknown[];
}

interface PassedTrajectory {
  header: { stamp?: unknown };
  joint_names: string[];
  points: object[];
}

const isPoint = (value: unknown): value is Point => typeof value === 'object' && value !== null;

/**
 * Gets the set-points of the forwarded joints; null if none of the joints is forwarded, the message is malformed, or a position is not a number. A
 * velocity or acceleration that is not a number becomes null, which means that it is unknown.
 */
export function passedTrajectory(message: Trajectory | null, names: JointNames): PassedTrajectory | null {
  const { header, joint_names: sources, points } = message ?? {};
  if (!Array.isArray(sources) || !Array.isArray(points) || !points.every(isPoint)) return null;
  if (typeof header !== 'object' || header === null) return null;
  const taken = sources.flatMap((source, i) => {
    const out = names.find(source);
    return out === undefined ? [] : [{ ...out, i }];
  });
  const column = (values: unknown[] | undefined, isPosition: boolean): (number | null)[] =>
    !Array.isArray(values) || values.length !== sources.length
      ? []
      : taken.map(({ i, scale, offset }) => {
          const value = (typeof values[i] === 'number' ? (values[i] as number) : NaN) * scale + (isPosition ? offset : 0);
          return Number.isFinite(value) ? value : null;
        });
  const passed = points.map(point => ({
    positions: column(point.positions, true),
    velocities: column(point.velocities, false),
    accelerations: column(point.accelerations, false),
    time_from_start: point.time_from_start,
  }));
  const isWhole = passed.every(({ positions }) => positions.length === taken.length && !positions.includes(null));
  return taken.length > 0 && isWhole ? { header, joint_names: taken.map(t => t.name), points: passed } : null;
}

/** Whether a trajectory begins when it arrives, which its stamp 0 means. */
export const beginsAtOnce = ({ header }: PassedTrajectory): boolean => ofRosTime(header.stamp) === 0n;

/** Replaces the stamp of a trajectory. */
export const beginningAt = (begin: Nanoseconds, { header, ...rest }: PassedTrajectory): object => ({
  header: { ...header, stamp: toRosTime(begin) },
  ...rest,
});

import type { Cycle } from './recipe';

const PLAYING = 2;
const RESUMING = 5;

const PROGRAM: Record<number, string> = { 0: 'stopping', 1: 'stopped', 2: 'playing', 3: 'pausing', 4: 'paused', 5: 'resuming' };

/** Safety modes in which no program moves the arm, with the remedy. The other modes are normal, or reduced in speed. */
const STOPS: Record<number, string> = {
  3: 'protective stop; find its cause, and release it on the teach pendant',
  4: 'recovery mode; move the arm back within its safety limits with Freedrive or the Move tab of the teach pendant',
  5: 'safeguard stop; close the safeguard and continue on the teach pendant',
  6: 'system emergency stop; release the emergency stop of the cell',
  7: 'robot emergency stop; release the button on the teach pendant',
  8: 'safety violation; read the log on the teach pendant and restart the robot',
  9: 'safety fault; read the log on the teach pendant and restart the controller',
  12: 'automatic mode safeguard stop; close the safeguard and continue on the teach pendant',
  13: 'three-position enabling stop; hold the enabling switch in its middle position',
};

/** Bits of safety_status_bits with their modes, in the order of how well they describe the stop. */
const STOP_BITS: [bit: number, mode: number][] = [
  [9, 9],
  [8, 8],
  [6, 7],
  [5, 6],
  [7, 6],
  [4, 5],
  [2, 3],
  [3, 4],
];

/** Robot modes in which the joints have no power, so that their angles are not measured. */
const WITHOUT_POWER: Record<number, string> = { [-1]: 'no controller', 0: 'disconnected', 1: 'confirm safety', 2: 'booting', 3: 'power off' };

export const programOf = ({ runtimeState }: Cycle): string | null =>
  runtimeState === null ? null : (PROGRAM[runtimeState] ?? `state ${runtimeState}`);

export const isProgramRunning = ({ runtimeState }: Cycle): boolean => runtimeState === null || runtimeState === PLAYING || runtimeState === RESUMING;

/** Gets the reason of a safety stop with the remedy; null if there is none. */
export function safetyStopOf({ safetyMode, safetyBits }: Cycle): string | null {
  const byMode = safetyMode === null ? undefined : STOPS[safetyMode];
  if (byMode !== undefined) return byMode;
  const stop = STOP_BITS.find(([bit]) => safetyBits !== null && ((safetyBits >>> bit) & 1) === 1);
  return stop === undefined ? null : STOPS[stop[1]];
}

/** Minimum change of an angle between two packages, in rad, that only a powered joint shows. */
const MOVED = 1e-4;

/** Determines whether the joints have power. Moving joints have it, independent of the reported mode. */
export class Power {
  #mode: number | null = null;
  #from: number[] = [];
  #hasMoved = false;

  /** Gets the reason why the angles are not measured; null if they are. */
  lackIn({ robotMode, positions }: Cycle): string | null {
    const lack = robotMode === null ? undefined : WITHOUT_POWER[robotMode];
    if (lack === undefined || robotMode !== this.#mode) {
      this.#mode = robotMode;
      this.#from = positions;
      this.#hasMoved = false;
    }
    this.#hasMoved ||= positions.some((position, i) => Math.abs(position - this.#from[i]) > MOVED);
    return lack === undefined || this.#hasMoved
      ? null
      : `the arm has no power (robot mode ${lack}), so its joint angles are not measured; ` + 'switch it on at the teach pendant';
  }
}

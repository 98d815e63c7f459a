import type { Cycle } from './recipe';
import { robotStateMessages, safetyStops } from '../messages/rtde';

const PLAYING = 2;
const RESUMING = 5;

const PROGRAM: Record<number, string> = { 0: 'stopping', 1: 'stopped', 2: 'playing', 3: 'pausing', 4: 'paused', 5: 'resuming' };

/** Bits of safety_status_bits and the corresponding safety modes. The first set bit describes the stop best. */
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

/** Robot modes in which the joints have no power, so that the controller does not measure their angles. */
const WITHOUT_POWER: Record<number, string> = { [-1]: 'no controller', 0: 'disconnected', 1: 'confirm safety', 2: 'booting', 3: 'power off' };

export const programOf = ({ runtimeState }: Cycle): string | null =>
  runtimeState === null ? null : (PROGRAM[runtimeState] ?? `state ${runtimeState}`);

export const isProgramRunning = ({ runtimeState }: Cycle): boolean => runtimeState === null || runtimeState === PLAYING || runtimeState === RESUMING;

/** Gets the reason for a safety stop, with the remedy; null without a safety stop. */
export function safetyStopOf({ safetyMode, safetyBits }: Cycle): string | null {
  const byMode = safetyMode === null ? undefined : safetyStops[safetyMode];
  if (byMode !== undefined) return byMode;
  const stop = STOP_BITS.find(([bit]) => safetyBits !== null && ((safetyBits >>> bit) & 1) === 1);
  return stop === undefined ? null : safetyStops[stop[1]];
}

/** Minimum change of an angle, in rad, that shows that a joint has power. */
const MOVED = 1e-4;

/** Determines whether the joints have power. Joints that move have power, even if the reported robot mode is one without power. */
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
    return lack === undefined || this.#hasMoved ? null : robotStateMessages.noPower(lack);
  }
}

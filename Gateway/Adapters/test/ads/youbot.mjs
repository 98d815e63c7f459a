// Defines the variables of a PLC that moves a youBot, and the true joint positions as functions of the PLC's time.
import { Plc } from './plc.mjs';
import { PlcSymbol } from './symbols.mjs';

export const arm = ['arm_joint_1', 'arm_joint_2', 'arm_joint_3', 'arm_joint_4', 'arm_joint_5'];

/** Returns the angle of an arm joint in rad. Each joint swings about the middle of its range, with its own frequency. */
export function angle(joint, nanoseconds) {
  const seconds = Number(nanoseconds % 3_600_000_000_000n) / 1e9;
  return [2.9, 1.1, -2.5, 1.7, 2.9][joint] + 0.4 * Math.sin(2 * Math.PI * (0.2 + 0.05 * joint) * seconds);
}

/** Returns the position of each finger in m. */
export function opening(nanoseconds) {
  return 0.005 + 0.004 * Math.sin(2 * Math.PI * 0.3 * Number(nanoseconds % 3_600_000_000_000n) / 1e9);
}

const degrees = 180 / Math.PI;
const secondsBefore2000 = 946_684_800n;

export function variables() {
  return [
    new PlcSymbol('GVL.aJoints', 'LREAL', time => arm.map((_, joint) => angle(joint, time)), { count: 5 }),
    new PlcSymbol('MAIN.fAxis1', 'LREAL', time => angle(0, time) * degrees),
    new PlcSymbol('MAIN.fAxis2', 'REAL', time => angle(1, time) * degrees),
    new PlcSymbol('MAIN.nEncoder3', 'DINT', time => Math.round(angle(2, time) * 1e6)),
    new PlcSymbol('MAIN.fGripper', 'LREAL', time => opening(time) * 1000),
    new PlcSymbol('MAIN.bOpen', 'BOOL', time => opening(time) > 0.005),
    new PlcSymbol('MAIN.sName', 'STRING', () => 'youBot'),
    new PlcSymbol('GVL.nTime', 'LINT', time => time),
    new PlcSymbol('GVL.nStoppedTime', 'LINT', () => 1_700_000_000_000_000_000n),
    new PlcSymbol('GVL.ftTime', 'T_FILETIME', time => time / 100n + 116444736000000000n),
    new PlcSymbol('GVL.fSeconds', 'LREAL', time => Number(time) / 1e9),
    new PlcSymbol('GVL.dtTime', 'DT', time => Number(time / 1_000_000_000n)),
    new PlcSymbol('TwinCAT_SystemInfoVarList._TaskInfo[1].DcTaskTime', 'LINT', time => time - secondsBefore2000 * 1_000_000_000n),
  ];
}

export const youBot = options => new Plc(variables(), options);

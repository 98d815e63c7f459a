// Runs the output of an adapter in virtual time.
import { parts } from './parts.mjs';

const { AdapterStatus, Log, JointOutput } = await parts('gateway/status', 'log', 'samples/jointOutput');

export const MS = 1_000_000n, S = 1000n * MS;
export const T = 1_700_000_000n * S;

/** Creates the output of an adapter. `time.ms` is the time since the start on all clocks, and `time.setBackMs` the step back of the control clock. */
export function plant(joints = [{ joint: 'a' }, { joint: 'b' }], options = {}) {
  const lines = [], sent = [], time = { ms: 0, setBackMs: 0 };
  const status = new AdapterStatus('opcua', new Log('plant/test', [], line => lines.push(line), () => {}), undefined,
    () => Number(T / MS) + time.ms);
  const clock = { get now() { return T + BigInt(time.ms - time.setBackMs) * MS; }, isSettled: true };
  const output = new JointOutput(joints.map(joint => ({ scale: 1, offset: 0, robot: '', name: joint.joint, ...joint })), { tolerance: MS, oldest: 10n * S, ...options },
    clock, { publish: (topic, msg) => sent.push(msg) }, status, () => time.ms);
  for (const { joint } of joints) status.joints.expect(joint);
  status.enter('connected');
  const value = (index, position) => output.publish([{ index, value: position, stamp: clock.now }]);
  const stateOf = joint => /^\w+/.exec(status.values()[`joint/${joint}`])[0];
  const cell = { output, status, clock, lines, sent, time, value, stateOf, faultMs: null };
  status.joints.changed = () => { if (status.values()[`joint/${joints[0]?.joint}`]?.startsWith('fault')) cell.faultMs ??= time.ms; };
  return cell;
}

/** Moves joint a at 1 rad/s for half a second and then sends no more values of this joint. Joint b keeps moving. */
export function moveAndStop(cell, seconds, hold = true) {
  for (; cell.time.ms < 1000 * seconds; cell.time.ms += 10) {
    const s = cell.time.ms / 1000;
    if (s < 0.5) cell.value(0, s < 0.1 ? 5 * s * s : s - 0.05);
    cell.value(1, Math.sin(s));
    if (hold) cell.output.hold(cell.clock.now - 10n * MS, 30n * MS, new Set([1]));
    cell.output.checkSilence();
  }
}

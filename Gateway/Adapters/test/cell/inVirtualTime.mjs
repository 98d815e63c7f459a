// Runs the adapters' output of frames and signals in virtual time.
import { parts } from '../parts.mjs';

const { AdapterStatus, Log, PlantOutput } = await parts('gateway/status', 'log', 'samples/plantOutput');

export const MS = 1_000_000n, S = 1000n * MS, T = 1_700_000_000n * S;

/**
 * Creates an output in virtual time. `values` are the labels of all values; `time.ms` is the time since the start on all clocks, and
 * `time.setBackMs` the step back of the control clock.
 */
export function cell({ joints = [], frames = [], wholeFrames = [], signals = [], values }, options = {}) {
  const sent = [], kept = [], keys = new Set(), time = { ms: 0, setBackMs: 0 };
  const status = new AdapterStatus('opcua', new Log('plant/test', [], () => {}, () => {}));
  const clock = { get now() { return T + BigInt(time.ms - time.setBackMs) * MS; }, isSettled: true };
  const gateway = {
    publish: (topic, msg) => sent.push([topic, msg]),
    publishNewest: (topic, next) => { for (let msg = next(); msg !== null; msg = next()) sent.push([topic, msg]); },
    publishKept: (topic, msg, key = topic) => {
      kept.push([topic, msg]);
      keys.add(key);
    },
    forgetKept: key => keys.delete(key),
  };
  const output = new PlantOutput({ joints, frames, wholeFrames, signals, values: values.map(label => ({ label })) }, { tolerance: MS / 2n, oldest: 10n * S, ...options },
    clock, gateway, status, () => time.ms);
  status.enter('connected');
  return {
    output, status, clock, gateway, sent, kept, keys, time,
    /** Publishes numbers, given by their indices, with the same time stamp. */
    take: (numbers, { stamp = clock.now, ...more } = {}) =>
      output.publish(Object.entries(numbers).map(([index, value]) => ({ index: Number(index), value, stamp, ...more }))),
    poses: () => sent.filter(([topic]) => topic === '/tf').flatMap(([, msg]) => msg.transforms).map(poseOf),
    changes: () => sent.filter(([topic]) => topic === '/signals').flatMap(([, { header, name, value }]) => name.map((one, i) => [one, value[i], stampOf(header)])),
    stateOf: key => status.values()[key]?.split(' ')[0],
  };
}

const stampOf = ({ stamp: { sec, nanosec } }) => (BigInt(sec) * S + BigInt(nanosec) - T) / MS;

const poseOf = ({ header, child_frame_id: frame, transform: { translation: { x, y, z }, rotation } }) => ({
  frame, parent: header.frame_id, ms: Number(stampOf(header)), position: [x, y, z], rotation: [rotation.x, rotation.y, rotation.z, rotation.w],
});

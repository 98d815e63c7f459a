import { el } from '../dom';

/** Explanations of the terms and units on this page, shown on hover. */
const TERMS: Record<string, string> = {
  'Clock within (µs)': 'Largest possible error of the headset’s estimate of the control clock, in microseconds (1 µs = 0.000001 s)',
  'Error (mm)': 'Distance between the tool as displayed and the tool as it was, with compensation, in millimetres',
  'Held (mm)': 'The same distance without compensation: the newest sample is shown unchanged',
  'Error reduction (%)': 'Share of the uncompensated error that compensation removes',
  'RTT (ms)': 'Round-trip time of one exchange of time stamps, in milliseconds',
  'L_app (ms)': 'Application latency: from the time a sample was taken to its arrival on the headset',
  'L_visu (ms)': 'Visualisation latency: from the start of a frame until its light reaches the eye',
  'Render time': 'Render time of the last frame, and whether it is in the range with constant latency',
  Pose: 'State of the displayed pose: current, coarse (the clock is known to the stated ±), or the reason why it is not current',
  'Current (%)': 'Share of frames with a current pose',
  Samples: 'Samples of joint positions that were received',
  Dropped: 'Messages that were not used',
  'Rate (Hz)': 'Samples per second (1 Hz = one per second)',
  Age: 'Control time minus the time stamp of the newest sample',
  Parent: 'The frame in which the pose is given: world, another object, or a link of a robot, such as the gripper that holds it',
  For: 'Time since the signal got this value',
  'Age at the gateway, median (ms)': 'Control time at the arrival minus the sample’s time stamp; half of the samples are younger',
  'P95 (ms)': '95 % of the samples are younger',
  Source: 'The adapter that reads the values; gateway is the gateway’s own cell, rosbridge another client',
  'Ahead of the control clock (ms)': 'This clock minus the control clock',
  'Skew (ppm)': 'Difference of the rates of this clock and the control clock in parts per million (1 ppm = 1 µs per second)',
  '± (µs)': 'Estimated error (±) of the gateway’s estimate of this clock, in microseconds; nearly all errors are smaller',
  'Error bound (µs)': 'Largest possible error of the estimate of this clock, in microseconds',
  'Resolution (µs)': 'The step by which this clock advances, in microseconds',
  'Sampling (ms)': 'Interval at which the control system takes samples, in milliseconds',
  Refused: 'Values that cannot be used',
  Reconnects: 'Connections after the first',
  Security: 'Encryption and signature of the connection',
  'together (ms)': 'Sum of the hops: the end-to-end latency from the sample to the display',
};

/** Returns a label, with its explanation on hover if there is one. */
export function term(label: string): Node | string {
  return label in TERMS ? el('abbr', { title: TERMS[label] }, label) : label;
}

/** Returns "coarse, ± 3 ms" for a coarse clock, and other states unchanged. */
export function stateWords(state: string, estimatedErrorUs: number | null | undefined, boundUs: number | null | undefined): string {
  const us = estimatedErrorUs ?? boundUs;
  return state === 'coarse' && us != null ? `coarse, ±\u00a0${Number((us / 1000).toPrecision(2))}\u00a0ms` : state;
}

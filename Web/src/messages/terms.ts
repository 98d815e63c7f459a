/** Labels of more than three words on the operations page. */
export const longLabels = {
  ageAtGateway: 'Age at the gateway, median (ms)',
  aheadOfControl: 'Ahead of the control clock (ms)',
  sources: 'Sources of joint positions',
  plantClocks: 'Clocks of the plant',
};

/** Explanations of terms and units on the operations page, by label. They are shown on hover. */
export const meanings: Record<string, string> = {
  'Clock within (µs)': 'Largest possible error of the headset’s estimate of the control clock, in microseconds (1 µs = 0.000001 s)',
  'Error (mm)': 'Distance between the displayed tool, with compensation, and its true position, in millimetres',
  'Held (mm)': 'Distance between the tool at the newest sample, without compensation, and its true position, in millimetres',
  'Error reduction (%)': 'Share of the uncompensated error that compensation removes',
  'RTT (ms)': 'Round-trip time of one exchange of time stamps, in milliseconds',
  'Render time': 'Render time of the last frame, and whether it is within the constant-latency range',
  Pose: 'State of the displayed pose: current, coarse (the clock has the stated error), or the reason why the pose is not current',
  'Current (%)': 'Share of frames with a current pose',
  Samples: 'Number of received samples of joint positions',
  Dropped: 'Messages that were received but not used',
  'Rate (Hz)': 'Samples per second (1 Hz = one per second)',
  Age: 'Control time minus the time stamp of the newest sample',
  Parent: 'Frame to which the pose refers: world, another object, or a link of a robot, such as the gripper that holds the object',
  For: 'Time for which the signal has had this value',
  [longLabels.ageAtGateway]: 'Control time of a sample’s arrival minus its time stamp; half of the samples are younger',
  'P95 (ms)': '95 % of the samples are younger',
  Source: 'Adapter that reads the values; “gateway” is the gateway itself, for example its simulated cell; “rosbridge” is another client',
  [longLabels.aheadOfControl]: 'This clock minus the control clock',
  'Skew (ppm)': 'Difference of the rates of this clock and the control clock in parts per million (1 ppm = 1 µs per second)',
  '± (µs)': 'Estimated error (±) of the gateway’s estimate of this clock, in microseconds; nearly all errors are smaller',
  'Error bound (µs)': 'Largest possible error of the estimate of this clock, in microseconds',
  'Resolution (µs)': 'The step by which this clock advances, in microseconds',
  'Sampling (ms)': 'Interval at which the control system takes samples, in milliseconds',
  Refused: 'Number of values that could not be used',
  Reconnects: 'Number of connections after the first one',
  Security: 'Encryption and signature of the connection',
  'total (ms)': 'Sum of the hops: the end-to-end latency from the sample to the display',
};

/** Terms that the pages explain on hover, with the beginning of their definitions. The keys are entries of docs/glossary.md. */
export const glossary: Record<string, string> = {
  'control clock': 'Master clock of the control system',
  offset: 'Headset clock minus control clock at the same moment',
  skew: 'Difference of the rates of the two clocks; positive when the headset clock runs faster',
  'round-trip time': 'Duration of an exchange minus the time at the gateway',
  'clock estimator': 'Computes offset and skew from the exchanges',
  'error bound': 'Limit of the error of the offset while the skew changes by less than 10 ppm within a minute',
  'sampling interval': 'Time between two samples',
  'application latency, L_app': 'Control time at which a sample arrives on the headset, minus its time stamp',
  'visualisation latency, L_visu':
    'Time from the computation of a frame’s pose, in the paper from the start of its render job (Fig. 10), until its light reaches the eye',
  'end-to-end latency, L': 'Time from the time stamp of a sample to the display time that shows it',
  'display time': 'Time at which the frame being built becomes visible',
  'render time': 'Duration of the last frame’s render job',
  'constant-latency range': 'Range of the render time in which L_visu is constant',
  'latency for head motion': 'Latency that remains for head motion after the display’s reprojection',
  hold: 'The newest sample that has arrived, shown unchanged: the uncompensated pose',
  predictor: 'Complete prediction method, selected by name',
  'tool error': 'Distance between the displayed and the true tool centre point',
  reduction: 'Share of the uncompensated RMS error that the prediction removes',
};

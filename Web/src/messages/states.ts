/** States of the gateway on the operations page. */
export const levelLabels = { ok: 'OK', warning: 'Warning', error: 'Fault', unknown: 'Not known' };

/** States of plants, clocks, headsets and events on the operations page. */
export const stateLabels = {
  notKnown: 'not known',
  notReported: 'not reported',
  none: 'none',
  active: 'active',
  ended: 'ended',
  event: (level: string, state: string) => `${level}, ${state}`,
  notConnected: 'not connected',
  silent: (time: string) => `silent for ${time}`,
  assumedAtRest: 'assumed at rest',
  uncertainRest: 'may not be at rest',
  coarse: (error: string) => `coarse, ±\u00a0${error}`,
  controlClock: 'control clock',
  measuredClock: 'measured against the control clock',
  inRange: 'in range',
  outOfRange: 'OUT OF RANGE',
  noRange: 'no range known',
};

/** Parts of the line with the state of the control clock. */
export const clockLabels = {
  ownClock: 'the gateway’s own',
  clockOf: (name: string) => `of ${name}`,
  error: (error: string) => `±\u00a0${error}`,
  bound: (bound: string) => `within ${bound}`,
};

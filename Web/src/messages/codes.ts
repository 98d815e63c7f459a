/** Text of the page that shows the control clock's code. */
export const clockCodeMessages = {
  measuring: 'Measuring the refresh rate.',
  errorBound: (boundMs: number) => `Error bound: ± ${boundMs.toFixed(1)} ms.`,
  monitor: (rateHz: number, meanMs: number, maxErrorMs: number) =>
    `Monitor: ${rateHz.toFixed(1)} Hz, L_monitor ≈ ${meanMs.toFixed(0)} ± ${maxErrorMs.toFixed(0)} ms plus the panel’s own delay.`,
};

/** Captions of the page that shows the control clock's code. */
export const clockCodeLabels = {
  notSynchronised: (reason: string) => `not synchronised: ${reason}`,
  controlTime: (seconds: string) => `C1 ${seconds} s`,
};

/** Reasons why the page shows no code. */
export const clockCodeReasons = {
  waiting: 'waiting for the gateway',
  noExchange: 'no exchange with the gateway yet',
  exchanges: (count: number, needed: number) => `${count} of ${needed} exchanges`,
  controlClock: 'the control clock itself is not synchronised',
  boundTooLarge: (boundMs: number, maxMs: number) =>
    `the error bound is ± ${boundMs.toFixed(1)} ms; it must be at most ± ${maxMs} ms; use a wired network or another browser`,
};

/** Text of the pairing page. */
export const pairingMessages = {
  /** @param maxMm Maximum edge of this code on A4 paper. */
  wide: (widthMm: number, maxMm: number) =>
    `With its white margin, this marker is ${Math.ceil(widthMm)} mm wide. A browser prints it too small on A4 paper: `
    + `use larger paper, such as A3, or an edge of at most ${maxMm} mm.`,
};

/** Captions of the codes on the pairing page. */
export const pairingLabels = {
  noEncryption: 'no encryption',
  key: (key: string) => `key ${key}`,
  showCode: 'Show the code',
  hideCode: 'Hide the code',
  validFor: (time: string) => `valid for ${time}, or until a headset has used it`,
  marker: (name: string, size: string, offset: string, modules: number, text: string) =>
    `${name} · edge of the code ${size} mm · ${offset === '' ? 'no pose' : `pose in the base frame ${offset} (m, °)`} · ${modules} modules · ${text}`,
};

/** Reasons why the pairing page draws no marker. */
export const pairingReasons = {
  poseInvalid: (fields: string) => `marker in the base frame: enter a number such as -0.25 for ${fields}`,
  poseIncomplete: (empty: string) => `marker in the base frame: enter ${empty}, or leave all six fields empty for a code without a pose`,
};

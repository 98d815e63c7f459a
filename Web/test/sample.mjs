// Artificial data of a run: a joint swings, samples arrive late, and the prediction follows. The seed makes failures reproducible.

export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const range = (count, f) => Array.from({ length: count }, (_, i) => f(i));

/** Position of a joint that alternately swings for one second and rests for half a second. */
function swing(t) {
  const phase = ((t % 3) + 3) % 3;
  const ease = x => (x <= 0 ? 0 : x >= 1 ? 1 : x * x * x * (10 - 15 * x + 6 * x * x));
  return 1.2 * (ease(phase) - ease(phase - 1.5));
}

export function report({ seconds = 20, fps = 60, seed = 1 } = {}) {
  const noise = random(seed);
  const latency = range(Math.ceil(seconds * 20), () => 0.085 + 0.05 * noise() + (noise() > 0.96 ? 0.06 : 0));
  const frames = range(Math.round(seconds * fps), i => i / fps);
  const truth = frames.map(swing);
  const received = frames.map(t => swing(Math.floor((t - latency[Math.min(latency.length - 1, Math.floor(t * 20))]) * 20) / 20));
  const predicted = frames.map((t, i) => truth[i] + 0.9 * (swing(t + 0.06) - 2 * swing(t) + swing(t - 0.06)) + 0.012 * (noise() - 0.5));
  const millimetres = signal => signal.map((v, i) => Math.abs(v - truth[i]) * 320);
  const hold = millimetres(received), compensated = millimetres(predicted);
  const speed = frames.map(t => Math.abs(swing(t + 0.005) - swing(t - 0.005)) * 100 * 320);
  const effective = error => error.map((e, i) => (speed[i] > 20 ? 1000 * e / speed[i] : 0));
  const age = frames.map((t, i) => 1000 * (t - Math.floor((t - latency[Math.min(latency.length - 1, Math.floor(t * 20))]) * 20) / 20) + i % 7);
  const sync = range(seconds * 5, i => i / 5);
  const bins = range(24, i => 60 + 5 * i);
  const maximum = v => v.reduce((a, b) => Math.max(a, b));
  const rms = v => Math.sqrt(v.reduce((a, b) => a + b * b, 0) / v.length);

  return {
    title: 'Nowpose: youBot over WiFi',
    subtitle: `${seconds} s at ${fps} frames per second, seed ${seed}`,
    settings: [['network', 'wifi'], ['robot', 'youbot'], ['predictor', 'quadratic'], ['sampling interval', '50 ms'],
      ['visualisation latency', '40 ms'], ['seed', seed]],
    summary: [
      { label: 'Tool error, RMS', unit: 'mm', uncompensated: rms(hold), compensated: rms(compensated) },
      { label: 'Tool error, maximum', unit: 'mm', uncompensated: maximum(hold), compensated: maximum(compensated) },
      { label: 'Latency as seen', unit: 'ms', uncompensated: 125.4, compensated: 2.1 },
    ],
    facts: [['frames', frames.length], ['samples', 398], ['samples dropped', 2], ['clock offset error P95', '212 µs'],
      ['frame time P50', '3.1 µs'], ['allocated per frame', '0 B'], ['total latency error P95', null]],
    error: { t: frames, hold, compensated },
    joint: {
      name: 'arm_joint_1',
      unit: 'rad',
      truth: { t: frames, v: truth },
      received: { t: range(seconds * 20, i => i / 20 + latency[i]), v: range(seconds * 20, i => swing(i / 20)) },
      predicted: { t: frames, v: predicted },
    },
    field: {
      hold: { latency_ms: age, speed },
      compensated: { latency_ms: effective(compensated), speed },
      iso_mm: [5, 10, 25, 50, 100, 200],
    },
    clock: {
      t: sync,
      offset_us: sync.map(t => 18 * t + 300 * Math.exp(-t / 2) * (noise() - 0.5)),
      error_us: sync.map(t => 900 * Math.exp(-t / 2) * (noise() - 0.5) + 120 * (noise() - 0.5)),
      bound_us: sync.map(t => 300 + 1500 * Math.exp(-t / 3)),
    },
    latency: {
      bin_ms: bins,
      count: bins.map(b => latency.filter(l => 1000 * l >= b && 1000 * l < b + 5).length),
      label: 'Application latency of the samples',
    },
  };
}

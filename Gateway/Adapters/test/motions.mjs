// Simulates motions of a joint, and a source that samples them and sends only changes. Units: s, rad and their derivatives.

/** Returns a motion that accelerates at `a` to the speed `v`, and from the time `brakeAt` decelerates at `brake` until it is at rest. */
export function trapezoid({ v, a, brakeAt, brake }) {
  const ramp = v / a, stop = v / brake;
  const rising = t => t < ramp ? a * t * t / 2 : v * (t - ramp / 2);
  return {
    end: brakeAt + stop,
    position: t => {
      if (t <= 0) return 0;
      if (t < brakeAt) return rising(t);
      const b = Math.min(t - brakeAt, stop);
      return rising(brakeAt) + v * b - brake * b * b / 2;
    },
  };
}

/** Returns a point-to-point motion with the peak speed `v`: a polynomial of degree 5, at rest and without acceleration at both ends. */
export function smooth({ v, duration }) {
  const length = v * duration / 1.875;
  return {
    end: duration,
    position: t => {
      const s = Math.min(1, Math.max(0, t / duration));
      return length * s * s * s * (10 + s * (6 * s - 15));
    },
  };
}

const gaussian = random => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());

/**
 * Generates the samples that a source sends of a motion from the time `from` to the time `until`.
 * @param interval Sampling interval. @param jitter Maximum delay of a sample as a fraction of `interval`; the time stamp contains the delay.
 * @param quantum Resolution of the value. @param deadband Largest change that is not sent. @param noise Standard deviation of the value.
 * @param stampError Maximum error of a time stamp. @param skip Fraction of the samples that are omitted.
 */
export function* changes({ position }, random, { from = -0.5, until, interval, jitter = 0, quantum = 0, deadband = 0, noise = 0, stampError = 0, skip = 0 }) {
  let sent = null;
  for (let look = from + interval * random(); look < until; look += interval) {
    if (skip > 0 && random() < skip) continue;
    const t = look + jitter * interval * random();
    const measured = position(t) + (noise > 0 ? noise * gaussian(random) : 0);
    const value = quantum > 0 ? quantum * Math.round(measured / quantum) : measured;
    if (sent !== null && Math.abs(value - sent) <= deadband) continue;
    sent = value;
    yield { time: t + stampError * (2 * random() - 1), value };
  }
}

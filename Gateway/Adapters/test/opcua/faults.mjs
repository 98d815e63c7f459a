// Causes faults in individual variables of a YoubotServer, and repairs them.
import { StatusCodes } from './library.mjs';

/** Minimum speed in rad/s at which a variable freezes. No axis can stop from this speed between two samples. */
const FAST = 0.4;

/** Returns a function that freezes the sent value as soon as the joint is faster than FAST, and then calls `done`. */
function frozen(done) {
  let before = null, last = null;
  return sent => {
    if (last !== null) return last;
    const seconds = before === null ? 0 : (sent.sourceTimestamp - before.sourceTimestamp) / 1000;
    const isFast = seconds > 0 && Math.abs(sent.value.value - before.value.value) > FAST * seconds;
    if (seconds > 0 || before === null) before = sent;
    if (!isFast) return sent;
    done();
    return last = sent;
  };
}

export class Faults {
  #writers = new Map();

  constructor(server) {
    server.spoil = (name, sent) => this.#writers.get(name)?.(sent) ?? sent;
  }

  stop(name) {
    return new Promise(resolve => this.#writers.set(name, frozen(resolve)));
  }

  bad(name) {
    this.#writers.set(name, sent => ({ ...sent, statusCode: StatusCodes.BadSensorFailure }));
  }

  repair(name) {
    this.#writers.delete(name);
  }
}

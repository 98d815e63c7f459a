// Runs asynchronous code in virtual time: a timer ends when nothing else is left to do before it.
import { setImmediate as idle } from 'node:timers/promises';

export class VirtualTime {
  /** Time since the start, ns. */
  now = 0n;
  #due = [];

  /** @param t Context of the test, which restores the timers afterwards. */
  constructor(t) {
    t.mock.method(globalThis, 'setTimeout', (then, ms) => this.#at(this.now + BigInt(Math.round(ms * 1e6)), then));
    t.mock.method(globalThis, 'clearTimeout', timer => { this.#due = this.#due.filter(one => one !== timer); });
  }

  /** Resolves at a time, ns. */
  until(time) {
    return new Promise(resolve => this.#at(time, resolve));
  }

  /** Lets the time pass until the promise is settled. */
  async run(promise) {
    let isSettled = false;
    const settled = promise.finally(() => { isSettled = true; });
    settled.catch(() => {});
    while (true) {
      await idle();
      if (isSettled || this.#due.length === 0) return settled;
      const next = this.#due.reduce((first, one) => (one.time < first.time ? one : first));
      this.#due = this.#due.filter(one => one !== next);
      if (next.time > this.now) this.now = next.time;
      next.then();
    }
  }

  #at(time, then) {
    const timer = { time, then };
    this.#due.push(timer);
    return timer;
  }
}

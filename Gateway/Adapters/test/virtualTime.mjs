// Runs asynchronous code in virtual time: a timer ends when nothing else is left to do before it, so a busy machine only makes a test slower.
import { Socket } from 'node:net';
import { setImmediate as idle } from 'node:timers/promises';

/** Length of the reading of a clock, ns, so that two readings return two times. */
const READING = 731n;

/** Time, ns, that passes with each turn of the event loop in which data arrive. */
const ARRIVAL = 100_000n;

/** Turns of the event loop without data on a socket after which no data are on their way. Data from this process arrive in the next turn. */
const QUIET_TURNS = 4;

/** Active resources that wait for a timer or for the other end. All others, such as the reading of a file, are work in progress. */
const WAITING = /^(Timeout|Immediate|MessagePort|(TCP|TCPServer|TCPSocket|Pipe|TTY|Signal|Process)(Wrap)?)$/;

/** The newest virtual time of this process; null before the first one. */
let newest = null;

const { setTimeout: later, clearTimeout: cancel } = globalThis;

/** Resolves before the next timer in virtual time, or after a real second if work does not end before it; or after 10 ms in real time. */
export const moment = () => new Promise(resolve => {
  if (!newest?.isCurrent) return setTimeout(resolve, 10);
  // A timer that remains would be one more resource to list in each later step.
  const limit = later(resolve, 1000);
  return newest.waiting.push(() => {
    cancel(limit);
    resolve();
  });
});

export class VirtualTime {
  /** Time since the start, ns. */
  now = 0n;
  /** Functions that are called before the next timer. */
  waiting = [];
  arrivals = 0;
  #due = [];

  /** @param t Context of the test, which restores the timers afterwards. */
  constructor(t) {
    // The context restores methods that it has mocked. The functions replace its mocks, which would record the stack of each call.
    for (const name of ['setTimeout', 'clearTimeout']) t.mock.method(globalThis, name);
    globalThis.setTimeout = (then, ms, ...more) => this.start(() => then(...more), ms);
    globalThis.clearTimeout = timer => {
      this.end(timer);
      cancel(timer);
    };
  }

  /**
   * Also replaces the intervals and clocks of this process, and lets the time pass until the end of the test. All ends of the test's connections must
   * be in this process, and no other test may run at the same time.
   */
  static ofProcess(t) {
    if (newest?.isCurrent) return newest;
    const begin = { elapsed: performance.now(), counter: process.hrtime.bigint(), date: Date.now() };
    if (newest === null) replaceClocks();
    newest = Object.assign(new VirtualTime(t), { begin, timeout: globalThis.setTimeout });
    void newest.#pass();
    return newest;
  }

  /** Whether the test has not ended: its context has not restored the timers. */
  get isCurrent() { return globalThis.setTimeout === this.timeout; }

  /** Calls a function after a time in ms, or at intervals of this length. */
  start(then, ms, isInterval = false) {
    const timer = this.#at(this.#after(ms), () => {
      if (isInterval) this.#due.push(Object.assign(timer, { time: this.#after(ms) }));
      then();
    });
    return timer;
  }

  end(timer) { this.#due = this.#due.filter(one => one !== timer); }

  /** Reads the time since the start, ns. */
  read() { return this.now += READING; }

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
      this.#step();
    }
  }

  async #pass() {
    while (this.isCurrent) {
      await this.#quiet();
      this.waiting.splice(0).forEach(each => each());
      await this.#quiet();
      if (this.isCurrent && this.#due.length > 0) this.#step();
    }
  }

  /** Resolves when all data have been read, and all work in progress is done; or when a timer is due because the data do not end. */
  #quiet() {
    return new Promise(resolve => {
      let turns = 0, seen = this.arrivals;
      const turn = () => {
        turns++;
        if (seen !== this.arrivals) {
          [turns, seen] = [0, this.arrivals];
          this.now += ARRIVAL;
          if (this.#due.some(({ time }) => time <= this.now)) return resolve();
        } else if (turns === QUIET_TURNS) {
          if (process.getActiveResourcesInfo().every(name => WAITING.test(name))) return resolve();
          turns = 0;
          return later(() => setImmediate(turn), 1);
        }
        return this.isCurrent ? setImmediate(turn) : resolve();
      };
      // Calls functions instead of awaiting promises, because the test runner tracks each promise, which takes longer than the turn.
      setImmediate(turn);
    });
  }

  #step() {
    const next = this.#due.reduce((first, one) => (one.time < first.time ? one : first));
    this.end(next);
    if (next.time > this.now) this.now = next.time;
    next.then();
  }

  #after(ms) { return this.now + BigInt(Math.round(Math.max(ms || 0, 0) * 1e6)); }

  #at(time, then) {
    const timer = { time, then, ref: () => timer, unref: () => timer, hasRef: () => true, refresh: () => timer };
    this.#due.push(timer);
    return timer;
  }
}

/** Replaces the intervals and clocks of this process by those of the newest virtual time while it is current. */
function replaceClocks() {
  const { setInterval, clearInterval, Date } = globalThis, { hrtime } = process, { push } = Socket.prototype;
  const elapsed = performance.now.bind(performance), counter = hrtime.bigint, date = Date.now;
  const inVirtual = (virtual, real) => (newest.isCurrent ? virtual(newest) : real());
  const ms = time => Number(time.read()) / 1e6, dateOf = time => Math.floor(time.begin.date + ms(time));
  globalThis.setInterval = (then, every, ...more) =>
    inVirtual(time => time.start(() => then(...more), every, true), () => setInterval(then, every, ...more));
  globalThis.clearInterval = timer => {
    newest.end(timer);
    clearInterval(timer);
  };
  performance.now = () => inVirtual(time => time.begin.elapsed + ms(time), elapsed);
  hrtime.bigint = () => inVirtual(time => time.begin.counter + time.read(), counter);
  Date.now = () => inVirtual(dateOf, date);
  globalThis.Date = new Proxy(Date, {
    construct: (target, parts, newTarget) => Reflect.construct(target, parts.length > 0 ? parts : [Date.now()], newTarget),
  });
  Socket.prototype.push = function (...data) {
    newest.arrivals++;
    return push.apply(this, data);
  };
}

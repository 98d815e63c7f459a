// Simulates the parts of a PLC that an ADS client can read: clock, task, variables and states.
import { performance } from 'node:perf_hooks';
import { error, group, state, words } from './frames.mjs';
import { symbolEntry } from './symbols.mjs';

/** Interval between 1601-01-01 and 1970-01-01, both UTC, in units of 100 ns. */
const fileTimeOf1970 = 116444736000000000n;

const fileTime = nanoseconds => nanoseconds / 100n + fileTimeOf1970;

export class Plc {
  #startedAt = performance.now();
  #startTime;
  #ppm;
  #symbols = [];
  #plcState = state.run;
  #stoppedAt;
  downloaded = new Set();

  /**
   * `variables` are PlcSymbols; their values change only from cycle to cycle. `aheadMs` is the time of the PLC's clock minus that of this
   * machine's clock at the start, `ppm` is the skew of the PLC's clock, and `cycleMs` is the cycle time of the PLC's task. `stampOf`
   * converts a time of the PLC, in nanoseconds since 1970, to the time stamp of a notification, in units of 100 ns.
   */
  constructor(variables, { aheadMs = 0, ppm = 0, cycleMs = 1, stampOf = time => fileTime(time) } = {}) {
    this.#startTime = BigInt(Math.round((Date.now() + aheadMs) * 1e6));
    this.#ppm = ppm;
    this.cycle = BigInt(Math.round(cycleMs * 1e6));
    this.stampOf = stampOf;
    this.version = 1;
    this.systemState = state.run;
    this.#place(variables, 0x1000);
  }

  get plcState() { return this.#plcState; }

  set plcState(next) {
    this.#plcState = next;
    this.#stoppedAt = this.cycleTime();
  }

  /** Returns the time of the PLC's clock in nanoseconds since 1970. */
  now() {
    const elapsed = (performance.now() - this.#startedAt) * (1 + this.#ppm * 1e-6);
    return this.#startTime + BigInt(Math.round(elapsed * 1e6));
  }

  /** Returns the start of the newest cycle that began before `time`, in nanoseconds since 1970. Cycles do not start at round times. */
  cycleTime(time = this.now()) {
    const phase = this.cycle * 3n / 7n / 100n * 100n;
    return time - (time - phase) % this.cycle;
  }

  /** Loads a new program: all variables move to other memory addresses, and handles to the old addresses become invalid. */
  download(variables) {
    this.version = this.version % 255 + 1;
    this.#place(variables, 0x1000 + 64 * this.version);
    for (const listener of this.downloaded) listener();
  }

  /** Loads a new program that has the same variables at the same memory addresses. Notifications of these addresses continue. */
  downloadInPlace() {
    this.version = this.version % 255 + 1;
  }

  #place(variables, first) {
    let offset = first;
    this.#symbols = variables;
    for (const variable of variables) {
      variable.offset = offset;
      offset += variable.size + 7 & ~7;
    }
  }

  /** Finds a variable or an element of an array by name. ADS ignores case. */
  find(name) {
    const [, path, index] = /^(.*?)(?:\[(-?\d+)\])?$/.exec(name);
    const named = text => this.#symbols.find(s => s.name.toLowerCase() === text.toLowerCase());
    return named(name) ?? (index === undefined ? undefined : named(path)?.element(Number(index)));
  }

  get names() {
    return this.#symbols.map(s => s.name);
  }

  get table() {
    return Buffer.concat(this.#symbols.map(s => symbolEntry(s, group.memory)));
  }

  get tableInfo() {
    return words(this.#symbols.length, this.table.length);
  }

  /**
  * Returns the bytes at a memory address as they are at `time`, the start of a cycle; or an ADS error. While the PLC is stopped, the
  * values do not change.
  */
  read(indexGroup, indexOffset, length, time = this.cycleTime()) {
    if (this.plcState !== state.run) time = this.#stoppedAt;
    if (indexGroup === group.symbolVersion) return Buffer.from([this.version]);
    if (indexGroup === group.deviceData) return this.#states().subarray(indexOffset, indexOffset + length);
    if (indexGroup === group.uploadInfo) return this.tableInfo;
    if (indexGroup === group.uploadInfo2) return Buffer.concat([this.tableInfo, words(0, 0, 0, 0)]);
    if (indexGroup === group.upload) return this.table.subarray(0, length);
    if (indexGroup !== group.memory) return error.invalidGroup;
    const symbol = this.#symbols.find(s => indexOffset >= s.offset && indexOffset < s.offset + s.size);
    if (!symbol) return error.invalidOffset;
    const bytes = symbol.image(time).subarray(indexOffset - symbol.offset);
    return bytes.length < length ? error.invalidSize : bytes.subarray(0, length);
  }

  #states() {
    const bytes = Buffer.alloc(4);
    bytes.writeUInt16LE(this.plcState, 0);
    return bytes;
  }
}

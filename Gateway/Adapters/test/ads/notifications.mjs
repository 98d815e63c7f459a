// Sends device notifications to the clients. A sample that is due in a cycle has the value of this cycle, even if this machine is late.
import { group, mode, notificationFrame } from './frames.mjs';

/** Longest interruption after which missed samples are still sent, in ns. After a longer interruption they are skipped. */
const longestCatchUp = 200_000_000n;

export class Notifications {
  /** Times of the samples in each sent packet, with the memory offsets of their variables. */
  sent = [];
  #plc;
  /** Sends a frame to the client. */
  send;
  #entries = new Map();
  #waiting = [];
  #next = 1;
  /** Handles that were freed. They are used again, the last one first. */
  #free = [];
  #timer;

  constructor(plc) {
    this.#plc = plc;
  }

  get count() {
    return this.#entries.size;
  }

  /** Adds a notification. Times are in units of 100 ns, as in the request. The first sample is taken in the next cycle. */
  add(client, server, { indexGroup, indexOffset, length, transmission, maxDelay, cycleTime }) {
    const interval = BigInt(cycleTime) * 100n;
    const whole = interval <= this.#plc.cycle ? this.#plc.cycle : interval - interval % this.#plc.cycle;
    const handle = this.#free.pop() ?? this.#next++;
    this.#entries.set(handle, {
      client, server, indexGroup, indexOffset, length, transmission, interval: whole,
      maxDelay: BigInt(maxDelay) * 100n, due: this.#plc.cycleTime() + this.#plc.cycle,
    });
    this.#timer ??= setInterval(() => this.#run(), Number(this.#plc.cycle) / 1e6);
    return handle;
  }

  remove(handle) {
    const isKnown = this.#entries.delete(handle);
    if (isKnown) this.#free.push(handle);
    return isKnown;
  }

  /** Removes the notifications of variables that have moved in memory. For each of them the client receives one sample without data. */
  invalidate() {
    for (const [handle, entry] of this.#entries) {
      if (entry.indexGroup !== group.memory) continue;
      this.#entries.delete(handle);
      this.#put(entry, handle, this.#plc.cycleTime(), Buffer.alloc(0));
    }
    this.#flush(true);
  }

  close() {
    clearInterval(this.#timer);
    this.#entries.clear();
  }

  #run() {
    const now = this.#plc.cycleTime();
    for (const [handle, entry] of this.#entries) {
      if (entry.due < now - longestCatchUp || entry.due > now + entry.interval + longestCatchUp) entry.due = now;
      for (; entry.due <= now; entry.due += entry.interval) this.#sample(handle, entry, entry.due);
    }
    this.#flush(false);
  }

  #sample(handle, entry, time) {
    const data = this.#plc.read(entry.indexGroup, entry.indexOffset, entry.length, time);
    if (typeof data === 'number') return;
    if (entry.transmission === mode.onChange && entry.last?.equals(data)) return;
    entry.last = data;
    this.#put(entry, handle, time, data);
  }

  #put(entry, handle, time, data) {
    this.#waiting.push({ entry, handle, time, data, until: time + entry.maxDelay });
  }

  /** Sends the waiting samples in one packet with one time stamp per cycle, as soon as one of them has reached its maximum delay. */
  #flush(atOnce) {
    const now = this.#plc.now();
    if (this.#waiting.length === 0 || !atOnce && !this.#waiting.some(w => w.until <= now)) return;
    const ready = this.#waiting.sort((a, b) => Number(a.time - b.time));
    this.#waiting = [];
    for (const [target, samples] of grouped(ready, w => w.entry.client.port)) {
      const stamps = [...grouped(samples, s => s.time)].map(([time, taken]) => ({
        stamp: this.#plc.stampOf(time), samples: taken.map(({ handle, data }) => ({ handle, data })),
      }));
      const { client, server } = samples[0].entry;
      this.sent.push(samples.map(({ time, entry }) => ({ time, offset: entry.indexOffset })));
      this.send(notificationFrame({ ...client, port: target }, server, stamps));
    }
  }
}

function grouped(items, keyOf) {
  const groups = new Map();
  for (const item of items) groups.set(keyOf(item), [...groups.get(keyOf(item)) ?? [], item]);
  return groups;
}

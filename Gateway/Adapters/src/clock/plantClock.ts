import { pause } from '../backoff';
import type { GatewayLink } from '../gateway/link';
import { monotonicTime, type Nanoseconds, NS_PER_MS, toRosTime } from '../times';
import { GatewayClock } from './gatewayClock';
import { Resolution } from './resolution';
import { clockMessages } from '../messages/gateway';

/** A reading of the control clock between two messages of the gateway. */
export interface ClockReading {
  /** t2 and t3 on the control clock; equal if one read returns one time. */
  received: Nanoseconds;
  sent: Nanoseconds;
  /** Resolution; if absent, it is determined from the times. */
  resolution?: Nanoseconds;
  /** Error bound of a clock that is itself an estimate. */
  errorBound?: Nanoseconds;
  synchronised?: boolean;
}

export type ReadClock = () => Promise<ClockReading>;

/** The plant answers, but its time does not advance. Identified by name, because each kind's bundle has its own class. */
export class ClockStopped extends Error {
  override readonly name = 'ClockStopped';

  constructor() {
    super(clockMessages.stopped);
  }
}

export const isClockStopped = (error: unknown): boolean => (error as Error | undefined)?.name === 'ClockStopped';

/** Limits of a resolution measurement. With enough changes of the time, a whole standstill lies between two of them. */
const MIN_READINGS = 16;
const MAX_READINGS = 64;
const CHANGES = 2;
const BETWEEN_READINGS_MS = 3;

/** A gateway does not synchronise with a coarser clock: with steps of 30 ms it takes two or three minutes, with 50 ms it never does. */
const COARSE: Nanoseconds = 50n * NS_PER_MS;

/** Interval of the measurements. A gateway reads the time too rarely to detect whether the clock stands still between updates. */
const MEASURE_EVERY: Nanoseconds = 20_000_000_000n;

/**
 * The control clock, which the gateway reads under the plant's name while the plant is connected. It is offered after the first successful
 * reading, because an offered clock may become C1 of all headsets, and they could not synchronise with a clock that has no reading.
 */
export class PlantClock {
  #read: ReadClock | null = null;
  #resolution = new Resolution();
  #ahead: Nanoseconds | null = null;
  #detached = new AbortController();
  #measured: Nanoseconds | null = null;
  #measuring: Promise<void> | null = null;
  readonly #gatewayClock: GatewayClock;
  /** Aborted when the plant's clock is offered. */
  readonly #offered = new AbortController();
  /** Resolves when the gateway's clock is known; null if it is not needed. */
  #without: Promise<void> | null = null;

  /**
   * @param fixedResolution The configured resolution; null to measure it.
   * @param counter Monotonic time of this machine, ns.
   * @param coarse Receives the resolution of the clock if it is too coarse for an accurate synchronisation, and null when it no longer is.
   */
  constructor(
    readonly gateway: Pick<GatewayLink, 'offer' | 'call'>,
    readonly name: string,
    readonly fixedResolution: Nanoseconds | null = null,
    readonly counter = monotonicTime,
    readonly coarse: (resolution: Nanoseconds | null) => void = () => {},
  ) {
    this.#gatewayClock = new GatewayClock(gateway, counter);
  }

  /** Whether the clock of the stamps is known. Before that, the gateway would interpret them as stamps of its own clock. */
  get isSettled(): boolean {
    return this.#offered.signal.aborted || this.#without !== null;
  }

  /** The approximate control time now, from the newest readings; null if there is none. */
  get now(): Nanoseconds | null {
    if (this.#ahead !== null) return this.counter() + this.#ahead;
    return this.#offered.signal.aborted ? null : this.#gatewayClock.now;
  }

  /** The resolution, ns; zero while unknown. */
  get resolution(): Nanoseconds {
    return this.fixedResolution ?? this.#resolution.value;
  }

  /** Resolves when no measurement of the resolution is running. */
  get settled(): Promise<void> {
    return this.#measuring ?? Promise.resolve();
  }

  /**
   * Reports that the plant is connected. Resolves when the resolution of its clock is known, because a wrong resolution would cause an error
   * of half of it. Resolves with false if the plant has disconnected by then.
   */
  async attach(read: ReadClock, stop: AbortSignal): Promise<boolean> {
    this.#detached = new AbortController();
    this.#resolution = new Resolution();
    this.#measured = null;
    const ended = AbortSignal.any([stop, this.#detached.signal]);
    await this.#measure(read, ended);
    if (ended.aborted) return false;
    this.#read = read;
    this.#offer();
    return true;
  }

  /**
   * Reports that the plant has no clock at present. Until it has one, its stamps are on the gateway's clock, which is read from the gateway.
   * Resolves when that clock is known, or at the stop.
   */
  doWithout(stop: AbortSignal): Promise<void> {
    this.#without ??= new Promise(resolve => {
      void this.#gatewayClock.run(AbortSignal.any([stop, this.#offered.signal]), resolve).then(resolve);
    });
    return this.#without;
  }

  /** Reports that the plant is disconnected, so its clock cannot be read. */
  detach(): void {
    this.#detached.abort();
    this.#read = null;
    this.#ahead = null;
  }

  /**
   * @throws ClockStopped The clock has shown the same time for more than a second.
   * @throws Error The plant is disconnected, or does not answer.
   */
  async read(): Promise<ClockReading> {
    if (this.#read === null) throw new Error(clockMessages.notConnected);
    const read = this.#read;
    const reading = await this.#observed(read);
    if (this.#resolution.isStopped) throw new ClockStopped();
    // An error of this measurement is reported by the next reading.
    if (this.#isToBeMeasured)
      this.#measuring ??= this.#measure(read, this.#detached.signal)
        .catch(() => {})
        .finally(() => {
          this.#measuring = null;
        });
    const resolution = reading.resolution ?? this.resolution;
    this.coarse(resolution >= COARSE ? resolution : null);
    return { ...reading, resolution };
  }

  #offer(): void {
    if (this.#offered.signal.aborted) return;
    this.#offered.abort();
    this.gateway.offer(`/nowpose/plant_time/${this.name}`, 'nowpose/PlantTime', async () => {
      const reading = await this.read();
      return {
        received: toRosTime(reading.received),
        sent: toRosTime(reading.sent),
        resolution_ns: Number(reading.resolution),
        error_bound_ns: Number(reading.errorBound ?? 0n),
        synchronised: reading.synchronised ?? true,
      };
    });
  }

  get #isToBeMeasured(): boolean {
    return this.#measured === null || this.counter() - this.#measured >= MEASURE_EVERY;
  }

  async #measure(read: ReadClock, stop: AbortSignal): Promise<void> {
    let changes = -1;
    let last: Nanoseconds | null = null;
    for (let i = 0; !this.#isMeasured(i, changes) && !stop.aborted; i++) {
      const reading = await this.#observed(read);
      if (this.#resolution.isStopped) return;
      if (this.fixedResolution !== null || reading.resolution !== undefined) break;
      if (reading.sent !== last) changes++;
      last = reading.sent;
      await pause(BETWEEN_READINGS_MS, stop);
    }
    this.#measured = this.counter();
  }

  #isMeasured(readings: number, changes: number): boolean {
    return readings >= MIN_READINGS && changes >= CHANGES && (this.#resolution.isKnown || readings >= MAX_READINGS);
  }

  async #observed(read: ReadClock): Promise<ClockReading> {
    const asked = this.counter();
    const reading = await read();
    const heard = this.counter();
    this.#resolution.observe(reading.sent, asked, heard);
    this.#ahead = (reading.received + reading.sent - asked - heard) / 2n;
    return reading;
  }
}

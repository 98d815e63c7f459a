import { pause } from '../backoff';
import type { GatewayLink } from '../gateway/link';
import { monotonicTime, type Nanoseconds, NS_PER_MS, toRosTime } from '../times';
import { Resolution } from './resolution';

/** The control clock as it was read between two messages of the gateway. */
export interface ClockReading {
  /** t2 and t3 on the control clock; equal where one read gives one time. */
  received: Nanoseconds;
  sent: Nanoseconds;
  /** Left out: found out from the times themselves. */
  resolution?: Nanoseconds;
  /** Of a clock that is itself an estimate. */
  errorBound?: Nanoseconds;
  synchronised?: boolean;
}

export type ReadClock = () => Promise<ClockReading>;

/** The plant answers, but the time it tells does not go on. Known by its name: each kind's bundle has a class of its own. */
export class ClockStopped extends Error {
  override readonly name = 'ClockStopped';

  constructor() {
    super('the clock stands still');
  }
}

export const isClockStopped = (error: unknown): boolean => (error as Error | undefined)?.name === 'ClockStopped';

/** A measurement of the resolution: enough readings, and changes of the time, for one whole standstill lies between two of them. */
const FEWEST_READINGS = 16, MOST_TO_KNOW = 64, CHANGES = 2, BETWEEN_READINGS_MS = 3;

/** A gateway that follows such a clock stays converging: in steps of 30 ms it is synchronised after two or three minutes, of 50 ms never. */
const COARSE: Nanoseconds = 50n * NS_PER_MS;

/** A gateway asks too seldom to tell a clock that stands from one that does not: the clock is looked at again. */
const MEASURE_EVERY: Nanoseconds = 20_000_000_000n;

/**
 * The control clock, which the gateway may ask for by the plant's name while the plant is there. It is offered when it can be read for the
 * first time: what is offered may become C1 of all headsets, and a clock that is not there would be a C1 that is never known.
 */
export class PlantClock {
  #read: ReadClock | null = null;
  #resolution = new Resolution();
  #ahead: Nanoseconds | null = null;
  #detached = new AbortController();
  #measured: Nanoseconds | null = null;
  #measuring: Promise<void> | null = null;
  #isOffered = false;
  #isMissing = false;

  /**
   * @param fixedResolution What the configuration says of it; null: found out.
   * @param counter Nanoseconds of this machine that never jump.
   * @param told Hears in which steps the clock goes on, when they are so large that who follows it hardly ever knows it well, and when not any more.
   */
  constructor(
    readonly gateway: Pick<GatewayLink, 'offer'>, readonly name: string, readonly fixedResolution: Nanoseconds | null = null,
    readonly counter = monotonicTime, readonly told: (coarse: Nanoseconds | null) => void = () => {},
  ) {}

  /** Whether it is known on whose clock stamps are: before, the gateway would take those of this clock for its own. */
  get isSettled(): boolean { return this.#isOffered || this.#isMissing; }

  /** What the control clock says about now, by its newest reading; null without one. To judge stamps by, not to make them. */
  get now(): Nanoseconds | null { return this.#ahead === null ? null : this.counter() + this.#ahead; }

  /** Nanoseconds; zero while unknown. */
  get resolution(): Nanoseconds { return this.fixedResolution ?? this.#resolution.value; }

  /** Ends when no measurement of the resolution is under way. */
  get settled(): Promise<void> { return this.#measuring ?? Promise.resolve(); }

  /**
   * The plant is there. Resolves when it is known how fine its clock is, for a gateway that was told wrongly would err by half of that;
   * with false when it is away again by then.
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

  /** The plant has none to be told, at least not yet: until one is, its stamps are on the gateway's. */
  doWithout(): void {
    this.#isMissing = true;
  }

  /** The plant is away: its clock cannot be told. */
  detach(): void {
    this.#detached.abort();
    this.#read = null;
    this.#ahead = null;
  }

  /**
   * @throws ClockStopped It has shown the same time for more than a second.
   * @throws Error The plant is away, or does not tell.
   */
  async read(): Promise<ClockReading> {
    if (this.#read === null) throw new Error('the plant is not connected');
    const read = this.#read, reading = await this.#observed(read);
    if (this.#resolution.isStopped) throw new ClockStopped();
    // Whoever asks next is told why, if the plant does not tell.
    if (this.#isToBeMeasured)
      this.#measuring ??= this.#measure(read, this.#detached.signal).catch(() => {}).finally(() => { this.#measuring = null; });
    const resolution = reading.resolution ?? this.resolution;
    this.told(resolution >= COARSE ? resolution : null);
    return { ...reading, resolution };
  }

  #offer(): void {
    if (this.#isOffered) return;
    this.#isOffered = true;
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

  get #isToBeMeasured(): boolean { return this.#measured === null || this.counter() - this.#measured >= MEASURE_EVERY; }

  async #measure(read: ReadClock, stop: AbortSignal): Promise<void> {
    let changes = -1, last: Nanoseconds | null = null;
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
    return readings >= FEWEST_READINGS && changes >= CHANGES && (this.#resolution.isKnown || readings >= MOST_TO_KNOW);
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

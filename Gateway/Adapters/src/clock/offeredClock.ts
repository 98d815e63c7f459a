import type { GatewayLink } from '../gateway/link';
import { monotonicTime, type Nanoseconds, NS_PER_MS, toRosTime } from '../times';
import { ClockBounds } from './clockBounds';
import { ClockStep } from './clockStep';
import { finePause } from './finePause';
import { GatewayClock } from './gatewayClock';
import { Resolution } from './resolution';
import { clockMessages } from '../messages/gateway';

/** A reading of the plant's clock, made between the request and the response. */
export interface ClockReading {
  /** Times t2 and t3 on the plant's clock. They are equal if the plant returns a single time. */
  received: Nanoseconds;
  sent: Nanoseconds;
  /** Resolution of the clock. If absent, it is determined from the times. */
  resolution?: Nanoseconds;
  /** Error bound, for a clock that is itself an estimate. */
  errorBound?: Nanoseconds;
  synchronised?: boolean;
}

export type ReadClock = () => Promise<ClockReading>;

/** The error for a plant that responds but whose time does not advance. Recognised by its name, because each bundle has its own class. */
class ClockStopped extends Error {
  override readonly name = 'ClockStopped';

  constructor() {
    super(clockMessages.stopped);
  }
}

export const isClockStopped = (error: unknown): boolean => (error as Error | undefined)?.name === 'ClockStopped';

/** Resolution at and above which a gateway no longer synchronises. With a resolution of 30 ms, the synchronisation takes two to three minutes. */
const COARSE: Nanoseconds = 50n * NS_PER_MS;

/** Number of consecutive failed readings that ends a resolution measurement. A slow connection delays some responses until after their timeout. */
const MAX_FAILED = 3;

/** Interval of the resolution measurements, which are needed because a gateway reads the time too rarely to detect standstills. */
const MEASURE_EVERY: Nanoseconds = 20_000_000_000n;

/**
 * The plant's clock, which the gateway reads by calling a service that has the plant's name. The service is offered only after the first successful
 * reading, because an offered clock may become the control clock, and headsets cannot synchronise with a clock that cannot be read.
 */
export class OfferedClock {
  #read: ReadClock | null = null;
  #atOnce = 1;
  #resolution = new Resolution();
  readonly #bounds = new ClockBounds();
  #detached = new AbortController();
  #measured: Nanoseconds | null = null;
  #measuring: Promise<void> | null = null;
  readonly #gatewayClock: GatewayClock;
  /** Called after the clock that stamps the values has stepped by more than a second, or has been replaced by another control clock. */
  stepped: () => void = () => {};
  /** Aborted when the plant's clock is offered. */
  readonly #offered = new AbortController();
  /** Resolves when the gateway's clock is known; null if the gateway's clock is not needed. */
  #without: Promise<void> | null = null;

  /**
   * @param fixedResolution The configured resolution; null to measure it.
   * @param counter Monotonic clock of this machine, ns.
   * @param coarse Called after each reading with the observed resolution if it is too coarse for the synchronisation, and with null otherwise.
   */
  constructor(
    readonly gateway: Pick<GatewayLink, 'offer' | 'call'>,
    readonly name: string,
    readonly fixedResolution: Nanoseconds | null = null,
    readonly counter = monotonicTime,
    readonly coarse: (resolution: Nanoseconds | null) => void = () => {},
  ) {
    this.#gatewayClock = new GatewayClock(gateway, counter, () => this.stepped());
  }

  /** Whether samples can be sent. Before the clock is offered, the gateway would interpret the stamps as times of its own clock. */
  get isSettled(): boolean {
    return this.#offered.signal.aborted || this.#without !== null;
  }

  /** The approximate current time on the clock that stamps the samples, from its newest readings; null before the first reading. */
  get now(): Nanoseconds | null {
    const { offset } = this.#bounds;
    if (offset !== null) return this.counter() + offset;
    return this.#offered.signal.aborted ? null : this.#gatewayClock.now;
  }

  /** The resolution, ns; zero while unknown. */
  get resolution(): Nanoseconds {
    return this.fixedResolution ?? this.#resolution.value;
  }

  /** Whether the clock has shown the newest time for more than a second. */
  get isStopped(): boolean {
    return this.#resolution.isStopped;
  }

  /** Resolves when no measurement of the resolution is running. */
  get settled(): Promise<void> {
    return this.#measuring ?? Promise.resolve();
  }

  /**
   * Offers the clock of a plant that has connected. First measures the clock's resolution, because an error of the resolution causes an offset error
   * of half its size. Resolves with false if the plant has disconnected in the meantime.
   * @param atOnce Maximum number of simultaneous calls of `read`.
   */
  async attach(read: ReadClock, stop: AbortSignal, atOnce = 1): Promise<boolean> {
    this.#detached = new AbortController();
    this.#atOnce = atOnce;
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
   * Stamps the values with the gateway's clock until the plant's clock is available. Resolves when the gateway's clock is known, or when the signal
   * is aborted.
   */
  doWithout(stop: AbortSignal): Promise<void> {
    this.#without ??= new Promise(resolve => {
      void this.#gatewayClock.run(AbortSignal.any([stop, this.#offered.signal]), resolve).then(resolve);
    });
    return this.#without;
  }

  /** Stops reading the clock, because the plant has disconnected. */
  detach(): void {
    this.#detached.abort();
    this.#read = null;
    this.#bounds.forget();
  }

  /**
   * Reads the clock, and starts a resolution measurement if one is due.
   * @throws ClockStopped The clock has shown the same time for more than a second.
   * @throws Error The plant is disconnected, or does not respond.
   */
  async read(): Promise<ClockReading> {
    if (this.#read === null) throw new Error(clockMessages.notConnected);
    const read = this.#read;
    const reading = await this.#observed(read);
    if (this.#resolution.isStopped) throw new ClockStopped();
    // Ignores an error of the measurement, because the next reading reports it.
    if (this.#isToBeMeasured)
      this.#measuring ??= this.#measure(read, this.#detached.signal)
        .catch(() => {})
        .finally(() => {
          this.#measuring = null;
        });
    const observed = reading.resolution ?? this.fixedResolution ?? this.#resolution.observed;
    this.coarse(observed >= COARSE ? observed : null);
    const errorBound = (reading.errorBound ?? 0n) + this.#resolution.hidden;
    return { ...reading, resolution: reading.resolution ?? this.resolution, errorBound };
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
    const asked = this.counter();
    const { resolution } = await this.#observed(read);
    if (this.fixedResolution === null && resolution === undefined) await this.#measureStep(read, stop, this.counter() - asked);
    if (!this.#resolution.isStopped) this.#measured = this.counter();
  }

  /** @param first Duration of a reading that no other reading delays, ns. */
  async #measureStep(read: ReadClock, stop: AbortSignal, first: Nanoseconds): Promise<void> {
    const step = new ClockStep(this.#atOnce > 1);
    const running: { asked: Nanoseconds; reading: Promise<void> }[] = [];
    let failed: { count: number; at: Nanoseconds; error: unknown } | null = null;
    const observe = async (asked: Nanoseconds): Promise<void> => {
      try {
        const { sent } = await this.#observed(read);
        step.observe(sent, asked, this.counter());
        failed = null;
      } catch (error) {
        step.interrupt();
        // Readings that were requested before the last failure have failed with it.
        if (failed === null || asked >= failed.at) failed = { count: (failed?.count ?? 0) + 1, at: this.counter(), error: failed?.error ?? error };
        if (failed.count >= MAX_FAILED) throw failed.error;
      }
    };
    for (let i = 1; !step.isMeasured(this.#resolution.isKnown) && !this.#resolution.isStopped && !stop.aborted; i++) {
      const asked = this.counter();
      const reading = observe(asked);
      reading.catch(() => {});
      running.push({ asked, reading });
      // A slow server must not get more requests than it can process, because they would delay its other messages.
      while (running.length >= this.#atOnce || (running.length > 0 && this.counter() - running[0].asked > 2n * first)) await running.shift()!.reading;
      // The two readings of a pair are as close together as possible, so that a clock with small steps shows two times with a small difference.
      if (i % 2 === 0) await finePause(step.pauseMs, stop, this.counter);
    }
    await Promise.all(running.map(one => one.reading));
    if (!this.#resolution.isStopped && !stop.aborted) this.#resolution.measured(step);
  }

  async #observed(read: ReadClock): Promise<ClockReading> {
    const asked = this.counter();
    const reading = await read();
    const heard = this.counter();
    this.#resolution.observe(reading.sent, asked, heard);
    // A stopped clock falls behind, but has not stepped.
    if (this.#resolution.isStopped) this.#bounds.forget();
    if (this.#bounds.observe(reading.received, reading.sent, asked, heard)) this.stepped();
    return reading;
  }
}

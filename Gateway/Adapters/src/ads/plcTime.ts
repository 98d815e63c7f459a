import type { ActiveSubscription, AdsSymbol } from 'ads-client';
import { READINGS_AT_ONCE } from '../clock/clockStep';
import type { ClockReading } from '../clock/offeredClock';
import type { TimeUnit } from '../samples/timeUnit';
import { afterArrivals } from '../sockets';
import { ofFileTime } from '../times';
import { timeOf } from './decoding';
import type { ReadOnlyClient } from './readOnlyClient';
import { adsMessages } from '../messages/ads';

const MAX_WAIT_MS = 1500;
const MAX_EARLY = 64;

/** The clock that stamps a PLC's values. */
export interface PlcTime {
  read(): Promise<ClockReading>;
  /** Maximum number of simultaneous calls of `read`. */
  readonly atOnce: number;
  /** Adds notifications so that the PLC, which may allow only some of them, still allows those of the clock. */
  reserving<T>(add: () => Promise<T>): Promise<T>;
  /** Takes the stamp of a notification whose handle does not belong to a configured value. */
  saw(handle: number, stamp: bigint): void;
}

/**
 * The clock that stamps notifications. After a subscription, the PLC samples, stamps and sends the first notification at once, so this stamp lies
 * between the request and the arrival of the notification. TwinCAT 3.1 also returns the time to a read request of index group 0xF088, which has not
 * been tested with a PLC.
 */
export class NotificationTime implements PlcTime {
  readonly atOnce = 1;
  readonly #waiting = new Map<number, (stamp: bigint) => void>();
  /** Stamps of unknown handles, because the first notification may arrive before the response that contains its handle. */
  readonly #early = new Map<number, bigint>();
  /** Handles of earlier requests. A late notification of an earlier request is ignored, even if the PLC uses its handle again. */
  readonly #former: number[] = [];
  #asking = 0;
  /** Ends with the newest request. The requests wait for each other, because the PLC may allow only one more notification. */
  #newest: Promise<unknown> = Promise.resolve();

  /** @param place Address of any symbol that supports notifications, preferably a configured one. */
  constructor(
    readonly client: ReadOnlyClient,
    readonly place: Pick<AdsSymbol, 'indexGroup' | 'indexOffset' | 'size'>,
  ) {}

  saw(handle: number, stamp: bigint): void {
    const take = this.#waiting.get(handle);
    if (take !== undefined) take(stamp);
    else if (this.#asking > 0 && !this.#former.includes(handle) && this.#early.size < MAX_EARLY && !this.#early.has(handle))
      this.#early.set(handle, stamp);
  }

  reserving<T>(add: () => Promise<T>): Promise<T> {
    return this.#after(async () => {
      const reserved = await this.#subscribe();
      return add().finally(() => reserved.unsubscribe());
    });
  }

  read(): Promise<ClockReading> {
    return this.#after(() => this.#read());
  }

  #after<T>(request: () => Promise<T>): Promise<T> {
    const result = this.#newest.then(request);
    this.#newest = result.catch(() => {});
    return result;
  }

  async #read(): Promise<ClockReading> {
    this.#asking++;
    const asked = await this.#subscribe().finally(() => {
      this.#asking--;
    });
    try {
      const time = ofFileTime(await this.#first(asked.notificationHandle));
      return { received: time, sent: time };
    } finally {
      this.#waiting.delete(asked.notificationHandle);
      if (this.#former.push(asked.notificationHandle) > MAX_EARLY) this.#former.shift();
      asked.unsubscribe().catch(() => {});
    }
  }

  #subscribe(): Promise<ActiveSubscription> {
    const { indexGroup, indexOffset, size } = this.place;
    const target = { indexGroup, indexOffset, size };
    return this.client.subscribe({ target, callback: () => {}, cycleTime: 0, sendOnChange: true, maxDelay: 0 });
  }

  #first(handle: number): Promise<bigint> {
    const early = this.#early.get(handle);
    if (this.#asking === 0) this.#early.clear();
    if (early !== undefined) return Promise.resolve(early);
    return new Promise((resolve, reject) => {
      // In each step of the event loop, ads-client takes one of the frames that have arrived, and parses it in the next step.
      const end = (): unknown => setImmediate(this.client.hasFrame ? end : () => reject(new Error(adsMessages.noNotification(MAX_WAIT_MS))));
      const cancel = afterArrivals(MAX_WAIT_MS, end);
      this.#waiting.set(handle, stamp => {
        cancel();
        resolve(stamp);
      });
    });
  }
}

/** The clock in a variable of the PLC. A task writes the variable once per cycle, so the resolution is one cycle. */
export class VariableTime implements PlcTime {
  readonly atOnce = READINGS_AT_ONCE;

  constructor(
    readonly client: ReadOnlyClient,
    readonly symbol: AdsSymbol,
    readonly unit: TimeUnit,
  ) {}

  saw(): void {}

  reserving<T>(add: () => Promise<T>): Promise<T> {
    return add();
  }

  async read(): Promise<ClockReading> {
    const { indexGroup, indexOffset, size, name } = this.symbol;
    const time = timeOf(this.symbol, this.unit, await this.client.readRaw(indexGroup, indexOffset, size));
    if (time === null) throw new Error(adsMessages.noTime(name));
    return { received: time, sent: time };
  }
}

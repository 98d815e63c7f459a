import { ADS, type AdsSymbol, type SubscriptionSettings } from 'ads-client';
import type { AdapterContext } from '../adapter';
import type { ClockReading } from '../clock/offeredClock';
import { delayOf, STAMP_LAG_MS, unconfirmedAfterMs } from '../samples/silentValues';
import type { TimeUnit } from '../samples/timeUnit';
import { type Nanoseconds, ofFileTime, ofMilliseconds } from '../times';
import { Cycles, type CycleValue } from './cycles';
import { numberOf, timeOf, unitOf } from './decoding';
import { NotificationTime, type PlcTime, VariableTime } from './plcTime';
import { ReadOnlyClient } from './readOnlyClient';
import { isAdsError, reasonOf } from './reasons';
import type { AdsSettings } from './kind';
import { SilentSymbols } from './silentSymbols';
import type { StampedSamples } from './stream';
import { findSymbol, type NamedSymbol, numberNeeded, stateNeeded, SymbolError, timeNeeded } from './symbols';
import { adsMessages } from '../messages/ads';

const RUN = 5;
const GOODBYE_MS = 500;

/** Address of the state of the runtime. It exists in every PLC, independently of the loaded program. */
const PLC_STATE = { indexGroup: ADS.ADS_RESERVED_INDEX_GROUPS.DeviceData, indexOffset: 0, size: 4 };

/** Interval in ms at which the PLC samples a symbol, and whether it sends only changes. */
type Sampled = Pick<SubscriptionSettings, 'cycleTime' | 'sendOnChange'>;

interface Watched {
  symbol: AdsSymbol;
  /** Index of the value; null for the time. */
  index: number | null;
  unsubscribe(): Promise<void>;
}

/** One connection to a PLC, from its first frame to its end. */
export class AdsSession {
  readonly #client: ReadOnlyClient;
  readonly #watched = new Map<number, Watched>();
  readonly #cycles: Cycles;
  #silent: SilentSymbols | null = null;
  #unit: TimeUnit = 'ns';
  #time: PlcTime | undefined;
  readonly #ended = new AbortController();
  #isReading = false;
  #isRunning = true;
  #end: (reason: string) => void = () => {};

  constructor(
    readonly context: AdapterContext,
    readonly settings: AdsSettings,
  ) {
    this.#client = new ReadOnlyClient(settings.endpoint, settings.local);
    this.#cycles = new Cycles(
      Math.ceil(settings.publishingMs / settings.samplingMs),
      (time, values) => this.#put(time, values),
      values => {
        for (const { index } of values)
          context.output.refuse(index, { reason: 'stamp-missing', text: adsMessages.noTimeOfCycle(settings.time!.symbol) });
      },
    );
  }

  /** Reads until the connection, the program or the adapter ends. Returns the reason, and whether waiting is unlikely to help. */
  async run(): Promise<{ reason: string; isRefused: boolean }> {
    const ended = new Promise<string>(resolve => {
      this.#end = resolve;
    });
    const { stopping } = this.context;
    const stop = (): void => this.#end('stopped');
    stopping.addEventListener('abort', stop);
    this.#listen();
    this.context.output.restart();
    try {
      const reason = await Promise.race([ended, this.#setUp().then(() => ended)]);
      return { reason, isRefused: false };
    } catch (error) {
      return { reason: this.#reasonOf(error), isRefused: error instanceof SymbolError };
    } finally {
      stopping.removeEventListener('abort', stop);
      this.#ended.abort();
      this.context.clock.detach();
      await this.#leave();
    }
  }

  #listen(): void {
    const client = this.#client;
    client.onSamples = stamps => this.#hear(stamps);
    client.on('connectionLost', () => this.#end(this.#whyLost()));
    client.on('plcSymbolVersionChange', () => this.#end(adsMessages.newProgram));
    client.on('plcRuntimeStateChange', () => this.#reportState());
  }

  async #setUp(): Promise<void> {
    await this.#client.connect();
    const { settings } = this;
    const symbols = await this.#findSymbols();
    const time = settings.time && (await this.#find(settings.time, timeNeeded));
    if (time !== null) this.#unit = settings.time!.unit ?? unitOf(time);
    this.#time =
      time === null
        ? new NotificationTime(this.#client, symbols.find(symbol => symbol !== null) ?? PLC_STATE)
        : new VariableTime(this.#client, time, this.#unit);
    // Subscribes to the time first. The PLC counts the cycles of a notification from its addition, and the time must be sampled in every cycle.
    if (time !== null) await this.#watch(time, null, { cycleTime: 0, sendOnChange: false });
    const sampled = { cycleTime: settings.samplingMs, sendOnChange: settings.isOnChange };
    this.#watchSilence(symbols, await this.#time.reserving(() => this.#watchAll(symbols, sampled)), sampled);
    this.#isReading = true;
    this.#reportState();
  }

  /**
   * Gets the configured symbols; null for a symbol that the PLC does not have or that is not usable, so that the others can be read. Rejects if no
   * symbol is usable, or if a request fails for another reason.
   */
  async #findSymbols(): Promise<(AdsSymbol | null)[]> {
    const found = await Promise.allSettled(
      this.settings.values.map((named, index) => this.#find(named, this.#isSignal(index) ? stateNeeded : numberNeeded)),
    );
    const failed = found.filter(result => result.status === 'rejected');
    const fatal = failed.find(({ reason }) => !(reason instanceof SymbolError)) ?? (failed.length === found.length ? failed[0] : undefined);
    if (fatal !== undefined) throw fatal.reason;
    return found.map((result, index) => {
      if (result.status === 'fulfilled') return result.value;
      this.context.output.lose(index, { reason: 'not-readable', text: (result.reason as Error).message });
      return null;
    });
  }

  /**
   * Subscribes to the symbols. Gets those whose notifications the PLC refuses, so that the others can be read. Rejects if the PLC refuses all of them,
   * or if a request fails for another reason.
   */
  async #watchAll(symbols: (AdsSymbol | null)[], sampled: Sampled): Promise<Map<number, unknown>> {
    const refused = new Map<number, unknown>();
    const found = symbols.flatMap((symbol, index) => (symbol === null ? [] : [{ symbol, index }]));
    await Promise.all(
      found.map(({ symbol, index }) =>
        this.#watch(symbol, index, sampled).catch(error => {
          if (!isAdsError(error)) throw error;
          refused.set(index, error);
        }),
      ),
    );
    if (refused.size > 0 && refused.size === found.length) throw [...refused.values()][0];
    return refused;
  }

  #watchSilence(symbols: (AdsSymbol | null)[], refused: Map<number, unknown>, sampled: Sampled): void {
    const { output, clock } = this.context;
    const { samplingMs, isOnChange } = this.settings;
    const delayMs = delayOf(this.settings);
    output.samplingS = samplingMs / 1000;
    output.unconfirmedMs = unconfirmedAfterMs(delayMs);
    this.#silent = new SilentSymbols(
      symbols.map(symbol => symbol !== null),
      delayMs,
      isOnChange,
      {
        isRunning: () => this.#isRunning,
        read: async index => {
          const symbol = symbols[index]!;
          const { indexGroup, indexOffset, size } = symbol;
          return numberOf(symbol, await this.#client.readRaw(indexGroup, indexOffset, size));
        },
        confirm: (confirmed, agoMs) => {
          const { now } = clock;
          const others = symbols.flatMap((_, index) => (confirmed.has(index) ? [] : [index]));
          // While the program is stopped, its clock is unknown.
          if (now === null) return;
          output.hold(now - ofMilliseconds(agoMs + STAMP_LAG_MS + samplingMs), ofMilliseconds(3 * samplingMs), new Set(others));
        },
        lose: (index, error, isSubscription) => {
          const inWords = isSubscription && isAdsError(error) ? adsMessages.notNotified : adsMessages.notReadable;
          output.lose(index, { reason: 'not-readable', text: inWords(this.settings.values[index].symbol, this.#reasonOf(error)) });
        },
        renew: async (index, value) => {
          for (const [handle, watched] of this.#watched) {
            if (watched.index !== index) continue;
            this.#watched.delete(handle);
            watched.unsubscribe().catch(() => {});
          }
          await this.#time!.reserving(() => this.#watch(symbols[index]!, index, sampled));
          // Publishes the value that was read, because the first notification may arrive before its handle is known, and a value at rest
          // receives no other notification.
          this.#put(null, [{ index, value, isFirst: true }]);
        },
      },
    );
    for (const [index, error] of refused) this.#silent.refuse(index, error);
    void this.#silent.run(AbortSignal.any([this.context.stopping, this.#ended.signal]));
  }

  /** Whether the value is a signal, which may be a BOOL. */
  #isSignal(index: number): boolean {
    const { values, signals } = this.context.configuration;
    return index >= values.length - signals.length;
  }

  #find(named: NamedSymbol, objection: (found: AdsSymbol) => string | undefined): Promise<AdsSymbol> {
    return findSymbol(this.#client, this.context.configuration.file, named, objection);
  }

  async #watch(symbol: AdsSymbol, index: number | null, when: Sampled): Promise<void> {
    const { indexGroup, indexOffset, size } = symbol;
    const { samplingMs, publishingMs } = this.settings;
    const subscription = await this.#client.subscribe({
      ...when,
      target: { indexGroup, indexOffset, size },
      callback: () => {},
      maxDelay: publishingMs > samplingMs ? publishingMs : 0,
    });
    this.#watched.set(subscription.notificationHandle, { symbol, index, unsubscribe: () => subscription.unsubscribe() });
  }

  #hear(stamps: StampedSamples[]): void {
    for (const { stamp, samples } of stamps) {
      const values: CycleValue[] = [];
      let time: Nanoseconds | null | undefined;
      for (const { handle, data } of samples) {
        const watched = this.#watched.get(handle);
        if (watched === undefined) {
          this.#time?.saw(handle, stamp);
          continue;
        }
        const { symbol, index } = watched;
        if (data.length < symbol.size) return this.#end(adsMessages.moved(symbol.name));
        if (index === null) time = timeOf(symbol, this.#unit, data);
        else {
          values.push({ index, value: numberOf(symbol, data) });
          this.#silent?.heard(index, values.at(-1)!.value);
        }
      }
      if (this.settings.time !== null) this.#cycles.add(stamp, values, time);
      else if (values.length > 0) this.#put(stamp === 0n ? null : ofFileTime(stamp), values);
    }
  }

  #put(stamp: Nanoseconds | null, values: CycleValue[]): void {
    const { isOnChange, samplingMs, publishingMs } = this.settings;
    // All changes with earlier stamps have already arrived, so a value without a change was unchanged up to this stamp.
    if (isOnChange && stamp !== null && this.#isRunning)
      this.context.output.hold(stamp - ofMilliseconds(samplingMs + publishingMs), ofMilliseconds(3 * samplingMs), new Set(values.map(v => v.index)));
    if (this.#isRunning) return this.context.output.publish(values.map(value => ({ ...value, stamp })));
    for (const { index } of values) {
      this.context.output.refuse(index, { reason: 'plc-stopped', text: adsMessages.valuesStopped });
      this.#silent?.discard(index);
    }
  }

  #reportState(): void {
    const { adsState, adsStateStr } = this.#client.metaData.plcRuntimeState ?? { adsState: RUN };
    this.#isRunning = adsState === RUN;
    // While the session leaves, the PLC may still report its states.
    if (!this.#isReading || this.#ended.signal.aborted) return;
    if (this.#isRunning) {
      this.context.status.enter('connected');
      void this.#attachClock();
    } else {
      this.context.status.enter('waiting', adsMessages.programState(String(adsStateStr)));
      this.context.clock.detach();
    }
  }

  async #attachClock(): Promise<void> {
    const read = (): Promise<ClockReading> => {
      if (!this.#isRunning) throw new Error(adsMessages.programStopped);
      return this.#time!.read();
    };
    try {
      const { clock, stopping } = this.context;
      await clock.attach(read, stopping, this.#time!.atOnce);
      if (clock.isStopped && this.settings.time !== null) throw new Error(adsMessages.clockStopped(this.settings.time.symbol));
    } catch (error) {
      if (this.#isRunning) this.#end(adsMessages.clockNotReadable(this.#reasonOf(error)));
    }
  }

  #reasonOf(error: unknown): string {
    const { endpoint, local } = this.settings;
    return reasonOf(error, this.#client, endpoint, local?.netId ?? null);
  }

  #whyLost(): string {
    const system = this.#client.metaData.tcSystemState;
    const { endpoint, local } = this.settings;
    const { host, netId } = endpoint;
    return system !== undefined && system.adsState !== RUN
      ? adsMessages.stopped(netId, String(system.adsStateStr))
      : adsMessages.ended(host, local?.netId ?? null);
  }

  // Removes the notifications if the PLC still responds, and waits for at most GOODBYE_MS.
  async #leave(): Promise<void> {
    this.#client.onSamples = () => {};
    const goodbye = this.#client.connection.connected ? this.#client.disconnect() : Promise.resolve();
    await Promise.race([goodbye.catch(() => {}), new Promise(resolve => setTimeout(resolve, GOODBYE_MS))]);
    await this.#client.disconnect(true).catch(() => {});
  }
}

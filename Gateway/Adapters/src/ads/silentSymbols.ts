import { pause } from '../backoff';
import { isUnnotified, lateAfterMs, SILENT_MS } from '../samples/silentValues';
import type { PlcNumber } from './decoding';

/**
 * Interval of the checks: LOOK_MS, or QUIET_LOOK_MS if the PLC sends only changes and no value has arrived for QUIET_MS. Headsets show a sample for
 * about 300 ms.
 */
const LOOK_MS = 500;
const QUIET_LOOK_MS = 90;
const QUIET_MS = 50;

/** Time after which a refused subscription is tried again, because another client of the PLC may have removed its notifications. */
const RETRY_MS = 10_000;

interface SymbolState {
  heardAt: number;
  value: PlcNumber | null;
  isLost: boolean;
  /** Whether the PLC has refused the subscription, at the time `heardAt`. */
  isRefused: boolean;
  /** Start of the current series of reads whose value arrived without a notification; null if the last read is not part of such a series. */
  missedSince: number | null;
}

const HEARD = { isLost: false, isRefused: false, missedSince: null };

/** Reads a symbol and acts on the result. Symbols are identified by their index in the configuration. */
interface ReadActions {
  /** Whether the program of the PLC is running. A stopped PLC returns values that are not current, so its symbols are not read. */
  isRunning(): boolean;
  /**
   * Reads the symbol.
   * @throws Error The PLC no longer has the symbol, or does not respond.
   */
  read(index: number): Promise<PlcNumber>;
  /** Confirms that these symbols still had the value of their last notification when they were read. The reads began `agoMs` ms ago. */
  confirm(indices: ReadonlySet<number>, agoMs: number): void;
  /** @param isSubscription Whether the subscription failed, which is tried again later; otherwise the read failed. */
  lose(index: number, error: unknown, isSubscription: boolean): void;
  /** Subscribes to the symbol again, because it exists again with this value, or because its notifications do not arrive. */
  renew(index: number, value: PlcNumber): Promise<void>;
}

/** Reads the symbols for which no notifications arrive, to distinguish a value at rest from a symbol that no longer exists. */
export class SilentSymbols {
  readonly #symbols: (SymbolState | null)[];
  #newest = -Infinity;

  /**
   * @param watched Whether each symbol exists. It is subscribed until `refuse` is called.
   * @param delayMs Maximum delay of a value, ms.
   * @param isOnChange Whether the PLC sends only changes.
   */
  constructor(
    watched: boolean[],
    readonly delayMs: number,
    readonly isOnChange: boolean,
    readonly actions: ReadActions,
    readonly now: () => number = () => performance.now(),
  ) {
    this.#symbols = watched.map(isWatched => (isWatched ? { ...HEARD, heardAt: now(), value: null } : null));
  }

  heard(index: number, value: PlcNumber): void {
    this.#newest = this.now();
    this.#symbols[index] = { ...HEARD, heardAt: this.#newest, value };
  }

  /** Records that the last value of a symbol was not used. The symbol is subscribed again, because a value at rest receives no other notification. */
  discard(index: number): void {
    this.#symbols[index]!.isLost = true;
  }

  /** Reports that the PLC has refused the subscription to a symbol. */
  refuse(index: number, error: unknown): void {
    this.#symbols[index] = { heardAt: this.now(), value: null, isLost: true, isRefused: true, missedSince: null };
    this.actions.lose(index, error, true);
  }

  async run(stop: AbortSignal): Promise<void> {
    let looked = this.now();
    while (!stop.aborted) {
      await pause(QUIET_LOOK_MS, stop);
      const isQuiet = this.isOnChange && this.now() - this.#newest >= QUIET_MS;
      if (stop.aborted || (!isQuiet && this.now() - looked < LOOK_MS)) continue;
      looked = this.now();
      await this.look();
    }
  }

  async look(): Promise<void> {
    if (!this.actions.isRunning()) return;
    const began = this.now();
    const silence = this.isOnChange ? SILENT_MS : lateAfterMs(this.delayMs);
    const unchanged = new Set<number>();
    const olderThan = (ms: number, isRefused: boolean): number[] =>
      this.#symbols.flatMap((symbol, index) => (symbol?.isRefused === isRefused && began - symbol.heardAt >= ms ? [index] : []));
    // Tries only one refused subscription again, the one that has waited longest, so that the others are not read late.
    const refused = olderThan(RETRY_MS, true).sort((a, b) => this.#symbols[a]!.heardAt - this.#symbols[b]!.heardAt);
    const silent = [...olderThan(silence, false), ...refused.slice(0, 1)];
    await Promise.all(
      silent.map(async index => {
        if (await this.#isUnchanged(index, began)) unchanged.add(index);
      }),
    );
    if (unchanged.size > 0) this.actions.confirm(unchanged, this.now() - began);
  }

  async #isUnchanged(index: number, began: number): Promise<boolean> {
    let value: PlcNumber;
    try {
      value = await this.actions.read(index);
      // The program may have stopped during the read.
      if (!this.actions.isRunning()) return false;
    } catch (error) {
      if (!this.actions.isRunning()) return false;
      const symbol = this.#symbols[index]!;
      symbol.isLost = true;
      // Gives way to the other refused subscriptions.
      if (symbol.isRefused) symbol.heardAt = this.now();
      this.actions.lose(index, error, false);
      return false;
    }
    const symbol = this.#symbols[index]!;
    const isSame = Object.is(value, symbol.value);
    if (symbol.heardAt >= began) return false;
    symbol.missedSince = this.isOnChange && isSame ? null : (symbol.missedSince ?? began);
    if (symbol.isLost || isUnnotified(symbol.missedSince, began, this.delayMs)) {
      this.heard(index, value);
      await this.actions.renew(index, value).catch(error => (this.actions.isRunning() ? this.refuse(index, error) : this.discard(index)));
      return false;
    }
    return this.isOnChange && isSame;
  }
}

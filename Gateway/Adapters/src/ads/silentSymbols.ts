import { pause } from '../backoff';

const LOOK_MS = 500;

/** A symbol is read when nothing has come of it for this long, and for this multiple of what a value takes to arrive. */
const SILENT_MS = 400, DELAYS = 2;

/** A value that should have been sent, in this many reads in a row: the PLC no longer notifies. */
const MISSED_READS = 2;

interface SymbolState {
  heardAt: number;
  value: number | null;
  isLost: boolean;
  missed: number;
}

/** What is done with the results of a read, by the joint's place in the configuration. */
export interface ReadActions {
  /** @throws Error The PLC does not have the symbol any more, or does not answer. */
  read(joint: number): Promise<number>;
  /** The joint still had this value when it was asked for. */
  confirm(joints: ReadonlySet<number>): void;
  lose(joint: number, error: unknown): void;
  /** Subscribes again: the symbol is back with this value, or its notifications are missing. */
  renew(joint: number, value: number): Promise<void>;
}

/** Reads the symbols that a PLC is silent about: it is silent about a value at rest and about a symbol that is gone. */
export class SilentSymbols {
  readonly #symbols: (SymbolState | null)[];

  /** @param watched Whether each joint is subscribed to. @param delayMs What a value takes to arrive at most. @param isOnChange Rest is silent. */
  constructor(
    watched: boolean[], readonly delayMs: number, readonly isOnChange: boolean, readonly actions: ReadActions,
    readonly now: () => number = () => performance.now(),
  ) {
    this.#symbols = watched.map(isWatched => isWatched ? { heardAt: now(), value: null, isLost: false, missed: 0 } : null);
  }

  heard(joint: number, value: number): void {
    this.#symbols[joint] = { heardAt: this.now(), value, isLost: false, missed: 0 };
  }

  async run(stop: AbortSignal): Promise<void> {
    while (!stop.aborted) {
      await pause(LOOK_MS, stop);
      if (!stop.aborted) await this.look();
    }
  }

  async look(): Promise<void> {
    const began = this.now(), silence = Math.max(SILENT_MS, DELAYS * this.delayMs), unchanged = new Set<number>();
    const silent = this.#symbols.flatMap((symbol, joint) => symbol !== null && began - symbol.heardAt >= silence ? [joint] : []);
    await Promise.all(silent.map(async joint => { if (await this.#isUnchanged(joint, began)) unchanged.add(joint); }));
    if (unchanged.size > 0) this.actions.confirm(unchanged);
  }

  async #isUnchanged(joint: number, began: number): Promise<boolean> {
    let value: number;
    try {
      value = await this.actions.read(joint);
    } catch (error) {
      this.#symbols[joint]!.isLost = true;
      this.actions.lose(joint, error);
      return false;
    }
    const symbol = this.#symbols[joint]!, isSame = Object.is(value, symbol.value);
    if (symbol.heardAt >= began) return false;
    symbol.missed = this.isOnChange && isSame ? 0 : symbol.missed + 1;
    if (symbol.isLost || symbol.missed >= MISSED_READS) {
      this.heard(joint, value);
      await this.actions.renew(joint, value).catch(error => this.actions.lose(joint, error));
      return false;
    }
    return this.isOnChange && isSame;
  }
}

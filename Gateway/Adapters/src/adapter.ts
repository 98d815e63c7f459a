import type { PlantClock } from './clock/plantClock';
import type { Configuration, OwnCheck } from './configuration/configuration';
import type { GatewayLink } from './gateway/link';
import type { AdapterStatus } from './gateway/status';
import type { Log } from './log';
import type { PlantOutput } from './samples/plantOutput';

/** The objects that every kind of adapter receives. */
export interface AdapterContext {
  configuration: Configuration;
  gateway: GatewayLink;
  /** Attach it to the plant's clock while the plant is connected. */
  clock: PlantClock;
  /** Takes the values as they arrive. */
  output: PlantOutput;
  status: AdapterStatus;
  log: Log;
  /** Aborted when the adapter must end. */
  stopping: AbortSignal;
}

/** Reads the plant until it is stopped, with reconnections. Rejects only for errors that cannot be fixed by waiting. */
export type RunAdapter = (context: AdapterContext) => Promise<void>;

/** The part of a kind that is available without loading its libraries. */
export interface Kind {
  check: OwnCheck;
  /** Gets the reason why it cannot run on this machine, with the remedy; null if it can. Changes nothing. */
  obstacle?(configuration: Configuration): string | null;
  /** Gets the summary after --check: the source and the data that are read. */
  summary(configuration: Configuration): string;
  /** Whether it also publishes joints that the configuration does not list. */
  passesUnlisted?(configuration: Configuration): boolean;
}

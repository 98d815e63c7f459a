import type { OfferedClock } from './clock/offeredClock';
import type { Configuration, OwnCheck } from './configuration/configuration';
import type { GatewayLink } from './gateway/link';
import type { AdapterStatus } from './gateway/status';
import type { Log } from './log';
import type { PlantOutput } from './samples/plantOutput';

/** The objects that an adapter of any kind receives. */
export interface AdapterContext {
  configuration: Configuration;
  gateway: GatewayLink;
  /** Offers the plant's clock to the gateway. The adapter attaches it after connecting to the plant, and detaches it after a disconnection. */
  clock: OfferedClock;
  /** Receives the plant's values in the order of their arrival. */
  output: PlantOutput;
  status: AdapterStatus;
  log: Log;
  /** Aborted when the adapter must end. */
  stopping: AbortSignal;
}

/** Reads the plant, and reconnects after failures, until `stopping` is aborted. Rejects only for errors that waiting cannot fix. */
export type RunAdapter = (context: AdapterContext) => Promise<void>;

/** The functions of a kind of plant that are available without loading the kind's libraries. */
export interface Kind {
  check: OwnCheck;
  /** Reports why the adapter cannot run on this machine, with the remedy. Called only by --check, after `check`. Changes nothing. */
  checkMachine?: OwnCheck;
  /** Gets the summary that --check prints: the source, and the data that are read. */
  summary(configuration: Configuration): string;
  /** Whether the adapter also publishes joints that the configuration does not list. */
  passesUnlisted?(configuration: Configuration): boolean;
  /** Whether the adapter offers the plant's clock, with the name of the plant; true without this function. */
  offersClock?(configuration: Configuration): boolean;
}

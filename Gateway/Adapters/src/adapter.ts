import type { OfferedClock } from './clock/offeredClock';
import type { CheckedConfiguration, Configuration } from './configuration/configuration';
import type { KindName, PlantFile, Silence } from './configuration/plantFile';
import type { Address } from './configuration/values';
import type { YamlFile } from './configuration/yamlFile';
import type { GatewayLink } from './gateway/link';
import type { AdapterStatus } from './gateway/status';
import type { Log } from './log';
import type { PlantOutput } from './samples/plantOutput';

/** The objects that an adapter of any kind receives. */
export interface AdapterContext<Settings = unknown> {
  configuration: CheckedConfiguration<Settings>;
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

/** The part of a kind of plant that is available without loading the kind's libraries. `Settings` are the data that its adapter needs. */
export interface Kind<Name extends KindName = KindName, Settings = unknown> {
  /** The entries of the address of a number, the required one first; absent for a kind without such addresses. */
  readonly address?: readonly (keyof Address)[];
  /** The entry of the address that is the same for all numbers of one message. Absent if the numbers of a frame always arrive together. */
  readonly arrivesBy?: 'node' | 'topic';
  /** Meaning of missing data, for a kind whose files have no entry `silence`. */
  readonly silence?: Silence;
  /**
   * Checks the rules that the schema cannot express, and gets the settings. They are not used if an error is reported.
   * @param content The content of the file. An entry with a reported error has its default, or is undefined.
   */
  check(file: YamlFile, content: PlantFile<Name>, configuration: Configuration, environment: NodeJS.ProcessEnv): Settings;
  /** Reports why the adapter cannot run on this machine, with the remedy. Called only by --check, after `check`. Changes nothing. */
  checkMachine?(file: YamlFile, settings: Settings): void;
  /** Gets the summary that --check prints: the source, and the data that are read. */
  summary(configuration: CheckedConfiguration<Settings>): string;
  /** Whether the adapter also publishes joints that the configuration does not list. */
  passesUnlisted?(configuration: CheckedConfiguration<Settings>): boolean;
  /**
   * Gets the address to which the adapter connects, if it accepts only one connection from each machine; null otherwise. The gateway then refuses a
   * second file with this address.
   */
  soleConnectionTo?(settings: Settings): string | null;
  /** Whether the adapter offers the plant's clock, with the name of the plant; true without this function. */
  offersClock?(settings: Settings): boolean;
}

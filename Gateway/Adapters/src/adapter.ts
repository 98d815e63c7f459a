import type { PlantClock } from './clock/plantClock';
import type { Configuration, OwnCheck } from './configuration/configuration';
import type { GatewayLink } from './gateway/link';
import type { AdapterStatus } from './gateway/status';
import type { Log } from './log';
import type { JointOutput } from './samples/jointOutput';

/** What every kind of adapter is given. */
export interface AdapterContext {
  configuration: Configuration;
  gateway: GatewayLink;
  /** To be attached to the plant's clock while the plant is there. */
  clock: PlantClock;
  /** Takes the values as they come. */
  output: JointOutput;
  status: AdapterStatus;
  log: Log;
  /** Given when the adapter shall end. */
  stopping: AbortSignal;
}

/** Reads the plant until it is stopped, however often the plant goes and comes. Rejects only for what no waiting mends. */
export type RunAdapter = (context: AdapterContext) => Promise<void>;

/** What is known of a kind without loading what it is made of. */
export interface Kind {
  check: OwnCheck;
  /** Why it could not run on this machine, and what to do; null where nothing stands in its way. Changes nothing. */
  obstacle?(configuration: Configuration): string | null;
  /** What a person wants to see after --check: where from and what. */
  summary(configuration: Configuration): string;
}

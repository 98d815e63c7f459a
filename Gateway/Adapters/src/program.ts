import type { Kind } from './adapter';
import { type CheckedConfiguration, readConfiguration } from './configuration/configuration';
import { ConfigurationError } from './configuration/problem';
import { kinds } from './kinds';
import { Log } from './log';
import { runPlant } from './plant';
import { versionWithCommit } from './version';

const USAGE = 'usage: node plant.mjs CONFIG.yaml [--check]';
const BAD_INPUT = 2;
const FAILED = 1;

/** The process in which the program runs. */
interface Host {
  environment: NodeJS.ProcessEnv;
  /** Writes to standard output. Resolves when the text is written. */
  out(text: string): Promise<unknown>;
  /** Writes to standard error. */
  err(text: string): void;
  /** Aborted when the program must end. */
  ending: AbortController;
  /**
   * Lets signals and the end of the parent process abort `ending`. Until then, a signal has its default action, because its handler cannot run while
   * the program reads a file.
   */
  listen(): void;
}

/** Runs the program with these command-line arguments. Returns the exit status. */
export async function run(args: string[], host: Host): Promise<number> {
  try {
    return await runCommand(args, host);
  } catch (error) {
    const isBadInput = error instanceof ConfigurationError;
    host.err(`${isBadInput ? error.message : `plant.mjs: ${error instanceof Error ? error.message : error}`}\n`);
    return isBadInput ? BAD_INPUT : FAILED;
  }
}

async function runCommand(args: string[], host: Host): Promise<number> {
  const others = args.filter(argument => argument !== '--check');
  if (others.length === 1 && others[0] === '--version') {
    await host.out(`${versionWithCommit()}\n`);
    return 0;
  }
  if (others.length !== 1 || others[0].startsWith('-')) {
    host.err(`${USAGE}\n`);
    return others[0] === '--help' ? 0 : BAD_INPUT;
  }
  const isCheck = args.includes('--check');
  const configuration = readConfiguration(others[0], host.environment, kinds, isCheck);
  if (isCheck) return describe(configuration, host);
  host.listen();
  await runPlant(configuration, new Log(`plant/${configuration.plant.name}`, configuration.secrets, host.err), host.ending);
  return 0;
}

async function describe(configuration: CheckedConfiguration, { out, err }: Host): Promise<number> {
  const kind = kinds[configuration.plant.kind];
  await out(`${configuration.file} is valid: ${kind.summary(configuration)}\n`);
  if (configuration.isSupervised) await out(`${JSON.stringify(contentOf(kind, configuration))}\n`);
  for (const warning of configuration.warnings) err(`warning: ${warning}\n`);
  return 0;
}

/** Gets the content of the configuration that the gateway needs before it starts the adapter. */
function contentOf(kind: Kind, configuration: CheckedConfiguration): object {
  return {
    name: configuration.plant.name,
    joints: configuration.joints.map(({ joint }) => joint),
    passes_unlisted: kind.passesUnlisted?.(configuration) ?? false,
    offers_clock: kind.offersClock?.(configuration.settings) ?? true,
    sole_connection_to: kind.soleConnectionTo?.(configuration.settings) ?? null,
    password_variable: configuration.passwordVariable,
    has_objects: configuration.hasObjects,
    frames: configuration.parents,
    signals: configuration.signals.map(({ signal }) => signal),
    robot: configuration.robot,
    robots: configuration.robots,
    described_by: configuration.describedBy,
    warnings: configuration.warnings,
  };
}

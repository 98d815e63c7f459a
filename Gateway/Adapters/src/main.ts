// The program plant.mjs CONFIG.yaml [--check] reads a control system and sends its joint positions and its time to a gateway. With --version, it
// prints its version.
import type { Kind } from './adapter';
import { type Configuration, readConfiguration } from './configuration/configuration';
import { ConfigurationError } from './configuration/problem';
import { kinds } from './kinds';
import { runPlant } from './plant';
import { versionWithCommit } from './version';

const USAGE = 'usage: node plant.mjs CONFIG.yaml [--check]';
const BAD_INPUT = 2;
const FAILED = 1;

const isCheck = process.argv.includes('--check');
const others = process.argv.slice(2).filter(argument => argument !== '--check');

async function main(): Promise<number> {
  if (others.length === 1 && others[0] === '--version') {
    process.stdout.write(`${versionWithCommit()}\n`);
    return 0;
  }
  if (others.length !== 1 || others[0].startsWith('-')) {
    process.stderr.write(`${USAGE}\n`);
    return others[0] === '--help' ? 0 : BAD_INPUT;
  }
  const checks = Object.fromEntries(Object.entries(kinds).map(([name, kind]) => [name, kind.check]));
  const configuration = readConfiguration(others[0], process.env, checks);
  if (!isCheck) return runPlant(configuration);
  const kind = kinds[configuration.plant.kind];
  const obstacle = kind.obstacle?.(configuration) ?? null;
  if (obstacle !== null) {
    process.stderr.write(`${obstacle}\n`);
    return BAD_INPUT;
  }
  process.stdout.write(`${others[0]} is valid: ${kind.summary(configuration)}\n`);
  if (configuration.isSupervised) await written(`${JSON.stringify(contentOf(kind, configuration))}\n`);
  for (const warning of configuration.warnings) process.stderr.write(`warning: ${warning}\n`);
  return 0;
}

/** Writes a string and waits until it is written. Otherwise, the end of the process could truncate a string longer than the pipe's buffer. */
const written = (text: string): Promise<unknown> =>
  new Promise(done => {
    process.stdout.write(text, done);
  });

/** Gets the content of the configuration that the gateway needs before it starts the adapter. */
function contentOf(kind: Kind, configuration: Configuration): object {
  return {
    name: configuration.plant.name,
    joints: configuration.joints.map(({ joint }) => joint),
    passes_unlisted: kind.passesUnlisted?.(configuration) ?? false,
    has_objects: configuration.hasObjects,
    frames: configuration.parents,
    signals: configuration.signals.map(({ signal }) => signal),
    robot: configuration.robot,
    robots: configuration.robots,
    warnings: configuration.warnings,
  };
}

main().then(
  status => process.exit(status),
  error => {
    process.stderr.write(`${error instanceof ConfigurationError ? error.message : `plant.mjs: ${error instanceof Error ? error.message : error}`}\n`);
    process.exit(error instanceof ConfigurationError ? BAD_INPUT : FAILED);
  },
);

// Finds the errors in a configuration without starting a process.
import { parts } from './parts.mjs';

const { readConfiguration, kinds } = await parts('configuration/configuration', 'kinds');
const checks = Object.fromEntries(Object.entries(kinds).map(([name, kind]) => [name, kind.check]));

/** Returns the lines that --check writes for a configuration file; an empty list if the file is valid. */
export function wrongIn(path, environment = {}) {
  try {
    readConfiguration(path, environment, checks);
    return [];
  } catch (error) {
    return error.message.split('\n');
  }
}

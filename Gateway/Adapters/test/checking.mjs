// Finds the errors in a configuration without starting a process.
import { parts } from './parts.mjs';

const { readConfiguration, kinds } = await parts('configuration/configuration', 'kinds');

/** Returns the lines that --check writes for a configuration file; an empty list if the file is valid. */
export function wrongIn(path, environment = {}) {
  try {
    readConfiguration(path, environment, kinds);
    return [];
  } catch (error) {
    return error.message.split('\n');
  }
}

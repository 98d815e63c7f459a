// Finds the errors in a configuration without starting a process.
import { parts } from './parts.mjs';

const { readConfiguration, kinds } = await parts('configuration/configuration', 'kinds');

/** Returns the lines that --check writes for a configuration file; an empty list if the file is valid. */
export const wrongIn = (path, environment = {}) => linesOf(() => readConfiguration(path, environment, kinds));

/** Returns the lines of the error that a check throws; an empty list if it throws none. */
export function linesOf(check) {
  try {
    check();
    return [];
  } catch (error) {
    return error.message.split('\n');
  }
}

// What is wrong with a configuration, found without a process.
import { parts } from './parts.mjs';

const { readConfiguration, kinds } = await parts('configuration/configuration', 'kinds');
const checks = Object.fromEntries(Object.entries(kinds).map(([name, kind]) => [name, kind.check]));

/** The lines that --check would write; none when all is well. */
export function wrongIn(path, environment = {}) {
  try {
    readConfiguration(path, environment, checks);
    return [];
  } catch (error) {
    return error.message.split('\n');
  }
}

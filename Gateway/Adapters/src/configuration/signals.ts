import type { EntryOf } from './plantFile';
import { addressIn, type Value } from './values';
import type { YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

/** Checks the names of the signals, and adds the values to be read for them to `values`. */
export function signalsOf(file: YamlFile, entries: EntryOf<'signals'>[], values: Value[]): EntryOf<'signals'>[] {
  const seen = new Map<string, number>();
  entries.forEach(({ signal, ...entry }, i) => {
    if (seen.has(signal)) file.report(['signals', i, 'signal'], configurationMessages.nameTwice(signal, seen.get(signal), 'signal'));
    seen.set(signal, file.lineOf(['signals', i, 'signal']));
    values.push({ label: signal, path: ['signals', i], address: addressIn(entry) });
  });
  return entries;
}

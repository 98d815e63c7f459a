import type { Joint } from './configuration';
import type { Value } from './values';
import type { YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

/**
 * Warns of joints with the same address, scale and offset, and of numbers of one frame with the same address, because an entry may have been copied and
 * not corrected. It is not an error: the two fingers of a gripper may share a variable.
 */
export function warnOfSharedAddresses(file: YamlFile, values: Value[], joints: Pick<Joint, 'scale' | 'offset'>[]): void {
  const first = new Map<string, Value>();
  for (const value of values) {
    const { node, symbol, field, topic } = value.address;
    const [section, index] = value.path;
    // An address without these entries is the place of a joint in the list, which another check covers.
    if (section === 'signals' || (node ?? symbol ?? field ?? topic) === undefined) continue;
    const entries = Object.entries(value.address).filter(([, part]) => part !== undefined);
    const { scale, offset } = section === 'joints' ? joints[index as number] : {};
    const key = JSON.stringify([section, section === 'frames' ? index : null, scale, offset, entries]);
    const other = first.get(key);
    if (other === undefined) first.set(key, value);
    else {
      const address = entries.map(([name, part]) => `${name} ${part}`).join(', ');
      file.warn(value.path, configurationMessages.addressTwice(address, other.label, file.lineOf(other.path)));
    }
  }
}

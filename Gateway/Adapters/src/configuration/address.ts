import type { Path, YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

/** Matches SCHEME://HOST[:PORT][/…], with an IPv6 address in brackets. */
const FORM = /^[a-z.]+:\/\/(?:\[[0-9A-Fa-f:.]+(?:%\w+)?\]|[^\s:/@?#[\]]+)(?::(\d+))?(?:\/\S*)?$/;

/** Reports an invalid address, because connection attempts to it would be repeated without end. */
export function requireAddress(file: YamlFile, entry: Path, address: string): void {
  const match = FORM.exec(address);
  const port = Number(match?.[1] ?? 1);
  if (match === null || port < 1 || port > 65535) file.report(entry, configurationMessages.address(address));
}

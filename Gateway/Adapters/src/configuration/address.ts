import { shown } from './problem';
import type { Path, YamlFile } from './yamlFile';

/** SCHEME://HOST[:PORT][/…]; an IPv6 address is in brackets. */
const FORM = /^[a-z.]+:\/\/(?:\[[0-9A-Fa-f:.]+(?:%\w+)?\]|[^\s:/@?#[\]]+)(?::(\d+))?(?:\/\S*)?$/;

/** Reports an invalid address, for which connection attempts would be repeated forever. */
export function requireAddress(file: YamlFile, entry: Path, address: string): void {
  const match = FORM.exec(address);
  const port = Number(match?.[1] ?? 1);
  if (match === null || port < 1 || port > 65535)
    file.report(entry, `value ${shown(address)}; allowed: a scheme with ://, a host and, after a colon, a port from 1 to 65535`);
}

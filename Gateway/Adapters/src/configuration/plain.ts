import { isLoopback } from './configuration';
import type { Path, YamlFile } from './yamlFile';

/** Reports a pin for an address with ws://, where it would not be checked. */
export function requireTls(file: YamlFile, section: Path, address: string): void {
  if (address.startsWith('ws:')) file.report([...section, 'pin'], 'not looked at with ws://; write wss://, or take the pin out');
}

/** Reports an endpoint without TLS on another machine, unless the configuration allows it explicitly. */
export function requirePlain(file: YamlFile, { endpoint, plain }: { endpoint: string; plain?: boolean }): void {
  const scheme = endpoint.slice(0, endpoint.indexOf(':'));
  if (['wss', 'mqtts'].includes(scheme) || isLoopback(endpoint) || plain === true) return;
  file.report(['plant', 'plain'], `missing; ${scheme}:// to another machine is neither encrypted nor authenticated: `
    + `use ${scheme}s://, or say plain: true where only trusted machines share its network`);
}

import { isLoopback } from './configuration';
import type { Path, YamlFile } from './yamlFile';

/** Of a section with a pin: nobody would look at it behind ws://. */
export function requireTls(file: YamlFile, section: Path, address: string): void {
  if (address.startsWith('ws:')) file.report([...section, 'pin'], 'not looked at with ws://; write wss://, or take the pin out');
}

/** Of an endpoint without TLS on another machine: it has to be said that this is meant. */
export function requirePlain(file: YamlFile, { endpoint, plain }: { endpoint: string; plain?: boolean }): void {
  const scheme = endpoint.slice(0, endpoint.indexOf(':'));
  if (['wss', 'mqtts'].includes(scheme) || isLoopback(endpoint) || plain === true) return;
  file.report(['plant', 'plain'], `missing; ${scheme}:// to another machine is neither encrypted nor authenticated: `
    + `use ${scheme}s://, or say plain: true where only trusted machines share its network`);
}

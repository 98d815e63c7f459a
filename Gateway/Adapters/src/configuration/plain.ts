import { isLoopback } from './configuration';
import type { Path, YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

/** Reports a pin for a ws:// address, because it would not be checked. */
export function requireTls(file: YamlFile, section: Path, address: string): void {
  if (address.startsWith('ws:')) file.report([...section, 'pin'], configurationMessages.pinWithoutTls);
}

/** Reports an endpoint on another machine without TLS, unless the configuration has plain: true. */
export function requirePlain(file: YamlFile, { endpoint, plain }: { endpoint: string; plain?: boolean }): void {
  const scheme = endpoint.slice(0, endpoint.indexOf(':'));
  if (['wss', 'mqtts'].includes(scheme) || isLoopback(endpoint) || plain === true || file.isInvalid(['plant', 'endpoint'])) return;
  file.report(['plant', 'plain'], configurationMessages.notPlain(scheme));
}

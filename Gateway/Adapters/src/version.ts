import { readFileSync } from 'node:fs';
import type { Log } from './log';
import { gatewayMessages } from './messages/gateway';

/** The version in package.json. The bundler defines this constant. */
declare const NOWPOSE_VERSION: string;

export const VERSION = NOWPOSE_VERSION;

/** Gets the version and the commit from the file that the build writes next to this program; without that file, only the version. */
export function versionWithCommit(): string {
  try {
    return readFileSync(new URL('version.txt', import.meta.url), 'utf8').trim();
  } catch {
    return VERSION;
  }
}

/** Logs once if a gateway's version differs from the adapter's version in the major or the minor number. */
export function compareVersions(log: Log, gateway: unknown): void {
  const series = typeof gateway === 'string' ? seriesOf(gateway) : undefined;
  if (series === undefined) return;
  if (series === seriesOf(VERSION)) log.resume('version', gatewayMessages.versionFits(gateway as string));
  else log.change('version', String(gateway), gatewayMessages.otherVersion(String(gateway), VERSION));
}

/** Gets the major and minor version numbers, for example "0.2" for "0.2.0-rc.1"; undefined if the string is not a version. */
const seriesOf = (version: string): string | undefined => /^(\d{1,9}\.\d{1,9})\.\d{1,9}([-+][0-9A-Za-z.+-]{1,64})?$/.exec(version)?.[1];

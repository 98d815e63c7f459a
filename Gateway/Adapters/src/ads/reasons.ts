import { getSystemErrorName } from 'node:util';
import type { AdsEndpoint } from './endpoint';
import type { ReadOnlyClient } from './readOnlyClient';

const RUN = 5;

const TARGET_PORT = 6;
const TARGET_MACHINE = 7;
const SYMBOL_NOT_FOUND = 1808;

export const isSymbolNotFound = (error: unknown): boolean => codeOf(error) === SYMBOL_NOT_FOUND;

/** Gets the reason why a PLC cannot be read, with the remedy. */
export function reasonOf(error: unknown, client: ReadOnlyClient, endpoint: AdsEndpoint, localNetId: string | null): string {
  const { host, tcpPort, netId, port } = endpoint;
  const system = client.metaData.tcSystemState;
  if (system !== undefined && system.adsState !== RUN)
    return `TwinCAT at ${netId} is in ${system.adsStateStr} mode; reading continues when TwinCAT runs`;
  const refused = /socket error (-\d+)/.exec(messageOf(error));
  if (refused !== null)
    return (
      `nothing answers at ${host}:${tcpPort} (${getSystemErrorName(Number(refused[1]))}); `
      + `check that TwinCAT or its router runs there and that its firewall allows TCP ${tcpPort}`
    );
  switch (codeOf(error)) {
    case TARGET_PORT:
      return `no PLC runtime at AMS port ${port} of ${netId}; the first runtime of TwinCAT 3 has port 851, that of TwinCAT 2 port 801`;
    case TARGET_MACHINE:
      return `${host} does not know the AMS Net Id ${netId}; check it, and that ${host} is that machine or has a route to it`;
  }
  if (client.isHungUp || /[Tt]imeout|socket (closed|ended)/.test(messageOf(error)))
    return `${host} accepts the connection but does not answer${
      localNetId === null
        ? ''
        : `; if it has never answered, add a route to this machine: `
          + `in TwinCAT, SYSTEM > Routes > Add, AMS Net Id ${localNetId}, transport TCP_IP, the address of this machine`
    }`;
  return messageOf(error);
}

/** In ads-client's errors, the cause is the last entry of the trace. */
const messageOf = (error: unknown): string =>
  (error as { trace?: string[] }).trace?.at(-1) ?? (error instanceof Error ? error.message : String(error));

function codeOf(error: unknown): number | undefined {
  return (error as { adsError?: { errorCode?: number } }).adsError?.errorCode;
}

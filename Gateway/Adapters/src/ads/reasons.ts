import { getSystemErrorName } from 'node:util';
import type { AdsEndpoint } from './endpoint';
import type { ReadOnlyClient } from './readOnlyClient';
import { adsMessages } from '../messages/ads';

const RUN = 5;

const TARGET_PORT = 6;
const TARGET_MACHINE = 7;
const SYMBOL_NOT_FOUND = 1808;

/** Whether the PLC has responded to a request with an error. */
export const isAdsError = (error: unknown): boolean => codeOf(error) !== undefined;

export const isSymbolNotFound = (error: unknown): boolean => codeOf(error) === SYMBOL_NOT_FOUND;

/** Gets the reason why the PLC cannot be read, with the remedy. */
export function reasonOf(error: unknown, client: ReadOnlyClient, endpoint: AdsEndpoint, localNetId: string | null): string {
  const { host, tcpPort, netId, port } = endpoint;
  const system = client.metaData.tcSystemState;
  if (system !== undefined && system.adsState !== RUN) return adsMessages.notRunning(netId, String(system.adsStateStr));
  const refused = /socket error (-\d+)/.exec(messageOf(error));
  if (refused !== null) return adsMessages.noRouter(host, tcpPort, getSystemErrorName(Number(refused[1])));
  switch (codeOf(error)) {
    case TARGET_PORT:
      return adsMessages.noRuntime(port, netId);
    case TARGET_MACHINE:
      return adsMessages.unknownNetId(host, netId);
  }
  if (client.isHungUp || /[Tt]imeout|socket (closed|ended)/.test(messageOf(error))) return adsMessages.noAnswer(host, localNetId);
  return messageOf(error);
}

/** Gets the message of an error's cause, which is the last entry of the trace in errors of ads-client. */
const messageOf = (error: unknown): string =>
  (error as { trace?: string[] }).trace?.at(-1) ?? (error instanceof Error ? error.message : String(error));

function codeOf(error: unknown): number | undefined {
  return (error as { adsError?: { errorCode?: number } }).adsError?.errorCode;
}

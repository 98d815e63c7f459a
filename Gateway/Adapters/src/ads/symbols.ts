import type { AdsSymbol } from 'ads-client';
import { nearest } from '../configuration/nearest';
import { canHoldTime, isNumber, isState } from './decoding';
import type { ReadOnlyClient } from './readOnlyClient';
import { isSymbolNotFound } from './reasons';
import { symbolMessages } from '../messages/ads';

const MAX_TABLE = 8 * 1024 * 1024;

/** A variable named in the configuration, with its line number. */
export interface NamedSymbol {
  symbol: string;
  line: number;
}

/** The error for a symbol in the configuration that the PLC does not have, or that has an unusable type. */
export class SymbolError extends Error {}

/**
 * Finds a symbol of the configuration in the PLC.
 * @param objectionTo Gets the reason why a symbol cannot be used; undefined if it can.
 * @throws SymbolError The PLC does not have the symbol, or the symbol is not usable. The message has the line and a suggestion.
 */
export async function findSymbol(
  client: ReadOnlyClient,
  file: string,
  { symbol, line }: NamedSymbol,
  objectionTo: (found: AdsSymbol) => string | undefined,
): Promise<AdsSymbol> {
  let found: AdsSymbol;
  try {
    found = await client.getSymbol(symbol);
  } catch (error) {
    if (!isSymbolNotFound(error)) throw error;
    throw new SymbolError(symbolMessages.unknown(`${file}, line ${line}`, symbol, await near(client, symbol)));
  }
  const objection = objectionTo(found);
  if (objection !== undefined) throw new SymbolError(symbolMessages.unusable(`${file}, line ${line}`, symbol, found.type, objection));
  return found;
}

/** Gets symbols of the PLC with similar names; undefined if the PLC's symbol table is too long. */
async function near(client: ReadOnlyClient, symbol: string): Promise<string[] | undefined> {
  const { symbolLength } = await client.readPlcUploadInfo();
  if (symbolLength > MAX_TABLE) return undefined;
  const names = Object.values(await client.getSymbols()).map(s => s.name);
  return nearest(symbol, names, 3);
}

/** Gets the reason why a symbol cannot be a position; undefined if it can. */
export const numberNeeded = (found: AdsSymbol): string | undefined => {
  if (found.arrayDimension > 0) return symbolMessages.array(`${found.name}[${found.arrayInfo[0]?.startIndex ?? 0}]`);
  return isNumber(found) ? undefined : symbolMessages.notNumber;
};

/** Gets the reason why a symbol cannot be a signal; undefined if it can. */
export const stateNeeded = (found: AdsSymbol): string | undefined => (isState(found) ? undefined : numberNeeded(found));

/** Gets the reason why a symbol cannot be the time; undefined if it can. */
export const timeNeeded = (found: AdsSymbol): string | undefined => (canHoldTime(found) ? undefined : symbolMessages.notTime);

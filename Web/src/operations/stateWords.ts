import { stateLabels } from '../messages/states';

/** Returns a state as text. If the clock is coarse, adds its error, for example "coarse, ± 3 ms". */
export function stateWords(state: string, estimatedErrorUs: number | null | undefined, boundUs: number | null | undefined): string {
  const us = estimatedErrorUs ?? boundUs;
  return state === 'coarse' && us != null ? stateLabels.coarse(`${Number((us / 1000).toPrecision(2))}\u00a0ms`) : state;
}

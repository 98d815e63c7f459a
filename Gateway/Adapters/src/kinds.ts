import type { Kind, RunAdapter } from './adapter';
import { ads } from './ads/kind';
import { broker } from './broker/settings';
import { mqtt } from './mqtt/settings';
import { opcua } from './opcua/kind';
import { ros } from './ros/settings';
import { rtde } from './rtde/settings';

/** The kinds by the value of plant.kind. */
export const kinds: Record<string, Kind> = { ads, broker, mqtt, opcua, ros, rtde };

/** Loads a kind. Each is a separate bundle next to this one, so that none waits for another's libraries. */
export async function load(kind: string): Promise<RunAdapter> {
  const bundle = (await import(new URL(`./${kind}.mjs`, import.meta.url).href)) as { run: RunAdapter };
  return bundle.run;
}

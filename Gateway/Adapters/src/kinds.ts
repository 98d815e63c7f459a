import type { Kind, RunAdapter } from './adapter';
import { ads } from './ads/kind';
import { broker } from './broker/settings';
import { mqtt } from './mqtt/settings';
import { opcua } from './opcua/kind';
import { ros } from './ros/settings';
import { rtde } from './rtde/settings';

/** The kinds of plant, by the value of plant.kind. */
export const kinds: Record<string, Kind> = { ads, broker, mqtt, opcua, ros, rtde };

/** Loads the adapter of a kind. Each kind is a separate bundle next to this one, so that only its own libraries are loaded. */
export async function load(kind: string): Promise<RunAdapter> {
  const bundle = (await import(new URL(`./${kind}.mjs`, import.meta.url).href)) as { run: RunAdapter };
  return bundle.run;
}

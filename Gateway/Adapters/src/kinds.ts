import type { Kind, RunAdapter } from './adapter';
import { ads } from './ads/kind';
import { broker } from './broker/kind';
import { mqtt } from './mqtt/kind';
import { opcua } from './opcua/kind';
import { ros } from './ros/kind';
import { rtde } from './rtde/kind';
import type { KindName } from './configuration/plantFile';

/** The kinds of plant, by the value of plant.kind. */
export const kinds: Record<KindName, Kind> = { ads, broker, mqtt, opcua, ros, rtde };

/** Loads the adapter of a kind. Each kind is a separate bundle next to this one, so that only its own libraries are loaded. */
export async function load(kind: KindName): Promise<RunAdapter> {
  const bundle = (await import(new URL(`./${kind}.mjs`, import.meta.url).href)) as { run: RunAdapter };
  return bundle.run;
}

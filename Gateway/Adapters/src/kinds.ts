import type { Kind, RunAdapter } from './adapter';
import { ads } from './ads/kind';
import { broker } from './broker/settings';
import { opcua } from './opcua/kind';
import { ros } from './ros/settings';
import { rtde } from './rtde/settings';

/** By the name that plant.kind has. */
export const kinds: Record<string, Kind> = { ads, broker, opcua, ros, rtde };

/** Each kind is a bundle of its own beside this one, so that none waits for the libraries of another. */
export async function load(kind: string): Promise<RunAdapter> {
  const bundle = await import(new URL(`./${kind}.mjs`, import.meta.url).href) as { run: RunAdapter };
  return bundle.run;
}

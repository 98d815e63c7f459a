import type { PlantFiles } from '../../dist/plantFiles';

/** The name of a kind of plant, which is the value of plant.kind. */
export type KindName = keyof PlantFiles;

/** The content of a file of a kind, as specified in the schema. The check against the schema has set the defaults. */
export type PlantFile<K extends KindName = KindName> = PlantFiles[K];

/** The elements of a section that is a list, for any kind of plant. */
export type EntryOf<Section extends 'joints' | 'frames' | 'signals'> = AnyOf<NonNullable<AnyOf<PlantFile>[Section]>[number]>;

/** A section of any kind of plant. An entry that this kind does not have is absent. */
export type AnyOf<Section> = Section & { [Name in Exclude<NameIn<Section>, keyof Section>]?: ValueOf<Section, Name> };

type NameIn<Section> = Section extends unknown ? keyof Section : never;

type ValueOf<Section, Name> = Section extends unknown ? (Name extends keyof Section ? Section[Name] : never) : never;

/** Meaning of missing data. */
export type Silence = NonNullable<PlantFile<'opcua'>['plant']['silence']>;

/** Gets the time in ms without data that counts as a fault; null if missing data mean rest. */
export const silenceMs = (silence: Silence): number | null => (typeof silence === 'object' ? 1000 * silence.fault_after_s : null);

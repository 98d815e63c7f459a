import type { ErrorObject, ValidateFunction } from 'ajv';
import { checks, schema } from 'plant.schema';
import { nearest } from './nearest';
import type { KindName, PlantFile } from './plantFile';
import { shown } from './problem';
import { replaceInvalid } from './validPart';
import type { Path, YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

/** A part of the schema. */
export interface Described {
  $ref?: string;
  description?: string;
  enum?: unknown[];
  properties?: Record<string, Described>;
}

/** The kinds of plant that the schema describes. */
export const KINDS = Object.keys(checks) as KindName[];

/** Whether a kind of plant may have an entry of this name at the top level. */
export const hasEntry = (kind: KindName, name: string): boolean => name in schema.$defs[kind].properties!;

/** Gets the names of all entries that any kind of plant may have at the top level, or in the section at this path. */
export const knownEntries = (path: string[]): string[] =>
  KINDS.flatMap(kind => Object.keys(path.reduce((section, step) => section.properties![step], schema.$defs[kind]).properties!));

/**
 * Reports each entry that violates the schema of a kind of plant. Sets missing entries to their defaults, and replaces invalid entries, so that all
 * other entries can be checked.
 * @returns The content of the file. An entry that was replaced and has no default may be undefined.
 */
export function checkAgainstSchema(file: YamlFile, kind: KindName): PlantFile {
  const check = checks[kind];
  if (check(file.value)) return file.value as PlantFile;
  const errors = check.errors!.filter(e => !['if', 'oneOf', 'anyOf', 'allOf', 'not'].includes(e.keyword) || isOwnWords(e));
  const all = errors.map(error => inWords(error, file.value));
  const misspelt = all.filter(({ meant }) => meant !== undefined && !file.has(meant));
  const isConsequence = consequencesIn(file, misspelt, check);
  const wrong = all.filter((_, i) => !isConsequence(errors[i]));
  for (const { path, text } of wrong) {
    file.report(path, text);
    file.markInvalid(path);
  }
  for (const { path, meant, isTooLong } of wrong) {
    if (isTooLong !== true) replaceInvalid(file, path);
    if (meant === undefined || file.has(meant)) continue;
    file.markInvalid(meant);
    replaceInvalid(file, meant);
  }
  // Sets the replaced entries to their defaults.
  check(file.value);
  return file.value as PlantFile;
}

// Whether the schema describes the allowed forms of an entry in words, so that one message can report that none of them matches.
const isOwnWords = (error: ErrorObject): boolean => error.keyword !== 'if' && (error.parentSchema as Described)?.description !== undefined;

/**
 * Returns a function that determines whether an error would not exist if the misspelt entries had the names that were probably meant. The error of a
 * required entry is not a consequence: it states what to enter.
 */
function consequencesIn(file: YamlFile, misspelt: Wrong[], check: ValidateFunction): (error: ErrorObject) => boolean {
  if (misspelt.length === 0) return () => false;
  const corrected = structuredClone(file.value);
  for (const { path, meant } of misspelt) {
    const section = path.slice(0, -1).reduce((part, step) => (part as Record<string | number, unknown>)[step], corrected) as Record<string, unknown>;
    section[meant![meant!.length - 1]] = section[path[path.length - 1]];
    delete section[path[path.length - 1]];
  }
  check(corrected);
  const idOf = ({ instancePath, schemaPath, params }: ErrorObject): string => JSON.stringify([instancePath, schemaPath, params]);
  const remaining = new Set(check.errors?.map(idOf));
  return error => !['required', 'additionalProperties'].includes(error.keyword) && !remaining.has(idOf(error));
}

/** An entry that violates the schema. */
interface Wrong {
  path: Path;
  text: string;
  /** For an unknown entry, the entry that was probably meant. */
  meant?: Path;
  /** Whether the entry only has too many elements, which can be checked like the others. */
  isTooLong?: boolean;
}

function inWords(error: ErrorObject, root: unknown): Wrong {
  const key = error.propertyName ?? (error.keyword === 'propertyNames' ? (error.params.propertyName as string) : undefined);
  const at = [...pathOf(error.instancePath, root), ...(key === undefined ? [] : [key])];
  const parent = error.parentSchema as Described;
  switch (error.keyword) {
    case 'required': {
      const name = error.params.missingProperty as string;
      return { path: [...at, name], text: `missing${because(named(parent.properties?.[name]))}` };
    }
    case 'additionalProperties': {
      const name = error.params.additionalProperty as string;
      const known = Object.keys(parent.properties ?? {});
      const [guess] = nearest(name, known);
      return { path: [...at, name], text: configurationMessages.unknownEntry(guess, known), meant: guess === undefined ? undefined : [...at, guess] };
    }
    case 'dependencies': {
      const { property, missingProperty } = error.params as Record<'property' | 'missingProperty', string>;
      return { path: [...at, missingProperty], text: `missing, but ${property} needs it${because(named(parent.properties?.[missingProperty]))}` };
    }
    case 'const':
    case 'enum': {
      const allowed = (parent.enum ?? [error.params.allowedValue]).map(String);
      const guess = typeof error.data === 'string' ? nearest(error.data, allowed)[0] : undefined;
      return { path: at, text: configurationMessages.notAllowed(error.data, guess, allowed) };
    }
    case 'maxItems':
    case 'maxProperties':
      return {
        path: at,
        text: configurationMessages.tooMany(Object.keys(error.data as object).length, error.params.limit as number),
        isTooLong: true,
      };
    default:
      return { path: at, text: `value ${shown(error.data)}; ${parent.description ? `allowed: ${parent.description}` : error.message}` };
  }
}

/** Gets the definition of a property. Follows a reference to another definition. */
const named = (property?: Described): Described | undefined =>
  property?.$ref === undefined ? property : schema.$defs[property.$ref.replace('#/$defs/', '')];

const because = (property?: Described): string =>
  property?.enum ? `; allowed: ${property.enum.join(', ')}` : property?.description ? `; add ${property.description}` : '';

// Converts a JSON pointer of Ajv to a path. Looks at the value, because a pointer does not distinguish an index from a numeric key.
function pathOf(pointer: string, root: unknown): Path {
  let value = root;
  return pointer
    .split('/')
    .slice(1)
    .map(part => {
      const key = part.replaceAll('~1', '/').replaceAll('~0', '~');
      const step = Array.isArray(value) ? Number(key) : key;
      value = (value as Record<string | number, unknown> | undefined)?.[step];
      return step;
    });
}

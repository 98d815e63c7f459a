import type { Path, YamlFile } from './yamlFile';

/** The entry with the name of each element of a list. */
const NAMES: Record<string, string> = { joints: 'joint', frames: 'frame', signals: 'signal' };

type Section = Record<string | number, unknown>;

const isSection = (value: unknown): value is Section => typeof value === 'object' && value !== null && !Array.isArray(value);

/**
 * Replaces an entry that violates the schema, so that the following checks can use the entries beside it: an invalid name or endpoint by an empty
 * text, an invalid position by the origin, an invalid list of joints, frames or signals by an empty one, and any other entry by undefined. Keeps the
 * other elements of a list, because joints without an index depend on their places.
 * @param path The entry; for an invalid part of an entry of a list element, the whole entry is replaced.
 */
export function replaceInvalid(file: YamlFile, [section, entry, key, ...inner]: Path): void {
  const root = file.value as Section;
  const name = NAMES[section];
  const found = root[section];
  if (entry === undefined) root[section] = name === undefined ? undefined : [];
  else if (name !== undefined) {
    const list = found as unknown[];
    if (!isSection(list[Number(entry)])) list[Number(entry)] = {};
    replaceInElement(file, list[Number(entry)] as Section, [section, entry], name, key ?? name);
  } else replaceAt(found as Section, [entry, ...(key === undefined ? [] : [key]), ...inner]);
}

function replaceInElement(file: YamlFile, element: Section, at: Path, name: string, key: string | number): void {
  element[key] = key === name ? '' : undefined;
  // Other checks of the element would state its name.
  if (key === name) for (const path of [at, [...at, name]]) file.markInvalid(path);
  // The field of RTDE has the position.
  if (at[0] === 'frames' && (key === 'position' || key === 'field') && element.position === undefined) {
    element.position = { unit: 'm', x: 0, y: 0, z: 0 };
    file.markInvalid([...at, 'position']);
  }
}

/** Replaces the entry if its parents are sections. The path of a missing entry has them too. */
function replaceAt(section: unknown, [step, ...rest]: Path): void {
  if (!isSection(section) && !Array.isArray(section)) return;
  if (rest.length > 0) replaceAt((section as Section)[step], rest);
  else (section as Section)[step] = step === 'endpoint' ? '' : undefined;
}

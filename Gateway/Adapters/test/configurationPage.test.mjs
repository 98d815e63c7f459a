// Compares the manual's list of all entries of a plant's file with the schema.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { kinds, schema } from '../loading.mjs';
import { adapters } from './program.mjs';

const page = readFileSync(join(adapters, '../../Packages/com.nowpose.mril/Documentation~/plant-configuration.md'), 'utf8');

/** Entries of plant whose own entries the page lists as ENTRY.NAME. */
const NESTED = ['user', 'security', 'time', 'topics', 'clock'];

const resolved = ({ $ref, ...own }) => ($ref === undefined ? own : { ...schema.$defs[$ref.split('/').at(-1)], ...own });

/** Returns [name, definition, isRequired] for each entry of an object in the schema. */
function entriesOf({ properties, required = [] }, prefix = '') {
  return Object.entries(properties).flatMap(([name, property]) => {
    const definition = resolved(property), entry = [prefix + name, definition, required.includes(name)];
    const isNested = prefix === '' && NESTED.includes(name) && definition.properties !== undefined;
    return isNested ? [entry, ...entriesOf(definition, `${name}.`)] : [entry];
  });
}

/** Returns the entries of a section of a kind of plant; an empty list if the kind does not have the section. */
function schemaEntries(kind, section) {
  const top = schema.$defs[kind];
  if (section === 'sections') return entriesOf(top);
  if (top.properties[section] === undefined) return [];
  const definition = resolved(top.properties[section]);
  return entriesOf(definition.type === 'array' ? resolved(definition.items) : definition);
}

/** Returns a default as the page writes it; an empty text for a section whose entries have defaults. */
const textOf = value => (typeof value === 'object' ? Object.entries(value).map(([name, part]) => `${name}: ${part}`).join(', ') : String(value));

/** Returns the rows of the table below a heading, by "ENTRY KIND". */
function rowsUnder(heading) {
  const section = page.split(/^## /m).find(text => text.startsWith(`${heading}\n`));
  const rows = section.split('\n').filter(line => line.startsWith('| `')).map(line => line.split('|').slice(1, -1).map(cell => cell.trim()));
  return new Map(rows.flatMap(([names, of, standard, meaning]) => [...names.matchAll(/`([^`]+)`/g)].flatMap(([, name]) =>
    (of === 'all' ? kinds : of.split(', ')).map(kind => [`${name} ${kind}`, { standard, meaning }]))));
}

describe('the page about the configuration of a plant', () => {
  for (const heading of ['Sections', 'Gateway', 'Plant', 'Joints', 'Frames', 'Signals']) {
    const expected = kinds.flatMap(kind => schemaEntries(kind, heading.toLowerCase()).map(([name, definition, isRequired]) => ({ key: `${name} ${kind}`, definition, isRequired })));
    const rows = rowsUnder(heading);

    it(`${heading}_Entries_AreThoseOfTheSchema`, () => assert.deepEqual([...rows.keys()].sort(), expected.map(({ key }) => key).sort()));

    it(`${heading}_Defaults_AreThoseOfTheSchema`, () => {
      const wrong = expected.filter(({ key, definition, isRequired }) => {
        const { standard } = rows.get(key), { default: value } = definition;
        return (isRequired && !standard.startsWith('required')) || (value !== undefined && !Array.isArray(value) && !standard.includes(textOf(value)));
      });

      assert.deepEqual(wrong.map(({ key }) => key), []);
    });

    it(`${heading}_Ranges_AreThoseOfTheSchema`, () => {
      const wrong = expected.filter(({ key, definition: { minimum, maximum, enum: values = [], maxItems, maxProperties } }) => {
        const { meaning } = rows.get(key), most = maxItems ?? maxProperties;
        const hasRange = maximum === undefined || meaning.includes(`${minimum} to ${maximum}`);
        const hasMost = most === undefined || new RegExp(`(at most|to) ${most}\\b`).test(meaning);
        return !hasRange || !hasMost || !(meaning.startsWith('the same') || values.every(value => meaning.includes(`\`${value}\``)));
      });

      assert.deepEqual(wrong.map(({ key }) => key), []);
    });
  }
});

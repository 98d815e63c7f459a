// Damages configurations randomly. Each of them must be valid, or each of its error messages must contain a line number.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { wrongIn } from './checking.mjs';
import { adapters } from './program.mjs';
import { seeded } from './seeded.mjs';
import { temporaryFile } from './temporary.mjs';

const SEED = 4711, VARIANTS = 1000;
const folder = join(adapters, 'examples');
const NAMES = readdirSync(folder, { recursive: true }).filter(name => name.endsWith('.yaml')).sort();
const EXAMPLES = NAMES.map(name => readFileSync(join(folder, name), 'utf8'));

/** Strings that replace values or are inserted into a configuration. */
const ODD = [
  '', '~', '[]', '{}', '[[[]]]', '-1', '0', '1e400', '.nan', '-.inf', '0x10', '99999999999999999999', 'true', '"', "'", '|', '>-', '&a', '*a',
  '<<: *a', '? [a]', '!!binary x', '!!set {a}', '!own x', '%YAML 9.9', '---', '...', '#', ': :', '- - -', '\t',
  '\u0000', '\u2028', '\ud800', 'é', '2026-01-01',
  '__proto__', 'constructor: {a: 1}', '{plant: {kind: opcua}}', 'x'.repeat(3000), '[a, '.repeat(40),
  `opc.tcp://${'a'.repeat(300)}:99999`,
];

function damaged(text, random) {
  const pick = list => list[Math.floor(random() * list.length)], at = length => Math.floor(random() * (length + 1));
  const lines = text.split('\n'), place = at(lines.length - 1), line = lines[place], [key] = line.split(/(?<=:) /);
  switch (Math.floor(random() * 9)) {
    case 0: lines.splice(place, 1); break;
    case 1: lines.splice(at(lines.length), 0, line); break;
    case 2: lines[place] = `${key} ${pick(ODD)}`; break;
    case 3: lines[place] = ' '.repeat(at(6)) + line.trimStart(); break;
    case 4: lines[place] = line.replace('# ', ''); break;
    case 5: return text.slice(0, at(text.length));
    case 6: lines.splice(place, 0, pick(ODD)); break;
    case 7: [lines[place], lines[0]] = [lines[0], line]; break;
    default: {
      const column = at(line.length);
      lines[place] = line.slice(0, column) + pick([...'{}[]:,#&*!|>%@`"\'-? \t0a', ...ODD]) + line.slice(column + at(2));
    }
  }
  return lines.join('\n');
}

it('Configuration_RandomlyDamaged_IsValidOrEachErrorHasALine', { timeout: 120_000 }, async t => {
  const random = seeded(SEED), path = temporaryFile('plant.yaml', ''), warnings = [];
  const warn = warning => warnings.push(warning.message);
  process.on('warning', warn);
  t.after(() => process.off('warning', warn));
  let refused = 0;

  for (let i = 0; i < VARIANTS; i++) {
    let text = EXAMPLES[i % EXAMPLES.length];
    for (let depth = 0; depth <= i % 3; depth++) text = damaged(text, random);
    // A new file is written 20 times faster than an existing one, which some file systems write to the disk at once.
    rmSync(path);
    writeFileSync(path, text);

    const lines = wrongIn(path), context = `variant ${i} of seed ${SEED}:\n${lines.join('\n')}\n---\n${text}`;

    const last = text.split('\n').length;
    for (const line of lines) {
      assert.ok(line.startsWith(`${path}, line `), context);
      const number = Number(/line (\d+): ./.exec(line)?.[1]);
      assert.ok(number >= 1 && number <= last, context);
    }
    if (lines.length > 0) refused++;
  }

  await new Promise(resolve => setImmediate(resolve));
  assert.ok(refused > VARIANTS / 4, `${refused} of ${VARIANTS} were refused`);
  assert.deepEqual(warnings, []);
});

// Prints how often a second code of a kind is found, by the share of it that is hidden: `npm run second-codes -- COUNT SEED`.
import { groups, groupPictures, hidings, isFound, onePicture, perforatedPlate, randomOf, strongCodes, withSecond } from './pictures.mjs';
import { askAll } from './workers.mjs';

const [count = 2, seed = 11] = process.argv.slice(2).map(Number);
const shares = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7];
const kinds = ['Control', 'Headset'];
/** Conditions of the pictures with a second code: clean, blurred, tilted and dark. */
const conditions = Object.values(groups).slice(0, 4);

const others = [
  ...groupPictures(seed, 6 * count),
  { name: 'with a perforated plate', shots: Array.from({ length: 12 * count }, (_, i) => perforatedPlate(randomOf(seed + 100 + i))) },
];
const seconds = shares.flatMap(share => kinds.flatMap(kind => hidings.flatMap(hiding => Array.from({ length: count }, (_, i) => {
  const random = randomOf(seed + 7919 * (i + count * (hidings.indexOf(hiding) + 20 * (kinds.indexOf(kind) + 2 * shares.indexOf(share)))));
  return { share, kind, hiding, shot: withSecond(random, onePicture(random, random.pick(conditions)), kind, hiding, share) };
}))));

const answers = await askAll([...others.flatMap(({ shots }) => shots), ...seconds.map(({ shot }) => shot)].map(shot => ({ shot })));
console.log('| one code of each kind | pictures | both found | second code reported |\n| --- | ---: | ---: | ---: |');
for (const { name, shots } of others) {
  const of = answers.splice(0, shots.length);
  const both = of.filter((answer, i) => shots[i].codes.slice(0, 2).every(code => isFound(answer, code))).length;
  console.log(`| ${name} | ${shots.length} | ${both} | ${of.filter(answer => strongCodes(answer).length > 2).length} |`);
}
// A picture in which a complete code is not found is rejected in any case.
const cases = seconds.map((each, i) => ({ ...each, answer: answers[i] })).filter(({ shot, answer }) => shot.codes.slice(0, 2).every(code => isFound(answer, code)));
console.log(`\n| second code found, hidden share | ${shares.map(share => `${100 * share} %`).join(' | ')} |\n| --- |${' ---: |'.repeat(shares.length)}`);
const line = (name, isChosen) => {
  const cells = shares.map(share => {
    const of = cases.filter(each => each.share === share && isChosen(each));
    return `${of.filter(({ answer }) => strongCodes(answer).length > 2).length} of ${of.length}`;
  });
  console.log(`| ${[name, ...cells].join(' | ')} |`);
};
for (const kind of kinds) line(kind, each => each.kind === kind);
for (const by of ['edge', 'object']) line(`hidden on one side by ${by === 'edge' ? "the picture's edge" : 'an object'}`, ({ hiding }) => hiding.by === by && hiding.from !== 'middle');
line('crossed by a bar', ({ hiding }) => hiding.from === 'middle');
line('side less than 110 px', ({ shot }) => shot.codes[2].size < 110);
line('side 110 px or more', ({ shot }) => shot.codes[2].size >= 110);

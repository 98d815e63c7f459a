// Runs the bundled worker as the command line does: sends a pattern, then pictures that the worker renders and reads.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { getPriority, tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { hidings, isFound, isLit, onePicture, pairs, perforatedPlate, randomOf, ring, strongCodes, withSecond } from './study/pictures.mjs';
import { shareOut, startWorker } from './study/workers.mjs';

const ones = pair => pair * 5 % 7 < 3;
function lit(kind) {
  const share = Array(64).fill(0);
  for (const cell of ring) share[cell] = isLit(cell, kind) ? 1 : 0;
  pairs.forEach((cell, pair) => { share[ones(pair) ? cell : cell + 1] = 1; });
  return share;
}

const square = (x, y, side, turn) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => [
  x + side / 2 * (u * Math.cos(turn) - v * Math.sin(turn)), y + side / 2 * (u * Math.sin(turn) + v * Math.cos(turn)),
]);

function shot(codes) {
  return { width: 1280, height: 720, scene: 5, sceneLight: 0.5, codes, blur: 1, motion: [0, 0], glares: [], covers: [], noise: 3, noiseSeed: 1 };
}

const control = { corners: square(400, 360, 90, 0.2), lit: lit('Control'), light: 0.6, dot: 0.7, panel: 0.03 };
const headset = { corners: square(800, 360, 150, 3.3), lit: lit('Headset'), light: 0.4, dot: 0, panel: null };

// All tests use the same two workers, because each worker is slow with its first pictures.
const workers = [startWorker(), startWorker()];
after(() => workers.forEach(({ end }) => end()));

/** Responses for rendered pictures, by request, because several tests read the same picture. */
const read = new Map();

/** Returns the responses of one worker to all requests, in their order. */
const ask = (...requests) => Promise.all(requests.map(request => {
  if (!request.shot || request.to) return workers[0].ask(request);
  const key = JSON.stringify(request);
  if (!read.has(key)) read.set(key, workers[0].ask(request));
  return read.get(key);
}));

/** Returns the responses to many independent requests. */
const askAll = requests => shareOut(requests, workers);

test('finds both codes in any orientation and reads their cells', async () => {
  const [{ codes }] = await ask({ shot: shot([control, headset]) });

  assert.deepEqual(codes.map(code => code.kind).sort(), ['Control', 'Headset']);
  for (const code of codes) {
    const { corners } = code.kind === 'Control' ? control : headset;
    code.corners.forEach(([x, y], i) => assert.ok(Math.hypot(x - corners[i][0], y - corners[i][1]) < 6, `${code.kind} corner ${i} at ${x}, ${y}`));
    pairs.forEach((cell, pair) => assert.equal(code.levels[cell] > code.levels[cell + 1], ones(pair), `${code.kind} pair ${pair}`));
  }
});

test('finds several codes of one kind', async () => {
  const second = { ...control, corners: square(400, 160, 76, -0.4) };

  const [{ codes }] = await ask({ shot: shot([control, headset, second]) });

  assert.deepEqual(codes.map(code => code.kind).sort(), ['Control', 'Control', 'Headset']);
});

test('finds a weak code beside bright codes at each position where it is found without them', async () => {
  const weak = [control, headset].flatMap(code => [0, 2, 5, 7].map(i => {
    const isLeds = code === control;
    return {
      ...shot([{
        ...code, corners: square(500 + 60 * i, 120, 80 + 5 * i, 0.05 * i - 0.2), light: isLeds ? 0.12 + 0.02 * i : code.light * (0.3 + 0.05 * i), dot: isLeds ? 0.5 + 0.02 * i : 0,
      }]),
      scene: 40 + i, sceneLight: 0.4 + 0.05 * i, blur: isLeds ? 2 + i / 8 : 1.5,
    };
  }));
  const both = weak.map(each => ({ ...each, codes: [{ ...control, light: 0.8 }, headset, ...each.codes] }));

  const answers = await askAll([...weak, ...both].map(each => ({ shot: each })));

  const alone = answers.slice(0, weak.length).map(({ codes }) => codes.length);
  assert.ok(alone.filter(count => count === 1).length >= 7, `${alone}`);
  assert.deepEqual(answers.slice(weak.length).map(({ codes }) => codes.filter(code => !code.isWeak).length), alone.map(count => 2 + count));
});

test('finds a second code of which a part is covered or outside the picture', async () => {
  const side = 130;
  const hidden = share => {
    const width = share * side;
    const at = (x, y) => [x, y, width + 10, 1.2 * side];
    const whole = { y: 110, x: 640 };
    return [
      { ...whole, box: at(640 + side / 2 - width, 110 - 0.6 * side) },
      { ...whole, box: at(640 - side / 2 - 10, 110 - 0.6 * side) },
      { ...whole, box: at(640 - width / 2 - 5, 110 - 0.6 * side) },
      { y: 600, x: 1280 - side / 2 + width },
      { y: side / 2 - width, x: 640 },
    ];
  };
  // Each place once with each code: with the small and the large part in turn.
  const shots = [control, headset].flatMap((code, kind) => [0, 1, 2, 3, 4].map(place => {
    const { x, y, box } = hidden([0.1, 0.3][(place + kind) % 2])[place];
    return { ...shot([control, headset, { ...code, corners: square(x, y, side, 0.02) }]), covers: box ? [{ box, light: 0.1 }] : [] };
  }));

  const answers = await askAll(shots.map(each => ({ shot: each })));

  assert.deepEqual(answers.map(({ codes }) => codes.filter(code => !code.isWeak).length), shots.map(() => 3));
});

// Seeds that were not used to select the limits.
test('finds a second code of which up to 45 % is hidden on one side', async () => {
  const sides = hidings.filter(({ from }) => from !== 'middle');
  const drawn = sides.map((hiding, i) => {
    const random = randomOf(400 + i);
    return withSecond(random, onePicture(random), ['Control', 'Headset'][(i >> 1) % 2], hiding, 0.3 + 0.05 * (i % 4), random.between(100, 200));
  });

  const answers = await askAll(drawn.map(each => ({ shot: each })));

  const complete = answers.filter((answer, i) => drawn[i].codes.slice(0, 2).every(code => isFound(answer, code)));
  const found = complete.filter(answer => strongCodes(answer).length > 2);
  assert.ok(complete.length >= 7 && found.length >= 0.85 * complete.length, `seeds 400 to 407: ${found.length} of ${complete.length}`);
});

test('finds corners with an RMS error of less than 0.09 cells', async () => {
  const drawn = Array.from({ length: 8 }, (_, i) => onePicture(randomOf(500 + i)));

  const answers = await askAll(drawn.map(each => ({ shot: each })));

  const errors = answers.flatMap(({ codes }, i) => drawn[i].codes.flatMap(({ kind, size, corners }) => {
    const code = codes.find(each => each.kind === kind);
    return corners.map(([x, y], corner) => 8 * Math.hypot(x - code.corners[corner][0], y - code.corners[corner][1]) / size);
  }));
  const rms = Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length);
  assert.ok(rms < 0.09, `seeds 500 to 507: ${rms} cells`);
});

test('finds no second code in structured scenes', async () => {
  const answers = await askAll(Array.from({ length: 6 }, (_, scene) => ({ shot: { ...shot([control, headset]), scene: 100 + scene, sceneLight: 0.8 } })));

  for (const { codes } of answers) assert.ok(codes.filter(code => !code.isWeak).length <= 2);
});

// A lattice of dark holes with a pitch of two cells resembles a code with its ring, in which all pairs are equal. At most positions, the light of a
// dark cell of this code differs from that of the scene. A lattice without any difference is accepted, because a real code must not be missed.
test('mistakes only a few perforated plates for part of a second code', async () => {
  const answers = await askAll(Array.from({ length: 4 }, (_, i) => ({ shot: perforatedPlate(randomOf(600 + i)) })));

  for (const { codes } of answers) assert.deepEqual(new Set(codes.map(({ kind }) => kind)), new Set(['Control', 'Headset']));
  const mistaken = answers.filter(answer => strongCodes(answer).length > 2).length;
  assert.equal(mistaken, 0, `seeds 600 to 603: ${mistaken} of ${answers.length}`);
});

test('names the format of a HEIC picture', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'nowpose-'));
  try {
    const file = join(folder, 'a.jpg');
    writeFileSync(file, Buffer.concat([Buffer.from([0, 0, 0, 24]), Buffer.from('ftypheic')]));

    const [{ error }] = await ask({ file });

    assert.match(error, /HEIC.*convert/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('recognises a mirrored picture and reports no codes in it', async () => {
  const mirrored = code => ({ ...code, corners: [1, 0, 3, 2].map(i => code.corners[i]) });

  const [seen, upright, empty] = await ask({ shot: shot([mirrored(control), mirrored(headset)]) }, { shot: shot([control, headset]) }, { shot: shot([]) });

  assert.deepEqual(seen.codes, []);
  assert.deepEqual([seen, upright, empty].map(answer => answer.isMirrored), [true, false, false]);
});

test('finds and reads a weak hologram in front of scenes with equally bright edges', async () => {
  const weak = { ...headset, light: 0.25 };
  const answers = await askAll(Array.from({ length: 8 }, (_, scene) => ({ shot: { ...shot([weak]), scene, sceneLight: 0.9 } })));

  const read = answers.filter(({ codes }) => {
    const { levels } = codes.find(code => code.kind === 'Headset') ?? {};
    return levels && pairs.every((cell, pair) => Math.abs((levels[cell] - levels[cell + 1]) / levels[0] - (ones(pair) ? 1 : -1)) < 0.5);
  });
  assert.ok(read.length >= 7, `${read.length} of ${answers.length}`);
});

test('finds and reads LEDs in a narrow housing in front of a brighter board', async () => {
  const leds = { ...control, corners: square(400, 360, 76, 0.2), light: 0.3 };
  const board = { corners: square(400, 360, 220, 0.2), lit: Array(64).fill(1), light: 0.8, dot: 0, panel: null };

  const answers = await askAll(Array.from({ length: 6 }, (_, scene) => ({ shot: { ...shot([board, leds]), scene, blur: 1.6 } })));

  const read = answers.filter(({ codes }) => {
    const { levels } = codes.find(code => code.kind === 'Control') ?? {};
    return levels && pairs.every((cell, pair) => levels[cell] > levels[cell + 1] === ones(pair));
  });
  assert.equal(read.length, answers.length);
});

test('reads overexposed LEDs in a colour that is not clipped', async () => {
  // Some pairs change during the exposure: both of their cells are lit for a part of it, and look equal where both are clipped.
  const changed = control.lit.map((share, cell) => (cell >= 49 && cell <= 54 ? (share === 1 ? 0.7 : 0.3) : share));
  const overexposed = colour => ({ ...control, lit: changed, light: 4, colour });
  const folder = mkdtempSync(join(tmpdir(), 'nowpose-'));
  try {
    for (const colour of [[1, 0.07, 0.03], [0.15, 1, 0.25]]) {
      const file = join(folder, 'a.png');
      const [{ codes: made }, , { codes: read }] = await ask(
        { shot: shot([overexposed(colour), headset]) }, { shot: shot([overexposed(colour), headset]), to: file }, { file });

      for (const codes of [made, read]) {
        const { levels } = codes.find(code => code.kind === 'Control');
        const contrast = (levels[49] - levels[50]) / levels[0];
        assert.ok(Math.abs(Math.abs(contrast) - 0.4) < 0.15, `${colour}: ${contrast}`);
      }
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('reports a larger residual if another board shows through the gaps between the cells', async () => {
  const board = { ...control, corners: square(400, 360, 130, 0.1), panel: 0.03, dot: 0.7 };
  // A second board, seen through the gaps in the board in front of it.
  const other = { ...control, corners: square(418, 383, 120, 0.25), lit: lit('Control').map(share => 1 - share), panel: null };

  const answers = await ask({ shot: shot([board, headset]) }, { shot: shot([board, other, headset]) });

  const [alone, disturbed] = answers.map(({ codes }) => codes.find(code => code.kind === 'Control')?.residual ?? 1);
  assert.ok(alone < 0.1 && disturbed > 0.16, `${alone}, ${disturbed}`);
});

test('continues after an interrupt signal', async () => {
  process.kill(workers[1].pid, 'SIGINT');

  assert.deepEqual((await workers[1].ask({ shot: shot([]) })).codes, []);
});

test('lowers its priority, but never increases it', { skip: process.platform === 'win32' }, async () => {
  const lowest = startWorker('nice', '-n', '19', 'node');
  after(lowest.end);
  await lowest.ask({ file: '/nowhere/a.png' });

  assert.equal(getPriority(workers[0].pid), Math.max(10, getPriority()));
  assert.equal(getPriority(lowest.pid), 19);
});

test('finds no codes in a picture without codes', async () => {
  const [{ codes }] = await ask({ shot: shot([]) });

  assert.deepEqual(codes, []);
});

test('responds to a missing file with an error and reads the next picture', async () => {
  const [missing, next] = await ask({ file: '/nowhere/a.png' }, { shot: shot([control, headset]) });

  assert.match(missing.error, /no such file/);
  assert.equal(next.codes.length, 2);
});

test('a picture that cannot be completed leaves no file', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'nowpose-vision-'));
  try {
    const to = join(folder, 'picture.png');
    mkdirSync(to);

    const [{ error }] = await ask({ shot: shot([control, headset]), to });

    assert.ok(error);
    assert.deepEqual(readdirSync(folder), ['picture.png']);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

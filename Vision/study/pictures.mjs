// Draws random pictures of codes with known places from a seed, for the measurements in this folder and for the tests of the worker.

const side = 8;
const cells = [...Array(side * side).keys()];
export const ring = cells.filter(cell => cell < side || cell >= 56 || cell % side === 0 || cell % side === 7);
export const pairs = [...Array(18).keys()].map(pair => (1 + Math.floor(pair / 3)) * side + 1 + (pair % 3) * 2);
export const isLit = (cell, kind) => cell !== 1 && cell !== 2 && (kind === 'Control' || (cell !== 15 && cell !== 23));

/** The pattern that the command line sends to a worker. */
export const pattern = { side, pairs, ring, kinds: {} };
for (const kind of ['Control', 'Headset']) pattern.kinds[kind] = { lit: ring.map(cell => isLit(cell, kind)), isFilled: kind === 'Headset' };

export const width = 1280;
export const height = 720;

/** Generator of uniform random numbers (mulberry32, T. Ettinger, public domain). */
export function randomOf(seed) {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
  const between = (a, b) => a + (b - a) * next();
  return { next, between, pick: list => list[Math.floor(next() * list.length)] };
}

/** Cells of a code that shows the milliseconds from `ms` on for an exposure; see TimestampCode.cs. */
function litAt(kind, ms, exposureMs) {
  const lit = Array(64).fill(0);
  for (const cell of ring) lit[cell] = isLit(cell, kind) ? 1 : 0;
  const parity = bits => [...bits.toString(2)].filter(bit => bit === '1').length & 1;
  for (let i = 0; i < exposureMs; i++) {
    const value = (ms + i) & 0xffff;
    const gray = value ^ (value >> 1);
    const word = (gray << 2) | (parity(gray & 0x5555) << 1) | parity(gray & 0xaaaa);
    pairs.forEach((cell, pair) => {
      lit[(word >> (17 - pair)) & 1 ? cell : cell + 1] += 1 / exposureMs;
    });
  }
  return lit;
}

/** Corners of a square in perspective. `tilt` is the angle in radians about an axis in the plane of the code. */
function cornersOf({ x, y, side: size, turn, tilt, axis }) {
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => {
    const along = u * Math.cos(axis) + v * Math.sin(axis);
    const across = -u * Math.sin(axis) + v * Math.cos(axis);
    const near = 1 + 0.25 * Math.sin(tilt) * across;
    const [a, b] = [along / near, (across * Math.cos(tilt)) / near];
    const [p, q] = [a * Math.cos(axis) - b * Math.sin(axis), a * Math.sin(axis) + b * Math.cos(axis)];
    return [x + (size / 2) * (p * Math.cos(turn) - q * Math.sin(turn)), y + (size / 2) * (p * Math.sin(turn) + q * Math.cos(turn))];
  });
}

const facing = random => ({ turn: random.between(-0.35, 0.35), tilt: random.between(0, 0.25), axis: random.between(0, 2 * Math.PI) });

/** Draws a code as `calibrate simulate` does: LEDs, some on a panel, or a hologram. */
function codeOf(random, kind, pose, ms) {
  const isControl = kind === 'Control';
  return {
    corners: cornersOf(pose),
    lit: litAt(kind, ms, isControl ? 1 + Math.floor(random.between(0, 4)) : 1),
    light: isControl ? random.between(0.3, 0.8) : random.between(0.15, 0.5),
    dot: isControl && random.next() < 0.6 ? random.between(0.5, 0.85) : 0,
    panel: isControl && random.next() < 0.7 ? random.between(0.01, 0.06) : null,
  };
}

/** Draws a picture with one code of each kind side by side. L_visu is 40 ms. */
export function onePicture(random, changes = {}) {
  const sizes = [random.between(72, 200), random.between(72, 200)];
  const apart = 0.8 * (sizes[0] + sizes[1]) + 10;
  const angle = random.between(-0.3, 0.3) + (random.next() < 0.5 ? 0 : Math.PI);
  const [x, y] = [random.between(0.3, 0.7) * width, random.between(0.35, 0.65) * height];
  const ms = Math.floor(random.between(0, 65536));
  const codes = ['Control', 'Headset'].map((kind, i) => {
    const by = (i - 0.5) * apart;
    const pose = { ...facing(random), ...changes.pose?.(random), x: x + by * Math.cos(angle), y: y + by * Math.sin(angle), side: sizes[i] };
    return { ...codeOf(random, kind, pose, i === 0 ? ms + 40 : ms), kind, size: sizes[i] };
  });
  const shot = {
    width, height, scene: Math.floor(random.between(0, 2 ** 31)), sceneLight: random.between(0.3, 1), codes, blur: random.between(0.4, 1.6),
    motion: [0, 0], glares: [], covers: [], noise: random.between(1, 5), noiseSeed: Math.floor(random.between(0, 2 ** 31)),
  };
  return changes.shot ? changes.shot(shot, random) : shot;
}

const dimmed = (shot, factor) => ({ ...shot, sceneLight: shot.sceneLight * factor, codes: shot.codes.map(code => ({ ...code, light: code.light * factor })) });
const ofControl = (shot, change) => ({ ...shot, codes: shot.codes.map((code, i) => (i === 0 ? { ...code, ...change } : code)) });

/** Conditions of pictures with one code of each kind. */
export const groups = {
  'clean (blur 0.4 to 1 px)': { shot: (shot, random) => ({ ...shot, blur: random.between(0.4, 1) }) },
  'blurred (1.5 to 3 px, motion up to 6 px)': {
    shot: (shot, random) => ({ ...shot, blur: random.between(1.5, 3), motion: [random.between(-4, 4), random.between(-4, 4)] }),
  },
  'tilted (37° to 53°, perspective)': { pose: random => ({ tilt: random.between(0.65, 0.93) }) },
  'dark (6 % to 20 % of the light)': { shot: (shot, random) => dimmed(shot, random.between(0.06, 0.2)) },
  'overexposed (2 to 4 times the light)': { shot: (shot, random) => ofControl(shot, { light: random.between(2, 4) }) },
  'reflection on the code': {
    shot: (shot, random) => {
      const code = random.pick(shot.codes);
      const [px, py] = [0, 1].map(axis => code.corners.reduce((sum, p) => sum + p[axis], 0) / 4);
      const at = middle => middle + random.between(-0.5, 0.5) * code.size;
      return { ...shot, glares: [{ x: at(px), y: at(py), radius: code.size * random.between(0.2, 0.7), light: random.between(0.1, 0.6) }] };
    },
  },
  'red LEDs': { shot: shot => ofControl(shot, { colour: [1, 0.07, 0.03] }) },
};

/** Draws `count` pictures of each group. */
export const groupPictures = (seed, count) =>
  Object.entries(groups).map(([name, changes], i) => {
    const random = randomOf(seed + i);
    return { name, shots: Array.from({ length: count }, () => onePicture(random, changes)) };
  });

/** Objects that hide a part of a second code, from one direction each, or across its middle. */
export const hidings = ['left', 'right', 'top', 'bottom'].flatMap(from => [{ from, by: 'edge' }, { from, by: 'object' }]).concat({ from: 'middle', by: 'object' });

/** Adds a second code of a kind, of which a share is hidden. Returns the picture. */
export function withSecond(random, shot, kind, { from, by }, share, size = random.between(72, 200)) {
  const ms = Math.floor(random.between(0, 65536));
  for (let tries = 0; ; tries++) {
    const pose = { ...facing(random), x: random.between(0.5 * size, width - 0.5 * size), y: random.between(0.5 * size, height - 0.5 * size), side: size };
    const drawn = { ...codeOf(random, kind, pose, ms), kind, size };
    const axis = from === 'left' || from === 'right' || from === 'middle' ? 0 : 1;
    const points = pointsOf(drawn.corners).map(p => p[axis]).sort((a, b) => a - b);
    const at = quantile => points[Math.min(points.length - 1, Math.floor(quantile * points.length))];
    const end = axis === 0 ? width : height;
    const moved = [0, 0];
    let cover;
    if (by === 'edge') moved[axis] = from === 'left' || from === 'top' ? -at(share) : end - at(1 - share);
    else {
      const [first, last] = from === 'middle' ? [at(0.5 - share / 2), at(0.5 + share / 2)] : from === 'left' || from === 'top' ? [points[0] - 8, at(share)] : [at(1 - share), points.at(-1) + 8];
      const across = drawn.corners.map(p => p[1 - axis]);
      const [low, high] = [Math.min(...across) - size * random.between(0.1, 0.4), Math.max(...across) + size * random.between(0.1, 0.4)];
      const box = axis === 0 ? [first, low, last - first, high - low] : [low, first, high - low, last - first];
      cover = { box: box.map(Math.round), light: random.between(0.02, 0.6) };
    }
    const code = { ...drawn, corners: drawn.corners.map(([x, y]) => [x + moved[0], y + moved[1]]) };
    const middle = [0, 1].map(a => code.corners.reduce((sum, p) => sum + p[a], 0) / 4);
    const isFree = shot.codes.every(other => {
      const o = [0, 1].map(a => other.corners.reduce((sum, p) => sum + p[a], 0) / 4);
      return Math.hypot(o[0] - middle[0], o[1] - middle[1]) > 0.85 * (other.size + size);
    });
    if (isFree || tries > 200) return { ...shot, codes: [...shot.codes, code], covers: cover ? [...shot.covers, cover] : shot.covers };
  }
}

/** Draws a picture with one code of each kind and a plate with a lattice of holes, which resembles a code. */
export function perforatedPlate(random) {
  const [at, reach] = [[900, 150], 170];
  const [w, h, turn] = [random.between(90, 160), random.between(110, 190), random.between(-0.9, 0.9)];
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => [
    at[0] + (u * w * Math.cos(turn) - v * h * Math.sin(turn)) / 2, at[1] + (u * w * Math.sin(turn) + v * h * Math.cos(turn)) / 2,
  ]);
  const holes = 2 * Math.floor(random.between(3, 7)) + 1;
  const lit = Array.from({ length: holes * holes }, (_, i) => (Math.floor(i / holes) % 2 && (i % holes) % 2 ? 0 : 1));
  const plate = { corners, lit, light: 0.3, dot: 0, panel: null };
  for (;;) {
    const shot = onePicture(random);
    const isFree = shot.codes.every(code => code.corners.every(([x, y]) => Math.hypot(x - at[0], y - at[1]) > reach));
    if (isFree) return { ...shot, sceneLight: 0.3, codes: [...shot.codes, plate] };
  }
}

/** Returns the codes of a response that are not weak. */
export const strongCodes = ({ codes }) => codes.filter(({ isWeak }) => !isWeak);

/** Returns the largest error of a found code's corners, relative to the side of the drawn code. */
export const cornerError = (corners, drawn) => Math.max(...corners.map(([x, y], i) => Math.hypot(x - drawn.corners[i][0], y - drawn.corners[i][1]))) / drawn.size;

/** Returns whether a response contains a code of the drawn kind whose corners have an error of less than half a cell. */
export const isFound = (answer, drawn) => strongCodes(answer).some(({ kind, corners }) => kind === drawn.kind && cornerError(corners, drawn) < 0.5 / side);

/** Points that are uniformly distributed over a quad. */
function pointsOf([a, b, c, d]) {
  const points = [];
  for (let j = 0; j < 40; j++)
    for (let i = 0; i < 40; i++) {
      const [u, v] = [(i + 0.5) / 40, (j + 0.5) / 40];
      points.push([0, 1].map(k => (1 - v) * ((1 - u) * a[k] + u * b[k]) + v * ((1 - u) * d[k] + u * c[k])));
    }
  return points;
}

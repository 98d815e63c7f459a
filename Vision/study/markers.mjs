// Compares the finder with OpenCV's ArUco and AprilTag markers on rendered pictures of the same squares: `npm run markers`.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { cornerError, groupPictures, isFound } from './pictures.mjs';
import { askAll } from './workers.mjs';

const require = createRequire(import.meta.url);
const cv = await loadedOpenCv();
const { PNG } = require('pngjs');

const [count = 30, seed = 5000] = process.argv.slice(2).map(Number);
/** As in src/opencv.ts: the module itself must not be awaited, because its `then` yields the module again. */
async function loadedOpenCv() {
  const library = require('@techstark/opencv-js');
  if (library instanceof Promise) return { ...(await library), then: undefined };
  if (!library.Mat) await new Promise(ready => { library.onRuntimeInitialized = ready; });
  return { ...library, then: undefined };
}

/** Modules along a side of a square, and of a marker in one of its corners. */
const side = 16;
const markerSide = 6;
/** Modules of the corners of the four markers: top left, top right, bottom right, bottom left. */
const far = side - markerSide;
const places = [[0, 0], [far, 0], [far, far], [0, far]];
const dictionaries = { '4X4_50': cv.DICT_4X4_50, 'AprilTag 16h5': cv.DICT_APRILTAG_16h5 };

/** Returns the modules of a square with four markers, whose dark modules are lit and whose light modules are dark, and with data between them. */
function modulesOf(dictionary, data) {
  const isMarker = (x, y) => places.some(([left, top]) => x >= left - 1 && x <= left + markerSide && y >= top - 1 && y <= top + markerSide);
  const modules = Array.from({ length: side * side }, (_, i) => (isMarker(i % side, Math.floor(i / side)) ? 0 : data[i % data.length] > 0.5 ? 1 : 0));
  places.forEach(([left, top], id) => {
    const marker = new cv.Mat();
    dictionary.generateImageMarker(id, markerSide, marker, 1);
    for (let y = 0; y < markerSide; y++)
      for (let x = 0; x < markerSide; x++) modules[(top + y) * side + left + x] = marker.ucharPtr(y, x)[0] ? 0 : 1;
    marker.delete();
  });
  return modules;
}

const marked = (shot, dictionary) => ({ ...shot, codes: shot.codes.map(code => ({ ...code, lit: modulesOf(dictionary, code.lit), dot: 0 })) });

function greyOf(file) {
  const { width, height, data } = PNG.sync.read(readFileSync(file));
  const grey = new cv.Mat(height, width, cv.CV_8UC1);
  for (let i = 0; i < width * height; i++) grey.data[i] = Math.max(data[4 * i], data[4 * i + 1], data[4 * i + 2]);
  return grey;
}

function detectorOf(dictionary) {
  const parameters = new cv.aruco_DetectorParameters();
  Object.assign(parameters, {
    detectInvertedMarker: true, cornerRefinementMethod: cv.CORNER_REFINE_SUBPIX, adaptiveThreshWinSizeMin: 3, adaptiveThreshWinSizeMax: 53,
    adaptiveThreshWinSizeStep: 10,
  });
  return new cv.aruco_ArucoDetector(dictionary, parameters, new cv.aruco_RefineParameters(10, 3, true));
}

/** Returns the corners of the found markers as { id, corners }. */
function markersIn(grey, detector) {
  const [found, ids] = [new cv.MatVector(), new cv.Mat()];
  detector.detectMarkers(grey, found, ids);
  const markers = Array.from({ length: found.size() }, (_, i) => ({ id: ids.data32S[i], corners: [...found.get(i).data32F] }));
  for (const made of [found, ids]) made.delete();
  return markers;
}

/** Returns the corners of a square that follow from some of its markers, by a homography. */
function squareOf(markers) {
  const at = ({ id }) => [[0, 0], [markerSide, 0], [markerSide, markerSide], [0, markerSide]].flatMap(([x, y]) => [places[id][0] + x, places[id][1] + y]);
  const points = values => cv.matFromArray(values.length / 2, 1, cv.CV_32FC2, values);
  const [from, to, corners, seen] = [points(markers.flatMap(at)), points(markers.flatMap(({ corners }) => corners)), points([0, 0, side, 0, side, side, 0, side]), new cv.Mat()];
  const map = cv.findHomography(from, to);
  if (map.rows === 3) cv.perspectiveTransform(corners, seen, map);
  const square = seen.rows ? [0, 1, 2, 3].map(i => [seen.data32F[2 * i], seen.data32F[2 * i + 1]]) : null;
  for (const made of [from, to, corners, seen, map]) made.delete();
  return square;
}

/** Maximum error of a corner, relative to the side: half a cell of a code. */
const maxError = 1 / 16;

const isNear = ({ corners }, truth) => {
  const middle = [0, 1].map(axis => truth.corners.reduce((sum, p) => sum + p[axis], 0) / 4);
  return Math.hypot(corners[0] - middle[0], corners[1] - middle[1]) < 0.9 * truth.size;
};

const isFoundByMarkers = (markers, truth, needed) => {
  const near = markers.filter(marker => marker.id < 4 && isNear(marker, truth));
  if (near.length < needed) return false;
  const square = squareOf(near);
  return square !== null && cornerError(square, truth) < maxError;
};

const groups = groupPictures(seed, count);
const shots = groups.flatMap(group => group.shots.map(shot => ({ group: group.name, shot })));
const seen = await askAll(shots.map(({ shot }) => ({ shot })));
const results = shots.map(({ group, shot }, i) => ({
  group,
  finder: shot.codes.map(truth => isFound(seen[i], truth)),
}));
const folder = mkdtempSync(join(tmpdir(), 'nowpose-markers-'));
for (const [name, dictionaryId] of Object.entries(dictionaries)) {
  const dictionary = cv.getPredefinedDictionary(dictionaryId);
  const detector = detectorOf(dictionary);
  const files = shots.map((_, i) => join(folder, `${i}.png`));
  await askAll(shots.map(({ shot }, i) => ({ shot: marked(shot, dictionary), to: files[i] })));
  files.forEach((file, i) => {
    const grey = greyOf(file);
    const markers = markersIn(grey, detector);
    for (const [key, needed] of [[name, 1], [`${name}, all four`, 4]]) results[i][key] = shots[i].shot.codes.map(truth => isFoundByMarkers(markers, truth, needed));
    grey.delete();
  });
}
rmSync(folder, { recursive: true });

const methods = ['finder', ...Object.keys(dictionaries).flatMap(name => [name, `${name}, all four`])];
const columns = methods.flatMap(method => [`LEDs: ${method}`, `hologram: ${method}`]);
console.log(`| group of ${count} pictures, seed ${seed} | ${columns.join(' | ')} |`);
console.log(`| --- |${' ---: |'.repeat(columns.length)}`);
const line = (name, chosen) => console.log(`| ${[name, ...methods.flatMap(method => [0, 1].map(code => chosen.filter(result => result[method][code]).length))].join(' | ')} |`);
for (const { name } of groups) line(name, results.filter(({ group }) => group === name));
line(`sum of ${results.length}`, results);
process.exit();

// Worker process of the command line. Reads one request per line from standard input and writes one response per line, in the same order.
import './interrupts';
import { constants, getPriority, setPriority } from 'node:os';
import { createInterface } from 'node:readline';
import { Finder, type Found } from './finder';
import { mirrored, type Grey } from './levels';
import { pictureMessages } from './messages';
import { loaded } from './opencv';
import type { Pattern } from './pattern';
import { readPicture, writePicture } from './pictureFile';
import { take, type Shot } from './render/camera';
import { type Box, type Place, Tracker } from './track';

/** Contains exactly one of: pattern, path of a file, greyscale pixels in Base64, picture to render. The first request contains the pattern. */
interface Request {
  pattern?: Pattern;
  file?: string;
  grey?: { width: number; height: number; data: string };
  shot?: Shot;
  /** Path to which the rendered picture is written. If absent, the picture is searched for codes. */
  to?: string;
  /** Tracks patches instead of searching for codes. The first of these requests contains their boxes. */
  track?: { boxes?: Box[] };
}

type Answer =
  { width: number; height: number; codes: Found[]; isMirrored: boolean } | { places: Place[] } | { error: string } | Record<string, never>;

// Reading pictures uses all cores for minutes. It must not slow down programs that run in real time, such as a gateway. A lower priority is kept,
// because only an administrator may increase it.
if (getPriority() < constants.priority.PRIORITY_BELOW_NORMAL) setPriority(constants.priority.PRIORITY_BELOW_NORMAL);

let finder: Finder;
let tracker: Tracker | undefined;

async function answer(request: Request): Promise<Answer> {
  if (request.pattern) {
    await loaded;
    finder = new Finder(request.pattern);
    return {};
  }
  const picture = await pictureOf(request);
  if (request.to) {
    await writePicture(request.to, picture);
    return {};
  }
  if (request.track) return { places: follow(picture, request.track.boxes) };
  const codes = finder.find(picture);
  const isMirrored = isFitBetter(codes, () => finder.find(mirrored(picture)));
  return { width: picture.width, height: picture.height, codes: isMirrored ? [] : codes, isMirrored };
}

/** Returns whether the mirrored picture contains a clearly better match. A mirrored code matches an upright one in up to 82 % of its steps. */
function isFitBetter(codes: Found[], ofMirrored: () => Found[]): boolean {
  const best = (found: Found[]) => Math.max(0, ...found.map(({ share }) => share));
  return best(codes) < 0.85 && best(ofMirrored()) > best(codes) + 0.1;
}

function follow(picture: Grey, boxes?: Box[]): Place[] {
  if (boxes) {
    tracker?.delete();
    tracker = new Tracker(picture, boxes);
  }
  if (!tracker) throw new Error(pictureMessages.noBoxes);
  return tracker.follow(picture);
}

async function pictureOf({ file, grey, shot }: Request): Promise<Grey> {
  if (file) return readPicture(file);
  if (grey) return { ...grey, data: new Uint8Array(Buffer.from(grey.data, 'base64')) };
  return take(shot!);
}

for await (const line of createInterface({ input: process.stdin })) {
  let answered: Answer;
  try {
    answered = await answer(JSON.parse(line) as Request);
  } catch (error) {
    answered = { error: error instanceof Error ? error.message : String(error) };
  }
  process.stdout.write(JSON.stringify(answered) + '\n');
}

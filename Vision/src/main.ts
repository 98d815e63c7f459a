// What the command line starts: a request per line of standard input, an answer per line of standard output, in that order.
import './interrupts';
import { createInterface } from 'node:readline';
import { Finder, type Found } from './finder';
import type { Grey } from './levels';
import { loaded } from './opencv';
import type { Pattern } from './pattern';
import { readPicture, writePicture } from './pictureFile';
import { take, type Shot } from './render/camera';
import { type Box, type Place, Tracker } from './track';

/** Exactly one of the first four: a file's path, grey bytes in Base64, or a picture to be made; the pattern comes first of all. */
interface Request {
  pattern?: Pattern;
  file?: string;
  grey?: { width: number; height: number; data: string };
  shot?: Shot;
  /** Where a picture that is made goes; without it, it is searched at once. */
  to?: string;
  /** Instead of searching for codes: patches are followed, from the picture on that brings boxes. */
  track?: { boxes?: Box[] };
}

type Answer = { width: number; height: number; codes: Found[] } | { places: Place[] } | { error: string } | Record<string, never>;

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
  return { width: picture.width, height: picture.height, codes: finder.find(picture) };
}

function follow(picture: Grey, boxes?: Box[]): Place[] {
  if (boxes) {
    tracker?.delete();
    tracker = new Tracker(picture, boxes);
  }
  if (!tracker) throw new Error('the first picture to be tracked brings no boxes');
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
